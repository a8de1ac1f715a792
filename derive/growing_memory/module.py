"""The kernels of a least-squares fit: graphs, and the forms of textbooks."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.growing_memory.fit import GAIN_NAMES, Fit, K, entry_names
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node


def kernel_graphs(f: Fit) -> dict[str, Graph]:
    """Graphs of the gain and of both covariances, over the sample number."""
    graphs = {
        "gains": _graph(dict(zip(GAIN_NAMES, f.gain, strict=False)), f.degree),
    }
    for kernel, matrix, first in (
        ("updated_covariance", f.covariance, f.degree),
        ("predicted_covariance", f.predicted, f.degree + 1),
    ):
        names = entry_names(kernel.removesuffix("_covariance"), f.size)
        entries = {names[i][j]: matrix[i, j] for i in range(f.size) for j in range(i, f.size)}
        graphs[kernel] = _graph(entries, first)
    return graphs


def _graph(entries: dict[str, sp.Expr], first: int) -> Graph:
    builder = GraphBuilder()
    number = builder.symbol("sample_number")
    return builder.graph(
        {name: _rational(builder, number, value, first) for name, value in entries.items()}
    )


def _rational(builder: GraphBuilder, number: Node, value: sp.Expr, first: int) -> Node:
    """The numerator over the denominator's factors two at a time: k^2 is in float32's range."""
    top, bottom = sp.fraction(sp.together(value))
    (top_constant, above), (bottom_constant, below) = (
        _factors(number, part, first) for part in (top, bottom)
    )
    constant = builder.number(str(sp.Rational(top_constant, bottom_constant)))
    result = constant if not above else _product(above)
    if above and top_constant != bottom_constant:
        result = result * constant
    for position in range(0, len(below), 2):
        result = result / _product(below[position : position + 2])
    return result


def _product(factors: list[Node]) -> Node:
    result, *rest = factors
    for factor in rest:
        result = result * factor
    return result


def _factors(number: Node, value: sp.Expr, first: int) -> tuple[sp.Rational, list[Node]]:
    constant, factors = sp.factor_list(sp.Poly(value, K))
    return constant, [
        node for factor, power in factors for node in [_horner(number, factor, first)] * power
    ]


def _horner(number: Node, factor: sp.Poly, first: int) -> Node:
    """A factor without minus signs: in k if it has none, linear as k - c, else in k - first."""
    coefficients = [int(entry) for entry in factor.all_coeffs()]
    base: Node = number
    if len(coefficients) > 2 and min(coefficients) < 0:
        shifted = sp.Poly(factor.as_expr().subs(K, K + first), K)
        coefficients, base = [int(entry) for entry in shifted.all_coeffs()], number - first
        if min(coefficients) < 0:
            raise ArithmeticError(f"no form without subtraction for {factor}")
    lead, *rest = coefficients
    result = base if lead == 1 else base * lead
    for position, entry in enumerate(rest):
        if position:
            result = result * base
        if entry:
            result = result + entry if entry > 0 else result - (-entry)
    return result


def textbook_forms(f: Fit) -> dict[str, dict[str, sp.Expr]]:
    """The expressions that the kernels evaluate, over the sample number."""
    number = {K: real("sample_number")}
    forms: dict[str, dict[str, sp.Expr]] = {"gains": dict(zip(GAIN_NAMES, f.gain, strict=False))}
    for kernel, matrix in (("updated", f.covariance), ("predicted", f.predicted)):
        names = entry_names(kernel, f.size)
        forms[f"{kernel}_covariance"] = {
            names[i][j]: matrix[i, j] for i in range(f.size) for j in range(i, f.size)
        }
    return {
        kernel: {output: sp.sympify(value).subs(number) for output, value in entries.items()}
        for kernel, entries in forms.items()
    }
