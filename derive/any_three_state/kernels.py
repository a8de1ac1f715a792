"""The kernels of a three-state model as expression graphs of the index and the parameters."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import sympy as sp

from gainproof.derive.any_three_state.basis import Basis, symbolic_basis
from gainproof.derive.any_three_state.model_numbers import Shape
from gainproof.derive.any_three_state.quantities import ValuesOf
from gainproof.derive.any_two_state.kernel_numbers import Numbers
from gainproof.derive.any_two_state.kernels import Made, graph_of, plain_root
from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.printer.nested_roots import nested_fixed_point


def made(shape: Shape, parts: ValuesOf) -> Made:
    """The graph. Raises ModelError, naming the reason, where a form is not found."""
    builder = GraphBuilder()
    basis, names = graph_basis(builder, shape)
    return graph_of(builder, names, parts(basis), parts(symbolic_basis(shape)))


def graph_basis(builder: GraphBuilder, shape: Shape) -> tuple[Basis, dict[str, Node]]:
    """The inputs and the roots made from them as nodes, with their names."""
    index = builder.symbol("tracking_index")
    number = Numbers(builder, shape)
    names: dict[str, Node] = {}
    blank = Basis(shape, index, (None, None, None, None), number)
    first, last = (_end_root(blank, builder, names, k) for k in (0, 3))
    one, two = (
        blank.term(shape.still[k]) + blank.term(shape.shaken[k], blank.area) for k in (1, 2)
    )
    near, far = (builder.number(end) if isinstance(end, Fraction) else end for end in (first, last))
    names["d1"], names["d2"] = nested_fixed_point((one.plus, two.plus), (near * 2, far * 2))
    return Basis(shape, index, (first, names["d1"], names["d2"], last), number), names


def _end_root(x: Basis, builder: GraphBuilder, names: dict[str, Node], number: int) -> Any:
    """d0 or d3."""
    own, noise = x.shape.open_loop[number], x.shape.shaken[number]
    if x.shape.sign(noise) == 0:
        size = x.term(own)
        return size.plus if size.minus is None else size.minus
    if x.shape.sign(own) != 0:
        inner = x.term(x.shape.still[number]) + x.term(noise, x.area)
        names[f"d{number}"] = builder.sqrt(inner.plus)
        return names[f"d{number}"]
    square = plain_root(x.shape, noise)
    if square is not None:
        return x.term(square, x.index).plus
    root = f"root_n{number}"
    names[root] = builder.sqrt(x.term(noise).plus)
    return names[root] * x.index


def kernel_roots(known: Mapping[str, sp.Expr]) -> dict[str, sp.Expr]:
    """Tower values of the roots in kernels."""
    return {**known, **{f"d{k}": sp.Symbol(f"d{k}", real=True) for k in range(4)}}
