"""The kernels of a three-state family as expression graphs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.steady_state.towers import rational
from gainproof.derive.three_state import inverses, kernel_derivatives, kernel_forms
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.kernel_basis import UNIT, KernelBasis, kernel_basis
from gainproof.derive.three_state.kernel_forms import Noise
from gainproof.derive.three_state.names import DELTA, ETA, INDEX, XI

FormsOf = Callable[[KernelBasis, Noise], Mapping[str, Any]]

INDEX_KERNELS: Mapping[str, tuple[FormsOf, ...]] = {
    "gains": (kernel_forms.gains,),
    "gain_derivatives": (kernel_derivatives.gain_derivatives,),
    "gains_with_derivatives": (kernel_forms.gains, kernel_derivatives.gain_derivatives),
    "predictor_gains": (kernel_forms.predictor_gains,),
    "predictor_gain_derivatives": (kernel_derivatives.predictor_gain_derivatives,),
    "innovation_deviation": (kernel_forms.innovation,),
    "predicted_covariance": (kernel_forms.predicted_covariance,),
    "predicted_covariance_derivatives": (kernel_derivatives.predicted_covariance_derivatives,),
    "updated_covariance": (kernel_forms.updated_covariance,),
}
NAMED = {
    "position": real("predictor_position"),
    "velocity": real("predictor_velocity"),
    "acceleration": real("gamma"),
}


def kernel_graphs(c: Context) -> dict[str, Graph]:
    """Graphs by the names of their kernels."""
    graphs = {name: _index_graph(c, parts) for name, parts in INDEX_KERNELS.items()}
    if c.spectrum.rational_in_root:
        graphs |= {
            "index_from_alpha": _alpha_graph(inverses.index_from_alpha),
            "gains_from_alpha": _alpha_graph(inverses.gains_from_alpha),
        }
    return graphs


def kernel_roots(c: Context, kernel: str) -> Mapping[str, sp.Expr]:
    """Tower values of the named square roots and of the fixed point.

    The roots b and c stand in every start, which proves nothing, and in what holds xi - (1 + b).
    """
    r, k = real("fourth_root"), c.constants
    return {
        **({"root_b": k.b, "root_c": k.c} if kernel == "updated_covariance" else {}),
        "p": r**2,
        "r": r,
        "c_scaled": rational(UNIT) * DELTA * r**2 / 8,
        "x": XI * r / 2,
        "e": ETA * r**2 / 4,
        "w": real("w"),
    }


def meant(kernel: str, output: str) -> sp.Expr:
    """What an output of a kernel stands for."""
    if output.startswith("d_"):
        return sp.Derivative(real(output.removeprefix("d_")), INDEX)
    value = NAMED.get(output, real(output))
    if kernel.endswith("_derivatives") and kernel != "gains_with_derivatives":
        return sp.Derivative(value, INDEX)
    return value


def _index_graph(c: Context, parts: tuple[FormsOf, ...]) -> Graph:
    """The graph of the outputs of one or more forms; a name met again is prefixed d_."""
    builder = GraphBuilder()
    basis = kernel_basis(builder, c.spectrum)
    noise = _noise(c)
    outputs: dict[str, Any] = {}
    for part in parts:
        for key, value in part(basis, noise).items():
            outputs[f"d_{key}" if key in outputs else key] = value
    return builder.graph(outputs, basis.names)


def _noise(c: Context) -> Noise:
    q = c.model.process_noise.applyfunc(sp.Rational)
    rate = q[1, 1] - q[0, 1] - q[0, 2] / 2 - q[1, 2] / 4
    return Noise(*(Fraction(str(entry)) for entry in (q[0, 2], q[1, 2], rate)))


def _alpha_graph(form: Callable[[Any, Any], Mapping[str, Any]]) -> Graph:
    builder = GraphBuilder()
    alpha = builder.symbol("alpha")
    w = builder.sqrt(1 - alpha)
    return builder.graph(dict(form(alpha, w)), {"w": w})
