"""Steps on the moments of a polar measurement made Cartesian: given the truth, and given itself."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import column
from gainproof.derive.relation import cited, described, equal, positive
from gainproof.derive.sensors.converted_names import (
    COS2,
    KEPT,
    LOSS,
    SIGMA_R,
    SIN2,
    SPREAD,
    TRUE,
    TRUE_SPREAD,
    L,
    R,
)
from gainproof.derive.source import ELEMENTARY, PROBABILITY


def turn_steps() -> list[Step]:
    """The mean of a noisy direction, and of its squares."""
    return [
        Step(
            "measured",
            "A sensor at the origin measures the range `r` and the azimuth `theta`, counted from "
            "the x axis towards the y axis, as `r_m` and `theta_m`. Converted, the measurement is "
            "the place `(r_m cos theta_m, r_m sin theta_m)`.",
            described(
                "`r_m` is `r` with Gaussian noise of mean 0 and deviation `sigma_r`, `theta_m` is "
                "`theta` with such noise of deviation `sigma_theta`, independent; angles in radians"
            ),
            "For a bearing from north exchange x and y.",
            heading="The noise of a direction",
        ),
        Step(
            "gaussian",
            "What Gaussian noise leaves of a direction is known exactly.",
            cited(
                "For Gaussian n of mean 0 and standard deviation s and for every real k the mean "
                "of cos(k n) is exp(-k^2 s^2/2) and that of sin(k n) is 0.",
                PROBABILITY.text(),
            ),
            "The characteristic function of the normal distribution. `lambda` is the mean of the "
            "cosine, `exp(-sigma_theta^2/2)`; that of twice the noise is its fourth power. These "
            "are (15) and (16) of patent JP 4869403, as rebuilt.",
        ),
        Step(
            "kept",
            "Whatever the deviation, this is `1/(1 + ell)` with `ell` above zero.",
            equal(KEPT, 1 / (1 + LOSS)),
            "Every number between 0 and 1 is of this form, once. Above zero, since without noise "
            "of the azimuth nothing is to be done.",
        ),
        Step(
            "squares",
            "Of the noise's cosine and sine, `C` and `S` are the mean squares: they add up to 1, "
            "and their difference is the mean cosine of twice the noise.",
            equal(column(COS2 + SIN2, COS2 - SIN2), column(1, KEPT**4)),
            "Means of `cos^2 + sin^2 = 1` and of `cos^2 - sin^2`, the cosine of twice the angle.",
        ),
        joined(
            "squares-are", equal(column(COS2, SIN2), column((1 + KEPT**4) / 2, (1 - KEPT**4) / 2))
        ),
    ]


def truth_steps() -> list[Step]:
    """Given the truth."""
    second = TRUE**2 + SIGMA_R**2
    return [
        Step(
            "truth-mean",
            "Along the true line of sight the converted place lies at `r_m` times the cosine of "
            "the noise, across it at `r_m` times the sine. Means: `lambda r` and 0. What remains "
            "of the mean squares when the squared means are gone is the covariance `V(r)`:",
            equal(column(*TRUE_SPREAD), column(second * COS2 - (KEPT * TRUE) ** 2, second * SIN2)),
            "Range and azimuth are independent, so that means multiply; the mean square of `r_m` "
            "is `r^2 + sigma_r^2`. The product of the two places is an odd function of the "
            "azimuth's noise, its mean 0: this frame is that of the covariance's axes.",
            heading="Given the truth",
        ),
        Step(
            "truth-spread",
            "Nothing cancels in these forms: `1 - lambda^2` is a function of its own (expm1), and "
            "all else is added.",
            equal(
                column(*TRUE_SPREAD),
                column(
                    (TRUE**2 * (1 - L) ** 2 + SIGMA_R**2 * (1 + L**2)) / 2,
                    (TRUE**2 + SIGMA_R**2) * (1 - L) * (1 + L) / 2,
                ),
            ),
            "`(1 + lambda^4)/2 - lambda^2` is half the square of `1 - lambda^2`; "
            "`1 - lambda^4 = (1 - lambda^2)(1 + lambda^2)`.",
        ),
        Step(
            "truth-definite",
            "So it is positive definite, whatever the noise.",
            positive(TRUE_SPREAD[0]),
            "Sums of positive terms.",
        ),
        joined("truth-definite-cross", positive(TRUE_SPREAD[1])),
    ]


def measurement_steps() -> list[Step]:
    """Given the measurement."""
    second = R**2 + SIGMA_R**2
    return [
        Step(
            "prior",
            "The other way round one asks where the truth is, given the measurement. That needs "
            "what is known of it before; here nothing is.",
            described(
                "given the measurement the truth is at the range `r_m` less noise and at the "
                "azimuth `theta_m` less noise, of the same distributions, independent: flat priors "
                "of range and azimuth"
            ),
            "With a flat prior the posterior density of the truth is the likelihood, a Gaussian "
            "density in the truth centred on the measurement. A prior flat in x and y would be "
            "another, with weight `r`. Ranges below 0, which the Gaussian leaves possible, count "
            "as the opposite direction.",
            heading="Given the measurement",
        ),
        Step(
            "measured-mean",
            "So the same moments come again, about the measured line of sight: the truth has the "
            "mean `lambda r_m` there, and the covariance `V = V(r_m)`.",
            equal(column(*SPREAD), column(second * COS2 - (KEPT * R) ** 2, second * SIN2)),
            "As in step @truth-mean: the noise is as likely as its opposite.",
        ),
        joined(
            "measured-spread",
            equal(
                column(*SPREAD),
                column(
                    (R**2 * (1 - L) ** 2 + SIGMA_R**2 * (1 + L**2)) / 2,
                    (R**2 + SIGMA_R**2) * (1 - L) * (1 + L) / 2,
                ),
            ),
        ),
        Step(
            "prior-of-places",
            "Were every place of the plane as likely before, and not every range and azimuth, the "
            "mean would lie farther away, by the share `sigma_r^2/r_m^2`:",
            equal(KEPT * second / R, KEPT * R * (1 + SIGMA_R**2 / R**2)),
            "Areas grow with the range, which is a weight: the mean of `r^2` over that of `r`.",
        ),
        Step(
            "average",
            "A matrix with the entries `a` along and `b` across another line of sight, which is "
            "off by the noise, has on average these along and across the measured one:",
            equal(
                sp.ImmutableDenseMatrix([[COS2, SIN2], [SIN2, COS2]]) * column(*_entries()),
                column(
                    (_entries()[0] + _entries()[1]) / 2
                    + KEPT**4 * (_entries()[0] - _entries()[1]) / 2,
                    (_entries()[0] + _entries()[1]) / 2
                    - KEPT**4 * (_entries()[0] - _entries()[1]) / 2,
                ),
                free=("a", "b"),
            ),
            "Turn it by the noise and take means; what is off the diagonal is odd. And the mean "
            "of the squared true range is `r_m^2 + sigma_r^2`.",
        ),
        Step(
            "expm1",
            "The exponentials differ from their first terms on a known side.",
            cited("For t > 0: 1 - t < exp(-t) < 1 - t + t^2/2.", ELEMENTARY.text()),
            "With `t = sigma_theta^2` and with its double.",
        ),
    ]


def _entries() -> tuple[sp.Symbol, sp.Symbol]:
    return sp.Symbol("a", real=True), sp.Symbol("b", real=True)
