"""Closed-loop poles in forms that keep every digit relative to their modulus.

z = (2h - p -+ sqrt(p ((1 + e) p - 4 h)))/(2 m). Both differences are rewritten as differences
between the index and a constant: 2h - p = (1 - e)(L0 - Lambda)(L0 + Lambda)/(Lambda (2h + p)) with
L0 = 4/sqrt(1 - e), and the radicand is (1 - e)^2 (Lambda - L1)(Lambda + L1)/(4 s^2) with
L1 = 8/(1 - e), beyond which the poles are real. For e = 1 they never are.
"""

from __future__ import annotations

from typing import Any

from gainproof.derive.steady_state.forms import Basis, times


def centre(x: Basis, turning: Any) -> Any:
    """(2h - p)/(2 m), the mean of the poles; `turning` is L0 (unused for e = 1)."""
    if x.e == 1:
        return x.inverse_deviation / (x.half * x.ends)
    first = (turning / 2 - x.index / 2) / x.ends
    second = ((turning / 2 + x.index / 2) / x.m) / x.index
    return times(1 - x.e, first * second)


def half_width(x: Basis, below: Any, above: Any) -> Any:
    """Half the distance of the poles.

    `below` and `above` are half the roots of |L1 - Lambda| and of L1 + Lambda.
    """
    if x.e == 1:
        return (2 / x.m) / x.s
    return times(1 - x.e, (below / x.s) * (above / x.m))
