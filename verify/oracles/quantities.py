"""The enclosed steady state under the names that the field gives to its entries.

Names only: every number comes from an enclosure. Gains are alpha, beta, gamma (filter gain) and
position, velocity, acceleration (predictor gain F K); covariances are predicted_ij and
updated_ij with i <= j counted from 1. In units T = R = 1, measured position first.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import flint

from gainproof.verify.oracles.ball import Enclosure
from gainproof.verify.oracles.matrices import Matrix
from gainproof.verify.oracles.state_space import SteadyState

FILTER = ("alpha", "beta", "gamma")
PREDICTOR = ("position", "velocity", "acceleration")


@dataclass(frozen=True)
class Pole:
    """A closed-loop pole in real balls, and its modulus."""

    real: flint.arb
    imaginary: flint.arb
    modulus: flint.arb


def values(found: Enclosure) -> Mapping[str, flint.arb]:
    """Gains and covariances by name."""
    return named(found.state, found.predictor_gain)


def slopes(found: Enclosure) -> Mapping[str, flint.arb]:
    """Their derivatives with respect to the tracking index, under the same names."""
    return named(found.slope, found.predictor_slope)


def poles(found: Enclosure) -> tuple[Pole, ...]:
    """The poles, a complex one with positive imaginary part before its partner, else the larger
    modulus first.
    """
    with flint.ctx.workprec(found.bits):
        listed = [Pole(pole.real, pole.imag, abs(pole)) for pole in found.poles]

    def order(pole: Pole) -> tuple[float, float]:
        return -float(pole.modulus.mid()), -float(pole.imaginary.mid())

    if any(pole.imaginary != 0 for pole in listed):
        # partners have one modulus, which balls cannot order
        return tuple(sorted(listed, key=lambda pole: -float(pole.imaginary.mid())))
    return tuple(sorted(listed, key=order))


def named(state: SteadyState, predictor_gain: Matrix) -> dict[str, flint.arb]:
    """Gains and covariances of a state, or of a derivative of one, by name."""
    found = {name: row[0] for name, row in zip(FILTER, state.gain, strict=False)}
    found |= {name: row[0] for name, row in zip(PREDICTOR, predictor_gain, strict=False)}
    for kind, rows in (("predicted", state.predicted), ("updated", state.updated)):
        for i, row in enumerate(rows):
            found |= {f"{kind}_{i + 1}{j + 1}": row[j] for j in range(i, len(row))}
    return found
