"""The true value, in a ball, of any named quantity as a function of one named argument.

Puts names to what the other oracles return, so that a computed number can be compared by name.
Arguments: ``tracking_index``, or a gain (``alpha``, ``beta``) from which the index is found by
bracketing; for growing-memory fits ``sample_number``. Quantities: gains, predictor gains
(``position``, ...), ``predicted_ij``, ``updated_ij``; their derivatives with respect to the index
under ``d_`` and the name, the second ones under ``dd_``; ``innovation_deviation``, the square root
of the innovation variance; ``pole_product``; real and imaginary parts of the poles,
``first_real`` and so on; of three poles the real and positive one, ``real_pole``, and of the others
``modulus`` (the geometric mean), ``half_sum`` and ``quarter_discriminant``, half their difference
squared.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import flint

from gainproof.verify.oracles import inverse, least_squares, quantities
from gainproof.verify.oracles.ball import Enclosure, enclose
from gainproof.verify.oracles.matrices import product, transpose
from gainproof.verify.oracles.second_derivatives import second_slopes
from gainproof.verify.oracles.spectrum import Spectrum, spectrum
from gainproof.verify.oracles.state_space import exact, state_space

ORDINALS = ("first", "second", "third")
BITS = 400
# of the bracket round an index found from a gain: a billionth of a double's last place
WIDTH = Fraction(1, 10**26)


@dataclass(frozen=True)
class Truth:
    """A quantity's true value and the size its error is measured by, both in balls.

    The scale is the value itself, but for the parts of a pole, where it is the modulus, and for
    what `second_derivatives` says.
    """

    value: flint.arb
    scale: flint.arb


@dataclass(frozen=True)
class SteadyStateTruth:
    """Truth about the steady state of one model (in units T = R = 1, process noise for index 1)."""

    spectrum: Spectrum

    def at(
        self, argument: str, value: float | Fraction, near: float | Fraction | None = None
    ) -> Mapping[str, Truth]:
        """Every named quantity where ``argument`` has exactly this value.

        ``near`` is a guess of the index when the argument is a gain; it saves time.
        """
        if argument == "tracking_index":
            return _everything(enclose(self.spectrum, exact(value))) | {
                f"dd_{name}": Truth(*ball)
                for name, ball in second_slopes(self.spectrum, value).items()
            }

        def gain(found: Enclosure) -> tuple[flint.arb, flint.arb]:
            return quantities.values(found)[argument], quantities.slopes(found)[argument]

        guess = exact(near) if near is not None else None
        found = inverse.bracket(self.spectrum, gain, exact(value), guess, WIDTH)
        below, above = quantities.values(found.below), quantities.values(found.above)
        named = {"tracking_index": _plain(found.index)}
        with flint.ctx.workprec(BITS):
            named |= {name: _plain(below[name].union(above[name])) for name in below}
        return named


def steady_state_truth(data: Mapping[str, Any]) -> SteadyStateTruth:
    """Truth about the model of ``data`` (rows of number texts)."""
    return SteadyStateTruth(spectrum(state_space(data)))


@dataclass(frozen=True)
class FitTruth:
    """Truth about the least-squares fit of one degree to samples 0..k, at sample k."""

    degree: int

    def at(self, argument: str, value: float | Fraction) -> Mapping[str, Truth]:
        """Gains, updated and predicted covariance at sample number ``value``.

        The predicted covariance, that of the fit to samples 0..k-1 carried to k, is left out
        where those samples are too few.
        """
        k = exact(value)
        if argument != "sample_number" or k.denominator != 1:
            raise ValueError(f"needs a whole sample_number, got {argument} = {value!r}")
        newest = int(k)
        named = dict(zip(quantities.FILTER, least_squares.gains(self.degree, newest), strict=False))
        covariances = {"updated": least_squares.covariance(self.degree, newest)}
        if newest > self.degree:
            ahead = least_squares.taylor(self.degree)
            before = least_squares.covariance(self.degree, newest - 1)
            covariances["predicted"] = product(ahead, before, transpose(ahead))
        for kind, rows in covariances.items():
            for i, row in enumerate(rows):
                named |= {f"{kind}_{i + 1}{j + 1}": row[j] for j in range(i, len(row))}
        with flint.ctx.workprec(BITS):
            return {
                name: _plain(flint.arb(flint.fmpq(x.numerator, x.denominator)))
                for name, x in named.items()
            }


def _everything(found: Enclosure) -> dict[str, Truth]:
    named = {name: _plain(ball) for name, ball in quantities.values(found).items()}
    named |= {f"d_{name}": _plain(ball) for name, ball in quantities.slopes(found).items()}
    with flint.ctx.workprec(found.bits):
        named["innovation_deviation"] = _plain(found.state.innovation[0][0].sqrt())
        product = flint.acb(1)
        for root in found.poles:
            product *= root
        named["pole_product"] = _plain(product.real)
    for ordinal, pole in zip(ORDINALS, quantities.poles(found), strict=False):
        named[f"{ordinal}_real"] = Truth(pole.real, pole.modulus)
        named[f"{ordinal}_imaginary"] = Truth(pole.imaginary, pole.modulus)
    return named | (_of_three(found) if len(found.poles) == 3 else {})


def _of_three(found: Enclosure) -> dict[str, Truth]:
    """The pole that is real, of several the largest, and what is known of the other two."""
    listed = sorted(found.poles, key=lambda pole: (pole.imag != 0, -float(pole.real.mid())))
    real, first, second = listed
    with flint.ctx.workprec(found.bits):
        return {
            "real_pole": _plain(real.real),
            "modulus": _plain((first * second).real.sqrt()),
            "half_sum": _plain((first + second).real / 2),
            "quarter_discriminant": _plain((((first - second) / 2) ** 2).real),
        }


def _plain(ball: flint.arb) -> Truth:
    return Truth(ball, ball)
