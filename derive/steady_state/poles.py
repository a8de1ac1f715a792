"""Closed-loop poles in forms that keep every digit relative to their modulus.

z = (2 kappa - 1 -+ sqrt(1 + e - 4 kappa))/(4 sigma/Lambda). Both differences are rewritten as
differences between the index and a constant: 4 kappa^2 - 1 = (1 - e)(L0^2 - Lambda^2)/Lambda^2 with
L0 = 4/sqrt(1 - e), and the radicand is (1 - e)^2 (Lambda^2 - L1^2)/(4 rho^2 Lambda^2) with
L1 = 8/(1 - e), beyond which the poles are real. For e = 1 they never are.
"""

from __future__ import annotations

from typing import Any

from gainproof.derive.steady_state.forms import Basis


def centre(x: Basis, turning: Any) -> Any:
    """(2 kappa - 1) Lambda/(4 sigma), the mean of the poles; `turning` is L0 (unused for e = 1)."""
    # (1/2 + kappa) Lambda, times the unit
    size = x.index * (x.kappa + x.unit / 2)
    if x.e == 1:
        return x.inverse_deviation() / (size * (1 / (2 * x.unit)))
    first = (turning / 2 - x.index / 2) / size
    second = (turning / 2 + x.index / 2) * x.inverse_deviation()
    return (first * second) * ((1 - x.e) * x.unit / 2)


def half_width(x: Basis, below: Any, above: Any) -> Any:
    """Half the distance of the poles.

    `below` and `above` are half the roots of |L1 - Lambda| and of L1 + Lambda.
    """
    if x.e == 1:
        return (x.inverse_deviation() / x.rho) * x.unit
    width = (below / x.rho) * (above * x.inverse_deviation())
    return width * ((1 - x.e) * x.unit / 2)
