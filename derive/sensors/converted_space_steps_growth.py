"""Steps on how covariances of converted measurements in space change with range."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import column
from gainproof.derive.relation import equal, monotone
from gainproof.derive.sensors.converted_names import COS2, SIN2, R
from gainproof.derive.sensors.converted_space_names import (
    COS_E,
    ENTRY,
    LA,
    LE,
    SIN_E,
    TWICE,
)

DEBIASED, UNBIASED, MODIFIED = (
    ENTRY[f"space_{name}"] for name in ("debiased", "unbiased", "modified")
)


def space_growth_steps() -> list[Step]:
    """Trends, and rates."""
    names = ("ahead", "across", "up")
    (first, *others) = [
        (f"growth-{name}-{entry}", symbol)
        for name, symbols in (("modified", MODIFIED), ("unbiased", UNBIASED))
        for entry, symbol in zip(names, symbols[:3], strict=True)
    ]
    c2 = TWICE[0]
    lost = 1 - LE, 1 - LA
    flat = lost[0] ** 2 * (1 + LE + LE**2) / 2, lost[0] * (1 + LE**3) / 2
    ahead = LA * (COS_E**2 * flat[0] + SIN_E**2 * flat[1]) + lost[1] ** 2 * c2 / 2
    across = c2 * lost[1] * (1 + LA) / 2
    return [
        Step(
            "space-growth",
            "All variances of the modified conversion grow strictly with the range, and so do the "
            "unbiased one's mean square errors,",
            monotone(first[1], "increasing", "slant_range"),
            "Squared ranges times positive numbers, and numbers.",
            tower="signs",
        ),
        *(joined(name, monotone(v, "increasing", "slant_range"), "signs") for name, v in others),
        Step(
            "space-growth-debiased",
            "and the debiased one's variances, at the rates",
            equal(
                column(*(sp.Derivative(entry, R) for entry in DEBIASED[:3])),
                2
                * R
                * column(
                    COS2 * ahead + SIN2 * across,
                    SIN2 * ahead + COS2 * across,
                    SIN_E**2 * flat[0] + COS_E**2 * flat[1],
                ),
            ),
            "What stands in brackets of step @debiased-form, turned by the elevation; all factors "
            "are positive.",
            tower="space",
        ),
    ]
