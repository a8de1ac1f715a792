"""Bounds as data: they come back bit for bit, and rest on what they are said to rest on."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction

import pytest
from one_of_each import cases

from gainproof.derive.printer.bound import OutputBound
from gainproof.derive.printer.bound_data import bounds_from, identity, plain
from gainproof.derive.printer.canonical_json import canonical_json
from gainproof.derive.printer.generated_files import module_files
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.kernel import Input, Kernel, Output, Requirement, closed
from gainproof.derive.printer.lost_digits import with_losses
from gainproof.derive.printer.module_bounds import groups, prove_all
from gainproof.subjects.deriving import build

SUBJECTS = ["random-acceleration", "filter-step", "random-velocity", "polar-coordinates"]


@pytest.mark.parametrize("name", cases(SUBJECTS, SUBJECTS[:2].__contains__))
def test_bounds_come_back_as_they_were_and_print_the_same_files(name: str) -> None:
    """One with differences and places where digits are lost, one of signed inputs."""
    module = build(name).module
    pairs = zip(module.kernels, prove_all(module.kernels), strict=True)
    bounds = [with_losses(*pair) for pair in pairs]
    losses = [o.loss for pair in bounds for bound in pair for o in bound.outputs if o.loss]
    assert losses
    told = {k.name: plain(b) for k, b in zip(module.kernels, bounds, strict=True)}
    data = json.loads(canonical_json(told))
    again = [bounds_from(kernel, data[kernel.name]) for kernel in module.kernels]
    # of floats 0.0 == -0.0 and 1 == 1.0: their texts are compared too
    assert again == bounds
    assert repr(again) == repr(bounds)
    assert module_files(module, {}, again) == module_files(module, {}, bounds)


def quotient() -> Kernel:
    b = GraphBuilder()
    x, y = b.symbol("x"), b.symbol("y")
    graph = b.graph({"ratio": (x + 1) / (y + 2), "scale": x + 3}, {"sum": y + 2})
    inputs = (closed("x", "a length", "1", "10"), closed("y", "a width", "1/2", "20"))
    outputs = (Output("ratio", "a quotient"),)
    return Kernel("quotient", "Ratio", "A ratio.", (), inputs, outputs, graph, "nowhere")


def test_a_bound_that_is_no_hundredth_and_amplifications_come_back() -> None:
    kernel = quotient()
    pair = prove_all([kernel])[0]
    odd = OutputBound("ratio", Fraction(1, 3), ((1.0, 2.0), (0.1, 1e-310)), {"d": 1.1}, 5e-324)
    pair = tuple(replace(bound, outputs=(odd,)) for bound in pair)
    assert bounds_from(kernel, json.loads(json.dumps(plain(pair)))) == pair


def test_data_of_another_kernel_are_refused() -> None:
    kernel = quotient()
    data = json.loads(json.dumps(plain(prove_all([kernel])[0])))
    other = replace(kernel, outputs=(replace(kernel.outputs[0], name="scale"),))
    with pytest.raises(ValueError, match="other outputs"):
        bounds_from(other, data)
    with pytest.raises(KeyError):
        bounds_from(kernel, {"float64": data["float64"]})


def test_words_are_no_part_of_what_bounds_rest_on() -> None:
    kernel = quotient()
    told = replace(
        kernel,
        name="other",
        summary="Other words.",
        source="somewhere",
        inputs=tuple(replace(each, meaning="a time") for each in kernel.inputs),
        outputs=(Output("ratio", "other words", scale_meaning="words"),),
    )
    assert identity([told]) == identity([kernel])


def altered() -> dict[str, Kernel]:
    kernel = quotient()
    b = GraphBuilder()
    x, y = b.symbol("x"), b.symbol("y")
    graph = b.graph({"ratio": (x + 1) / (y + 3), "scale": x + 3}, {"sum": y + 3})
    first, second = kernel.inputs
    (output,) = kernel.outputs
    required = Requirement("sum", "a sum", "1", "1")
    return {
        "graph": replace(kernel, graph=graph),
        "names": replace(kernel, graph={**kernel.graph, "names": {"sum": 0}}),
        "domain": replace(kernel, inputs=(replace(first, upper="11"), second)),
        "an open end": replace(kernel, inputs=(first, replace(second, upper_open=True))),
        "float32": replace(kernel, inputs=(replace(first, single=("1", "2")), second)),
        "an input's name": replace(kernel, inputs=(Input("z", "a length", "1", "10"), second)),
        "scale": replace(kernel, outputs=(replace(output, relative_to="scale"),)),
        "terms": replace(kernel, outputs=(replace(output, by_terms=True),)),
        "cancellations": replace(kernel, cancellations={"sum": "meant"}),
        "requirements": replace(kernel, requirements=(required,)),
        "search": replace(kernel, search=2),
        "the names that are explained": replace(kernel, equations=("sum = y + 2",)),
    }


@pytest.mark.parametrize("what", altered())
def test_bounds_rest_on(what: str) -> None:
    assert identity([altered()[what]]) != identity([quotient()])


def test_bounds_rest_on_what_is_proved_with_them() -> None:
    """Kernels of the same one input are walked together, and each has the finer boxes of all."""
    b = GraphBuilder()
    x = b.symbol("x")
    given = (Input("x", "a number", "0"),)
    first, second = (
        Kernel(name, "R", "One.", (), given, (Output("y", "y"),), b.graph({"y": y}), "nowhere")
        for name, y in (("one", x + 1), ("two", b.sqrt(x + 2)))
    )
    assert groups([first, quotient(), second]) == [[1], [0, 2]]
    alone = identity([first])
    assert len({alone, identity([first, second]), identity([second, first])}) == 3
