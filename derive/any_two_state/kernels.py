"""The kernels of a two-state model as expression graphs of the index and the parameters."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp

from gainproof.derive.algebra.leading_elements import square_root
from gainproof.derive.any_two_state import covariance_forms, curvature, derivatives, forms
from gainproof.derive.any_two_state.basis import Basis
from gainproof.derive.any_two_state.kernel_numbers import Numbers
from gainproof.derive.any_two_state.model_numbers import MeasuredFirst, Shape
from gainproof.derive.any_two_state.names import INDEX
from gainproof.derive.any_two_state.root_excess import rises
from gainproof.derive.any_two_state.signed_values import Signed
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node

FormsOf = Callable[[Basis], Mapping[str, Signed]]
SCALE = "_scale"
"""An output that is a difference is measured by the sum of its parts: its name with this."""

KERNELS: Mapping[str, FormsOf] = {
    "gains": forms.gains,
    "predicted_covariance": covariance_forms.predicted_covariance,
    "updated_covariance": covariance_forms.updated_covariance,
    "gain_derivatives": derivatives.gains,
    "gain_second_derivatives": curvature.gains,
}


@dataclass(frozen=True)
class Made:
    """A kernel's graph, and what each output stands for."""

    graph: Graph
    values: Mapping[str, Signed]


def made(shape: Shape, parts: FormsOf) -> Made:
    """The graph. Raises ModelError, naming the reason, where a form is not found."""
    builder = GraphBuilder()
    basis, names = graph_basis(builder, shape)
    return graph_of(builder, names, parts(basis), parts(symbolic_basis(shape)))


def graph_of(
    builder: GraphBuilder,
    names: Mapping[str, Node],
    values: Mapping[str, Signed],
    symbolic: Mapping[str, Signed],
) -> Made:
    """The graph of nodes as values, and what they stand for; values that vanish are left out."""
    outputs: dict[str, Any] = {}
    scales: dict[str, Any] = {}
    named = dict(names)
    for name, value in values.items():
        if value.is_zero:
            continue
        outputs[name] = value.value
        if value.cancels:
            named[difference(name)] = outputs[name]
            scales[name + SCALE] = value.scale
    return Made(builder.graph(outputs | scales, named), symbolic)


def difference(output: str) -> str:
    """The name of the difference that is an output."""
    return f"{output}_difference"


def symbolic_basis(shape: Shape) -> Basis:
    """The basis over the named quantities."""
    roots = (sp.Symbol("d0", real=True), sp.Symbol("d1", real=True), sp.Symbol("d2", real=True))
    return Basis(shape, INDEX, roots, lambda entry: entry)


def graph_basis(builder: GraphBuilder, shape: Shape) -> tuple[Basis, dict[str, Node]]:
    """The inputs and the roots made from them as nodes, with their names."""
    index = builder.symbol("tracking_index")
    number = Numbers(builder, shape)
    names: dict[str, Node] = {}
    blank = Basis(shape, index, (None, None, None), number)
    first = graph_end_root(blank, builder, names, 0)
    last = graph_end_root(blank, builder, names, 2)
    half = Basis(shape, index, (first, None, last), number)
    _, rise, _ = rises(half)
    middle = (half.signed(sp.factor(shape.open_loop[1] ** 2)) + rise).plus
    names["d1"] = builder.sqrt(middle)
    return Basis(shape, index, (first, names["d1"], last), number), names


def graph_end_root(x: Basis, builder: GraphBuilder, names: dict[str, Node], number: int) -> Any:
    """d0 or d2."""
    own, noise = x.shape.open_loop[number], x.shape.noise_ends[number // 2]
    if noise == 0:
        size = x.signed(own)
        return size.plus if size.minus is None else size.minus
    if own != 0:
        names[f"d{number}"] = builder.sqrt((x.signed(own**2) + x.term(noise, x.area)).plus)
        return names[f"d{number}"]
    square = plain_root(x.shape, noise)
    if square is not None:
        return x.term(square, x.index).plus
    root = f"root_n{number // 2}"
    names[root] = builder.sqrt(x.signed(noise).plus)
    return names[root] * x.index


def plain_root(shape: MeasuredFirst, noise: sp.Expr) -> sp.Expr | None:
    """The positive root of a number of the model where it is rational in the parameters."""
    top, bottom = (square_root(part) for part in sp.fraction(sp.together(noise)))
    if top[1] != 1 or bottom[1] != 1:
        return None
    found = sp.factor(top[0] / bottom[0])
    return found if shape.sign(found) > 0 else -found


def known_values(values: Mapping[str, Signed]) -> dict[str, sp.Expr]:
    """What each output stands for, scales included, as expressions over the named quantities."""
    found: dict[str, sp.Expr] = {}
    for name, value in values.items():
        if value.is_zero:
            continue
        found[name] = value.value
        if value.cancels:
            found[name + SCALE] = value.scale
    return found
