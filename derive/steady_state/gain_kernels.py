"""The gains as nodes of a graph, in the forms of `gain_forms`."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.steady_state import gain_forms
from gainproof.derive.steady_state.forms import times
from gainproof.derive.steady_state.gain_forms import RAISED, SWITCH, UNIT, Pair
from gainproof.derive.steady_state.kernels import Names, NodesOf, graph_basis

CHOICES = ("index_or_switch", "four_or_less")
LAST = Fraction(4, RAISED)


def gains(builder: GraphBuilder, e: Fraction, n: Fraction) -> tuple[Mapping[str, Any], Names]:
    """Filter gain: alpha and beta."""
    if e == 0:
        return _undamped(builder, n)
    pair, names = _pair(builder, e)
    names["alpha_raised"] = builder.sqrt(pair.alpha_square)
    return {"alpha": names["alpha_raised"] * LAST, "beta": pair.beta}, names


def predictor_gains(
    builder: GraphBuilder, e: Fraction, n: Fraction
) -> tuple[Mapping[str, Any], Names]:
    """Predictor gain F K: the sum of both gains, and beta."""
    if e == 1:
        pair, names = _pair(builder, e)
        names["position_raised"] = builder.sqrt(pair.position_square)
        return {"position": names["position_raised"] * LAST, "velocity": pair.beta}, names
    both, names = gains(builder, e, n)
    return {"position": both["alpha"] + both["beta"], "velocity": both["beta"]}, names


GAINS, PREDICTOR_GAINS = NodesOf(gains), NodesOf(predictor_gains)


def _undamped(builder: GraphBuilder, n: Fraction) -> tuple[Mapping[str, Any], Names]:
    """e = 0: kappa is a quotient, and no root of an index squared is needed."""
    basis, names = graph_basis(builder, Fraction(0), n)
    square = basis.kappa + basis.unit / 4
    names["alpha_raised"] = builder.sqrt(gain_forms.undamped_alpha_square(basis, square))
    outputs = {"alpha": names["alpha_raised"] * LAST, "beta": gain_forms.undamped_beta(basis)}
    return outputs, names


def _pair(builder: GraphBuilder, e: Fraction) -> tuple[Pair, dict[str, Node]]:
    """Lambda and 4 as they are below SWITCH, times SWITCH/Lambda from there on."""
    index = builder.symbol("tracking_index")
    a = builder.select(index, SWITCH, index * UNIT, SWITCH * UNIT)
    b = builder.select(index, SWITCH, 4 * UNIT, (4 * SWITCH * UNIT) / index)
    eta = builder.sqrt(b * b + times(e, a * a))
    ratio = builder.sqrt(a * gain_forms.square_of_ratio(a, eta, e))
    names = {CHOICES[0]: a, CHOICES[1]: b, "eta_scaled": eta, "ratio_scaled": ratio}
    return Pair(a, eta, ratio, e), names
