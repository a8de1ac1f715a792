"""Random kernels of signed inputs: no measured error is above the bound printed for them."""

from __future__ import annotations

import random
from dataclasses import replace

import flint
import numpy as np
import pytest
from graph_kernels import module_of
from signed_graphs import with_terms

from gainproof.derive.printer.bound import KernelBound, prove
from gainproof.derive.printer.formats import FLOAT32, FLOAT64, Format
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.printer.kernel import Kernel, Output, closed, signed
from gainproof.derive.printer.step_ranges import PrintingError

INPUTS = (
    signed("x", "an argument", "1e-60", "1e60", ("1e-12", "1e9")),
    signed("z", "an argument", "1e-10", "1e10", ("1e-6", "1e6")),
    closed("w", "an argument", "1e-30", "1e30", ("1e-9", "1e9")),
    signed("t", "an angle", "1e-30", "6.2832", ("1e-15", "6.2832")),
)


def made(seed: int) -> Graph:
    """A graph of a dozen operations."""
    chooser, b = random.Random(seed), GraphBuilder()
    x, z, w, t = (b.symbol(name) for name in "xzwt")
    known: list[Node] = [x, z, w, t, b.call("sin", t), b.call("cos", t)]
    for _ in range(chooser.randint(3, 12)):
        one, other = chooser.choice(known), chooser.choice(known)
        kind = chooser.choice(["mul", "mul", "add", "sub", "div", "root", "atan2", "exp", "half"])
        match kind:
            case "mul":
                known.append(one * other)
            case "add":
                known.append(one + other)
            case "sub":
                known.append(one - other)
            case "div":
                known.append(one / chooser.choice([w, w + z * z, b.sqrt(w * w + x * x)]))
            case "root":
                known.append(b.sqrt(one * one + (other * other + w)))
            case "atan2":
                known.append(b.call("atan2", one, other))
            case "exp":
                known.append(b.call(chooser.choice(["exp", "expm1"]), -(one * one)))
            case "half":
                known.append(-one / 2)
    return b.graph({"y": known[-1] * chooser.choice(known)})


def proved(graph: Graph, form: Format) -> tuple[Kernel, KernelBound] | None:
    """The kernel with its bound, if it has one."""
    for by_terms in (False, True):
        output = Output("y", "a value", by_terms=by_terms)
        made = Kernel("kernel", "Result", "Fuzz.", ("y",), INPUTS, (output,), graph, "this test")
        try:
            return made, prove(made, form)
        except PrintingError:
            continue
    return None


@pytest.mark.parametrize("form", [FLOAT64, FLOAT32], ids=lambda form: form.name)
@pytest.mark.parametrize("seeds", [60, pytest.param(3000, marks=pytest.mark.thorough)])
def test_no_error_is_above_its_bound(form: Format, seeds: int) -> None:
    count, cancelling, strays = 0, 0, 0
    for seed in range(seeds):
        graph = made(seed)
        found = proved(graph, form)
        other = proved(graph, FLOAT64 if form is FLOAT32 else FLOAT32)
        if found is None or other is None:
            continue
        kernel, bound = found
        if kernel.outputs[0].by_terms != other[0].outputs[0].by_terms:
            continue
        (stated,) = bound.outputs
        count += 1
        cancelling += kernel.outputs[0].by_terms
        strays += stated.beside > 0
        measure(kernel, bound, form, seed)
    assert count > seeds / 6
    assert cancelling
    assert strays or form is FLOAT64


def measure(kernel: Kernel, bound: KernelBound, form: Format, seed: int) -> None:
    """At random points of the whole domain, at its ends and at zeros."""
    generator = np.random.default_rng(seed)
    rows = []
    for given, (low, high) in zip(kernel.inputs, bound.inputs, strict=True):
        wide = np.exp(generator.uniform(np.log(low), np.log(high), 40))
        usual = generator.uniform(0.1, min(5, high), 40)
        ends = generator.choice([low, high], 40)
        row = np.choose(generator.choice(3, 40, p=[0.4, 0.4, 0.2]), [wide, usual, ends])
        row = row.astype(form.name).clip(
            np.dtype(form.name).type(low), np.dtype(form.name).type(high)
        )
        if given.signed:
            row = row * generator.choice([-1, 1, 1, 0], 40).astype(form.name) + 0
        rows.append(row)
    used = {str(node[1]) for node in kernel.graph["nodes"] if node[0] == "symbol"}
    kept = [at for at, given in enumerate(kernel.inputs) if given.name in used]
    kernel = replace(kernel, inputs=tuple(kernel.inputs[at] for at in kept))
    if len(kept) < 2:
        return
    (computed,) = module_of(kernel)["kernel"](*(rows[at] for at in kept))
    (stated,) = bound.outputs
    for at in range(40):
        place = {given.name: float(row[at]) for given, row in zip(INPUTS, rows, strict=True)}
        exact, terms = with_terms(kernel.graph, place)["y"]
        if not abs(exact.rad()) <= terms * 2.0**-200:  # an angle that balls leave undecided
            continue
        with flint.ctx.workprec(400):
            error = abs(flint.arb(float(computed[at])) - exact)
            scale = terms if kernel.outputs[0].by_terms else abs(exact)
            room = scale * float(stated.bound) * form.epsilon + stated.beside
            small = error <= flint.arb(2) ** -300 * terms
            assert error <= room or small, (seed, place, float(computed[at]), exact.str(20))
