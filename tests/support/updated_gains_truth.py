"""What gains that follow the index are: exact gains, tangents and limits, from Riccati solutions.

Independent because gains and their slopes come from the enclosed steady state of the model, the
tangents are drawn with them, covariances solve the linear equation of the loop, and limits are
where a difference changes its sign. No formula of the derivation is used.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, partial
from typing import NamedTuple

import flint

from gainproof.verify.oracles.ball import enclose
from gainproof.verify.oracles.fixed_gain import ball, predicted, updated
from gainproof.verify.oracles.spectrum import Spectrum, spectrum
from gainproof.verify.oracles.state_space import state_space
from gainproof.verify.oracles.true_values import Truth
from gainproof.verify.oracles.zero_crossing import between

BITS, DIGITS = 75, 45
WORKING = 500
Pair = tuple[flint.arb, flint.arb]


class Gains(NamedTuple):
    """Both gains and their slopes by the index."""

    alpha: flint.arb
    beta: flint.arb
    alpha_slope: flint.arb
    beta_slope: flint.arb


@cache
def _spectrum() -> Spectrum:
    model = {
        "transition": [["1", "1"], ["0", "1"]],
        "process_noise": [["1/4", "1/2"], ["1/2", "1"]],
        "measurement": [["1", "0"]],
        "measurement_noise": [["1"]],
    }
    return spectrum(state_space(model))


def exact_gains(index: Fraction) -> Gains:
    """Of the best filter at this index."""
    found = enclose(_spectrum(), index, DIGITS)
    (alpha,), (beta,) = found.state.gain
    (first,), (second,) = found.slope.gain
    return Gains(alpha, beta, first, second)


def tangents(at: Gains, nominal: Fraction, index: flint.arb) -> Pair:
    """First-order gains from those `at` the nominal index."""
    step = index - ball(nominal)
    return at.alpha + at.alpha_slope * step, at.beta + at.beta_slope * step


def noise(index: flint.arb) -> flint.arb_mat:
    """The covariance of the manoeuvre over an interval."""
    square = index**2
    return flint.arb_mat([[square / 4, square / 2], [square / 2, square]])


def variances(gains: Pair, index: flint.arb) -> dict[str, flint.arb]:
    """Those of the positions and velocities of a filter with these gains."""
    ahead, after = predicted(gains, noise(index)), updated(gains, noise(index))
    return {
        f"{kind}_{i + 1}{i + 1}": found[i, i]
        for kind, found in (("predicted", ahead), ("updated", after))
        for i in (0, 1)
    }


@dataclass(frozen=True)
class UpdateLimitsTruth:
    """The ratios at which first-order gains change what they are worth."""

    def at(self, argument: str, value: float) -> Mapping[str, Truth]:
        """Each limit of the nominal index."""
        assert argument == "nominal_index"
        return _limits(Fraction(value))


@cache
def _limits(nominal: Fraction) -> Mapping[str, Truth]:
    with flint.ctx.workprec(WORKING):
        at = exact_gains(nominal)
        start = ball(nominal)

        def held(index: flint.arb) -> flint.arb:
            """Variance of the updated filter less that of the held one."""
            found = variances(tangents(at, nominal, index), index)
            return found["updated_22"] - variances((at.alpha, at.beta), index)["updated_22"]

        border = 4 - 2 * at.alpha - at.beta
        ends = {
            "alpha_one_ratio": (1 - at.alpha) / at.alpha_slope,
            "unstable_ratio": border / (2 * at.alpha_slope + at.beta_slope),
        }
        found = {name: 1 + step / start for name, step in ends.items()}
        found |= {
            f"{name}_gain_ratio": _ratio(nominal, partial(_farther, at, nominal, place))
            for place, name in enumerate(("alpha", "beta"))
        }
        last = _fraction(found["unstable_ratio"]) * (1 - Fraction(1, 2**40))
        found["variance_ratio"] = _ratio(nominal, held, last)
        return {name: Truth(x, x) for name, x in found.items()}


def _farther(at: Gains, nominal: Fraction, place: int, index: flint.arb) -> flint.arb:
    """Distance of the updated gain from the exact one less that of the held one."""
    held, first = at[place], tangents(at, nominal, index)[place]
    exact = exact_gains(_fraction(index))[place]
    return (first - exact) - (exact - held)


def _fraction(value: flint.arb) -> Fraction:
    mantissa, exponent = value.mid().man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def _ratio(
    nominal: Fraction, rising: Callable[[flint.arb], flint.arb], most: Fraction = Fraction(10**16)
) -> flint.arb:
    """The ratio to the nominal index at which a difference turns positive."""
    ends = between(nominal * Fraction(1001, 1000), nominal * most, rising, BITS)
    low, high = (ball(each) / ball(nominal) for each in ends)
    return low.union(high)
