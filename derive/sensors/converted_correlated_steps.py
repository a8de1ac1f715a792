"""Steps on noises of range and azimuth that are correlated, in the plane."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import column
from gainproof.derive.relation import cited, described, equal
from gainproof.derive.sensors.converted_correlated_tower import (
    GROWN,
    LESS,
    MEAN,
    MEAN_SQUARE,
    MORE,
    SPREAD,
    SQUARE,
    TURNED,
    C,
    K,
    S,
    bias,
    spread,
)
from gainproof.derive.sensors.converted_names import KEPT, SIGMA_A, SIGMA_R, TRUE, L, R
from gainproof.derive.source import PROBABILITY


def correlated_steps() -> list[Step]:
    """The generating function, moments, the two conversions that stay exact."""
    return [*_function(), *_moments(), *_conversions()]


def _function() -> list[Step]:
    return [
        Step(
            "correlated",
            "Some sensors err in range and azimuth together. Let `c` be the covariance of the two "
            "noises, of either sign.",
            described("noises of range and azimuth jointly Gaussian, of covariance `c`"),
            "`c` is the correlation times both deviations.",
            tower="correlated",
            heading="Correlated noises",
        ),
        Step(
            "generating",
            "Two moments are wanted besides those of the azimuth alone, and one function has all "
            "of them.",
            cited(
                "For jointly Gaussian m, n of mean 0, deviations s_m, s_n and covariance c, and "
                "for all real t and k, the mean of exp(t m) (cos(k n) + i sin(k n)) is exp(p + "
                "i q) with p = (t^2 s_m^2 - k^2 s_n^2)/2 and q = t k c; its derivatives by t are "
                "the means of m and m^2 times exp(t m) (cos(k n) + i sin(k n)).",
                PROBABILITY.text(),
            ),
            "The moment generating function of the normal distribution in one argument, the "
            "characteristic function in the other.",
            tower="correlated",
        ),
        Step(
            "exponents",
            "The exponents `p` and `q`, with the noise of the range for `m` and that of the "
            "azimuth for `n`, and their derivatives by `t`:",
            equal(
                column(GROWN, TURNED),
                column((S**2 * SIGMA_R**2 - K**2 * SIGMA_A**2) / 2, S * K * C),
            ),
            "A derivative of `exp(p + i q)` is `p' + i q'` times it, a second one "
            "`p'' + i q'' + (p' + i q')^2`. At `t = 0` `p'` is 0. So the mean of the "
            "range's noise times `exp(i k n)` is "
            "`i k c lambda^(k^2)`, and that of its square `(sigma_r^2 - k^2 c^2) lambda^(k^2)`. "
            "Of either sign, `c` is the difference of two numbers from 0 on, `c_+` and `c_-`.",
            tower="correlated",
        ),
        joined(
            "exponents-slopes",
            equal(
                column(*(sp.Derivative(each, S) for each in (GROWN, TURNED))),
                column(S * SIGMA_R**2, K * C),
            ),
            "correlated",
        ),
        joined(
            "exponents-curvatures",
            equal(
                column(*(sp.Derivative(each, (S, 2)) for each in (GROWN, TURNED))),
                column(SIGMA_R**2, 0),
            ),
            "correlated",
        ),
        joined("either-sign", equal(C, MORE - LESS), "correlated"),
    ]


def _moments() -> list[Step]:
    whole, doubled = R**2 + SIGMA_R**2, L**2 * (R**2 + SQUARE)
    return [
        Step(
            "correlated-covariance",
            "So the converted measurement has means `m`, `lambda r` along, `lambda c` across the "
            "true line of sight, and the truth has `lambda r_m` and `lambda c` from the measured "
            "one, with the covariance `N(r)` or `N(r_m)`; along, across, and of the two:",
            equal(
                column(*SPREAD),
                column(
                    (whole + doubled) / 2 - (KEPT * R) ** 2,
                    (whole - doubled) / 2 - (KEPT * C) ** 2,
                    L**2 * (4 * R * C) / 2 - (KEPT * R) * (KEPT * C),
                ),
            ),
            "The mean of `r_m^2 exp(2 i n)` is `lambda^4 (r^2 + 4 i r c + sigma_r^2 - 4 c^2)`; its "
            "real part is the difference of the mean squares along and across, half the imaginary "
            "part the mean product. Taken off instead of added the noises have the same joint "
            "distribution.",
            tower="correlated",
        ),
        joined(
            "correlated-mean", equal(column(*MEAN), column(KEPT * TRUE, KEPT * C)), "correlated"
        ),
        joined("correlated-form", equal(column(*SPREAD), column(*spread())), "correlated"),
    ]


def _conversions() -> list[Step]:
    level, beside = bias()
    return [
        Step(
            "correlated-unbiased",
            "Divided by `lambda` alone the conversion is off by `c` across, at every range. Taking "
            "`c/lambda` off across the measured line of sight too takes that away. Along and "
            "across the true one:",
            equal(
                column(MEAN[0] / KEPT, (MEAN[1] - C * KEPT) / KEPT),
                column(TRUE, 0),
            ),
            "The mean of `(r_m - i c) exp(i n)` is `lambda (r + i c) - i c lambda`.",
            tower="correlated",
        ),
        Step(
            "correlated-modified",
            "And the modified conversion puts the truth at `lambda r_m` along and `lambda c` "
            "across, with the covariance `N(r_m)`. The unbiased one's mean square errors given the "
            "measurement are `N` with the squares and the product of its biases.",
            equal(
                column(level, beside),
                column(R / KEPT - KEPT * R, -C / KEPT - KEPT * C),
            ),
            "Exact both, each for what is given.",
            tower="correlated",
        ),
        joined(
            "correlated-mean-square",
            equal(
                column(*MEAN_SQUARE),
                column(
                    SPREAD[0] + (R / KEPT - KEPT * R) ** 2,
                    SPREAD[1] + (C / KEPT + KEPT * C) ** 2,
                    SPREAD[2] - (R / KEPT - KEPT * R) * (C / KEPT + KEPT * C),
                ),
            ),
            "correlated",
        ),
        Step(
            "uncorrelated",
            "Without correlation this is what was there before.",
            equal(
                column(*(each - more for each, more in zip(SPREAD, _extra(), strict=True))),
                column(
                    (R**2 * (1 - L) ** 2 + SIGMA_R**2 * (1 + L**2)) / 2,
                    (R**2 + SIGMA_R**2) * (1 - L) * (1 + L) / 2,
                    0,
                ),
            ),
            "Step @measured-spread; the rest are multiples of `c`.",
            tower="correlated",
        ),
    ]


def _extra() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    return -2 * L**2 * C**2, -L * C**2 * (1 - 2 * L), -L * R * C * (1 - 2 * L)
