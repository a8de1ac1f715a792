"""Dimensions decide before anything else: between readings, and against formulas that mix units."""

from __future__ import annotations

from pathlib import Path

import pytest

import gainproof.verify
from gainproof.verify.judge.claim.file import read_claim_file, read_claim_text
from gainproof.verify.judge.dimensions.claim import claim_readings
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.verdict import ClaimVerdict

HEAD = """
format = "gainproof claims 1"
[source]
key = "test"
title = "made for this test"
authors = ["nobody"]
publication = "nowhere"
[symbols]
'T' = { quantity = "sampling_interval", meaning = "interval" }
'a' = { unit = "m s^-2", meaning = "acceleration" }
'v' = { unit = "m s^-1", meaning = "velocity" }
'x' = { unit = "m", meaning = "position" }
'b' = { unit = "1", meaning = "a number" }
'w' = { definition = 'a T + v', meaning = "velocity after a while" }
'u' = { definition = 'x + v', meaning = "nonsense" }
[settings.s]
title = "s"
kind = "algebra"
"""


def judged(kind: str, latex: str) -> ClaimVerdict:
    text = f"{HEAD}[[claims]]\nid = 'c'\nplace = 'p'\nkind = '{kind}'\nsetting = 's'\n"
    return judge_file(read_claim_text(f"{text}latex = '{latex}'\n"), ())[0]


@pytest.mark.alike
@pytest.mark.parametrize(
    ("kind", "latex"),
    [
        ("identity", "x + v = v + x"),
        ("identity", "x = T a + x - T a"),
        ("definition", "v = a T^2"),
        ("inequality", "x < v"),
        ("identity", "x + b = b + x"),
        ("identity", "(x + 1)^2 = x^2 + 2x + 1"),
        ("definition", r"v = \\sqrt{x}".replace("\\\\", "\\")),
    ],
)
def test_mixed_dimensions_are_refuted(kind: str, latex: str) -> None:
    verdict = judged(kind, latex)
    assert verdict.verdict == "refuted"
    assert verdict.method == "dimensions"
    assert verdict.reason.startswith("dimensions: ")


@pytest.mark.parametrize(
    ("kind", "latex", "expected"),
    [
        ("identity", "x + v T = T v + x", "proved"),
        ("identity", "w = v + T a", "proved"),
        ("identity", "0 = x - x", "proved"),
        ("definition", "x = v T + a T^2 / 2", "definition"),
        ("inequality", "x^2 + 1 > 0", "refuted"),
    ],
)
def test_agreeing_dimensions_are_judged_on(kind: str, latex: str, expected: str) -> None:
    assert judged(kind, latex).verdict == expected


def test_dimensions_choose_the_reading_of_a_slash() -> None:
    # x/v T is (x/v) T or x/(v T): only one of them is a number
    verdict = judged("identity", "b x / v T = b x T^{-1} v^{-1}")
    assert verdict.verdict == "proved"
    assert verdict.reading is not None
    # both readings are numbers here, and the second is the true one
    assert judged("identity", "b / b b = b^{-1} ").verdict == "proved"


def test_a_formula_of_which_no_reading_fits_is_told_with_each() -> None:
    """m/((m/s) s^2) is s^-1, as it is mostly meant, and (m/(m/s)) s^2 is s^3."""
    path = Path(gainproof.verify.__file__).parent / "claims" / "suzuki.toml"
    file = read_claim_file(path)
    faults = {
        claim.id: claim_readings(claim, file.settings[claim.setting])[1] for claim in file.claims
    }
    first, other = str(faults["fig1-r"]).split("read otherwise")
    assert first.count("s^-1") == other.count("s^3") == 1
    assert "s^3" not in first
    assert "read otherwise" not in str(faults["15"])
