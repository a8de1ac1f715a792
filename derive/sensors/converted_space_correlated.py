"""Noises of the range that are correlated with those of both angles: tower, and steps in space."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.algebra.variables import above_zero
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import column, real
from gainproof.derive.relation import described, equal
from gainproof.derive.sensors.circles import elevation_circle
from gainproof.derive.sensors.converted_names import KEPT, R
from gainproof.derive.sensors.converted_space_names import (
    BOTH,
    COS_E,
    KEPT_E,
    LA,
    LE,
    SIN_E,
    WHOLE,
    A,
)

Pair = tuple[sp.Expr, sp.Expr]
CA, CE = real("azimuth_covariance"), real("elevation_covariance")
SIGNED = {each: (real(f"{each}_more"), real(f"{each}_less")) for each in (CA.name, CE.name)}
MEAN = tuple(real(f"both_{entry}") for entry in ("ahead", "across", "up"))
PRODUCT = tuple(real(f"both_{pair}") for pair in ("aa", "ac", "cc", "au", "cu", "uu"))
LATEX = {
    "azimuth_covariance": "c",
    "elevation_covariance": "e",
    **{
        f"{name}_{side}": f"{letter}_{sign}"
        for name, letter in ((CA.name, "c"), (CE.name, "e"))
        for side, sign in (("more", "+"), ("less", "-"))
    },
    **{f"both_{entry}": f"m_{entry[0]}" for entry in ("ahead", "across", "up")},
    "both_across": "m_c",
    **{str(symbol): f"Q_{{{str(symbol)[-2:]}}}" for symbol in PRODUCT},
}
DOUBLE = COS_E**2 - SIN_E**2, 2 * SIN_E * COS_E
"""Cosine and sine of twice the elevation."""


def space_correlated_tower() -> Tower:
    """Identities: covariances are of either sign."""
    elements: dict[str, sp.Expr] = {**elevation_circle()}
    elements |= {name: more - less for name, (more, less) in SIGNED.items()}
    elements |= {str(s): value for s, value in zip(MEAN, means(), strict=True)}
    elements |= {str(s): value for s, value in zip(PRODUCT, products(), strict=True)}
    own = above_zero("slant_range", "range_deviation", "kept_azimuth", "kept_elevation", "a")
    closed = tuple(
        Parameter(str(each), above=None, start="0") for pair in SIGNED.values() for each in pair
    )
    return Tower("space_correlated", (*own, *closed), (), elements)


def means() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Ahead, across and up."""
    return (
        BOTH * (R * COS_E - CE * SIN_E),
        BOTH * CA * COS_E,
        KEPT_E * (R * SIN_E + CE * COS_E),
    )


def products() -> tuple[sp.Expr, ...]:
    """Mean products: ahead and ahead, ahead and across, across and across, then with up."""
    cos, sin = DOUBLE
    tilted = LE**2 * ((WHOLE - 4 * CE**2) * cos - 4 * R * CE * sin)
    level = (WHOLE + tilted) / 2
    real_part = LA**2 * (WHOLE - 4 * CA**2 + tilted - 4 * LE**2 * CA**2 * cos) / 2
    turned = LA**2 * CA * (2 * R + LE**2 * (2 * R * cos - 4 * CE * sin))
    slope = KEPT * LE**2 / 2
    return (
        (level + real_part) / 2,
        turned / 2,
        (level - real_part) / 2,
        slope * ((WHOLE - CA**2 - 4 * CE**2) * sin + 4 * R * CE * cos),
        slope * (2 * R * CA * sin + 4 * CA * CE * cos),
        (WHOLE - tilted) / 2,
    )


def space_correlated_steps() -> list[Step]:
    """Moments by the generating function, and the conversions that stay exact."""
    return [*_moments(), _conversions()]


def _moments() -> list[Step]:
    first = _mean(1, 1, 1), _mean(-1, 1, 1)
    level, square = _mean(0, 0, 2)[0], _mean(2, 0, 2)
    around = [_mean(k, 2, 2) for k in (2, 0, -2)]
    rising = _mean(2, 1, 2), _mean(-2, 1, 2)
    upwards = (level + square[0]) / 2, (level - square[0]) / 2
    doubled = tuple((a + 2 * b + c) / 4 for a, b, c in zip(*around, strict=True))
    return [
        Step(
            "space-correlated",
            "In space the range's noise may be correlated with that of the azimuth, with the "
            "covariance `c`, and with that of the elevation, with `e`.",
            described("jointly Gaussian noises, those of azimuth and elevation independent"),
            "The noise of an angle is then the range's, turned, and a part of its own.",
            tower="space_correlated",
        ),
        Step(
            "space-correlated-means",
            "The means ahead, across and up are `m`: from the means of `r_m exp(i (k u + v))`, "
            "`u` and `v` the measured elevation and the noise of the azimuth, where `k` is 1 and "
            "-1, halves of whose sum are ahead and across, and from that without `v`.",
            equal(
                column(*MEAN),
                column(
                    (first[0][0] + first[1][0]) / 2,
                    (first[0][1] + first[1][1]) / 2,
                    _mean(1, 0, 1)[1],
                ),
            ),
            "Step @generating with the noise `k u + l v` for `n`: its covariance with the range's "
            "is `k e + l c`, and the factor before is `lambda_eta^(k^2) lambda^(l^2)`.",
            tower="space_correlated",
        ),
        joined(
            "space-correlated-closed",
            equal(column(*MEAN[:2]), column(*means()[:2])),
            "space_correlated",
        ),
        Step(
            "space-correlated-products",
            "The mean products `Q` likewise, from those of `r_m^2 exp(i (k u + l v))`.",
            equal(
                column(*PRODUCT),
                column(
                    (upwards[0] + doubled[0]) / 2,
                    doubled[1] / 2,
                    (upwards[0] - doubled[0]) / 2,
                    (rising[0][1] - rising[1][1]) / 4,
                    -(rising[0][0] - rising[1][0]) / 4,
                    upwards[1],
                ),
            ),
            "Squares of cosines are halves of 1 and the cosine of the double. Less the products of "
            "means this is the covariance, given the truth as given the measurement.",
            tower="space_correlated",
        ),
        joined(
            "space-correlated-forms",
            equal(column(*PRODUCT[:5]), column(*products()[:5])),
            "space_correlated",
        ),
        Step(
            "space-correlated-signs",
            "Both covariances are of either sign, the elevation is that of step @space-elevation.",
            equal(
                column(CA, CE, COS_E, SIN_E),
                column(
                    *(more - less for more, less in SIGNED.values()),
                    *(2 * A / (1 + A**2), (A**2 - 1) / (1 + A**2)),
                ),
            ),
            "Of either sign is a difference of two numbers from 0 on, marked `+` and `-`.",
            tower="space_correlated",
        ),
    ]


def _mean(k: int, turns: int, power: int) -> Pair:
    """Of r_m^power (1 or 2) times the point at k elevations and `turns` noises of the azimuth."""
    c = k * CE + turns * CA
    kept = KEPT_E ** (k * k) * KEPT ** (turns * turns)
    value: Pair = (R, c) if power == 1 else (WHOLE - c**2, 2 * R * c)
    cos, sin = {0: (sp.Integer(1), sp.Integer(0)), 1: (COS_E, SIN_E), 2: DOUBLE}[abs(k)]
    sin = sin if k >= 0 else -sin
    return (
        kept * (value[0] * cos - value[1] * sin),
        kept * (value[0] * sin + value[1] * cos),
    )


def _conversions() -> Step:
    level, height = BOTH * COS_E, BOTH * SIN_E
    return Step(
        "space-correlated-unbiased",
        "Unbiased given the truth is the conversion to `(r_m c_eta + e s_eta)/(lambda "
        "lambda_eta)` ahead, `-c c_eta/(lambda lambda_eta)` across and "
        "`(r_m s_eta - e c_eta)/lambda_eta` up, at measured angles; the mean of the truth "
        "given the measurement is `m` at the measured place.",
        equal(
            column(
                (MEAN[0] + CE * height) / BOTH,
                (MEAN[1] - CA * level) / BOTH,
                (MEAN[2] - CE * KEPT_E * COS_E) / KEPT_E,
            ),
            column(R * COS_E, 0, R * SIN_E),
        ),
        "Of the measured direction's cosine and sine of the elevation the means are "
        "`lambda lambda_eta c_eta` and `lambda lambda_eta s_eta`, ahead.",
        tower="space_correlated",
    )
