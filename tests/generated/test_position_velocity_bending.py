"""The documented second derivatives of the gains, by differences of the doubling."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path

from position_velocity_slopes import entries

from gainproof.verify.oracles.multiprecision import fraction

PAGE = Path(__file__).parents[2] / "docs" / "position-and-velocity.md"
GAINS = ("gain_11", "gain_12", "gain_22")


def second_differences(index: Fraction) -> list[Fraction]:
    step = index / 10**12

    def gains(at: Fraction) -> list[Fraction]:
        found = entries("continuous_white_acceleration", at, Fraction(1))
        return [fraction(found[name]) for name in GAINS]

    below, middle, above = gains(index - step), gains(index), gains(index + step)
    return [(a - 2 * b + c) / step**2 for a, b, c in zip(below, middle, above, strict=True)]


def test_the_table_of_second_derivatives() -> None:
    part = PAGE.read_text(encoding="utf-8").split("## Second derivatives")[1].split("\n## ")[0]
    rows = re.findall(r"^\| (\d[\d.]*) \| (\S+) \| (\S+) \| (\S+) \|$", part, re.MULTILINE)
    assert len(rows) == 3
    for index, *shown in rows:
        for text, value in zip(shown, second_differences(Fraction(index)), strict=True):
            assert f"{float(value):.8g}" == text
