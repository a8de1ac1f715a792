"""The printed module of a least-squares fit."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.expression import real
from gainproof.derive.growing_memory.fit import GAIN_NAMES, Fit, K, entry_names
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output

LARGEST = 2**53
PLACES = ("position", "velocity", "acceleration")


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


def kernel_module(f: Fit, name: str, title: str, graphs: dict[str, Graph]) -> Module:
    """The module of one degree."""
    kernels = (_kernel(f, name, kernel, graph) for kernel, graph in graphs.items())
    return catalogue_module(name, f"{title}: gains by sample number", kernels)


SUMMARIES = {
    "gains": "Gain of the newest sample in a least-squares fit to samples 0..k.",
    "updated_covariance": "Covariance of the fit at sample k, in units of sigma_v^2 and T.",
    "predicted_covariance": "Covariance of the fit to samples 0..k-1, predicted to sample k.",
}


def _kernel(f: Fit, name: str, kernel: str, graph: Graph) -> Kernel:
    first = f.degree + (kernel == "predicted_covariance")
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=SUMMARIES[kernel],
        equations=tuple(
            f"{entry} = {value}" for entry, value in zip(GAIN_NAMES, f.gain, strict=False)
        )
        if kernel == "gains"
        else ("inverse of the sum of the squared rows (1, -j, j^2/2, ...)",),
        inputs=(
            Input(
                "sample_number",
                "number k of the newest sample, counted from 0",
                str(first),
                str(LARGEST),
                lower_open=False,
                upper_open=False,
                integer=True,
            ),
        ),
        outputs=tuple(Output(entry, _meaning(entry)) for entry in graph["outputs"]),
        graph=graph,
        source=f"derivation {name}",
    )


def _meaning(entry: str) -> str:
    if entry in GAIN_NAMES:
        order = GAIN_NAMES.index(entry)
        return f"{PLACES[order]} gain" + (f" times T^{order}" if order else "")
    kind, digits = entry.split("_")
    i, j = (PLACES[int(digit) - 1] for digit in digits)
    power = sum(int(digit) for digit in digits) - 2
    what = f"variance of the {kind} {i}" if i == j else f"covariance of {kind} {i} and {j}"
    return f"{what} times T^{power}/sigma_v^2" if power else f"{what} over sigma_v^2"
