"""The claims of the paper on location in multipath: each formula has one, slips in them are
refuted, and nothing but a wrongly rounded number is.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from one_of_each import cases

import gainproof.verify
from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.judge import judge_setting
from gainproof.verify.judge.verdict import ClaimVerdict

FILE = Path(gainproof.verify.__file__).parent / "claims" / "kosuge-doppler.toml"
TEXT = FILE.read_text(encoding="utf-8")
PROPERTIES = [f"property-{n}" for n in range(1, 16)] + [f"property-A{n}" for n in (1, 2, 5, 6, 7)]
SLIPS = [
    ("18", r"\dot{R}_i = g_i", r"\dot{R}_i = -g_i"),
    ("24-value", r"^T - g_i", r"^T + g_i"),
    ("143", r"-1/2\sqrt{2}", r"1/2\sqrt{2}"),
    ("55-d", "3.84", "3.85"),
    ("table1-2-y", "6.44", "6.43"),
    ("table1-0-exact", "175", "176"),
    ("30", r"A\underline{a} + ", r"A\underline{a} - "),
    ("53", r"M(A^T V^{-1} A)^{-1} M^T", r"2 M(A^T V^{-1} A)^{-1} M^T"),
    ("61-part", r"O_{n,6} & H_{n_b}", r"O_{n,6} & -H_{n_b}"),
    ("76", r"& I_{n-n_b} \end", r"& 2 I_{n-n_b} \end"),
    ("82-first", r"\ge", r"\le"),
    ("104", r"\ge 0", r"\le 0"),
    ("105", r"\begin{pmatrix} K_{11} & K_{12}", r"\begin{pmatrix} K_{11} & -K_{12}"),
    ("107", "= P^T", "= -P^T"),
    ("103", "- P^T", "+ P^T"),
    ("108", "K_{11} - ", "K_{11} + "),
    ("112", r"\leq", r"\geq"),
    ("118", r"\leq", r"\geq"),
    ("119", r"\ge", r"\le"),
    ("122", "+ L^T", "- L^T"),
    ("125", "= V_l + ", "= V_l - "),
    ("127", "= G_{11}^{-1} + ", "= G_{11}^{-1} - "),
    ("131", "B^T S B", "-B^T S B"),
    ("132", "= V_d^{-1}", "= V_d"),
    ("134", "= -V_d", "= V_d"),
    ("138", r"_i^2 + ", r"_i^2 - "),
    ("A2", "& H_2^{-1} ", "& -H_2^{-1} "),
    ("A3", r"\le D^{-1}", r"\ge D^{-1}"),
    ("property-A7", r"0 \leq", r"0 \geq"),
]
DEFAULT = ("18", "55-d", "76", "82-first", "107", "118", "134", "property-A7")


@pytest.fixture(scope="module")
def verdicts() -> Mapping[str, Any]:
    text = FILE.with_suffix(".verdicts.json").read_text(encoding="utf-8")
    return {claim["id"]: claim for claim in json.loads(text)["claims"]}


read = cache(read_claim_text)
"""Most of what judging one claim takes; of the file itself it is done once."""


def judged_with(name: str, before: str, after: str) -> ClaimVerdict:
    """The verdict on one claim, the first such piece of its formula replaced."""
    start = TEXT.index(f'\nid = "{name}"\n')
    place = TEXT.index("\nlatex = ", start)
    end = TEXT.find("\n[[claims]]", start)
    piece = TEXT[place : end if end > 0 else None]
    assert before in piece, piece
    text = TEXT[:place] + piece.replace(before, after, 1) + (TEXT[end:] if end > 0 else "")
    file = read(text, FILE.name)
    (claim,) = (claim for claim in file.claims if claim.id == name)
    (found,) = judge_setting(file.settings[claim.setting], [claim], [], {})
    return found


def test_every_number_of_the_paper_has_a_claim(verdicts: Mapping[str, Any]) -> None:
    numbers = [str(n) for n in range(1, 148)] + [f"A{n}" for n in range(1, 6)] + PROPERTIES
    numbers += [f"table1-{n}-{entry}" for n in (0, 2, 4) for entry in ("x", "y", "vx", "vy")]
    assert not set(numbers) - set(verdicts)


def test_one_number_is_rounded_wrongly_and_nothing_else_is_wrong(
    verdicts: Mapping[str, Any],
) -> None:
    settled = ("proved", "definition", "remark")
    others = [name for name, claim in verdicts.items() if claim["verdict"] not in settled]
    assert others == ["table1-4-vy"]
    assert verdicts["table1-4-vy"]["verdict"] == "refuted"
    assert verdicts["table1-4-vy"]["repair"]["latex"].endswith("0.104")


@pytest.mark.alike
@pytest.mark.parametrize(("name", "before", "after"), cases(SLIPS, lambda slip: slip[0] in DEFAULT))
def test_slips_are_refuted(name: str, before: str, after: str) -> None:
    found = judged_with(name, before, after)
    assert found.verdict in ("refuted", "conditional"), (found.verdict, found.reason)
    assert judged_with(name, before, before).verdict == "proved"


@pytest.mark.parametrize(
    ("name", "hypothesis"),
    [("69", "given = ['0 < A^T A']"), ("property-A7", "given = ['D \\geq 0']")],
)
def test_hypotheses_are_needed(name: str, hypothesis: str) -> None:
    found = judged_with(name, hypothesis, "")
    assert found.verdict in ("refuted", "conditional"), (found.verdict, found.reason)
