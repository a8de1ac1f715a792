"""A definition that is printed is compared with what its symbol stands for in all other claims."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from claim_campaign.proved import CLAIMS
from mutation.tree import number, to_graph, to_tree
from one_of_each import cases

from gainproof.verify.judge.claim.file import read_claim_file, read_claim_text
from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.kinds.definition import compared_token, is_as_declared
from gainproof.verify.judge.trial import try_claim
from gainproof.verify.judge.verdict import ClaimVerdict

HEAD = r"""
format = "gainproof claims 1"
[source]
key = "test"
title = "made for this test"
authors = ["nobody"]
publication = "nowhere"
[symbols]
'T' = { quantity = "sampling_interval", meaning = "interval" }
[settings.a]
title = "a"
kind = "algebra"
[settings.a.symbols]
'v' = { unit = "m s^-1", meaning = "velocity" }
'a' = { unit = "m s^-2", meaning = "acceleration" }
'w' = { definition = 'v + a T', meaning = "velocity later" }
'f' = { arguments = ['v'], definition = 'v^2', meaning = "square" }
'r' = { undefined = true, meaning = "never said" }
'q' = { definition = '\frac{r}{2}', meaning = "made of it" }
[settings.own]
title = "own"
kind = "steady_state"
transition = [["1", "T"], ["0", "1"]]
process_noise = [['\sigma_w^2 T^4/4', '\sigma_w^2 T^3/2'], ['\sigma_w^2 T^3/2', '\sigma_w^2 T^2']]
measurement = [["1", "0"]]
measurement_noise = [['\sigma_v^2']]
[settings.own.symbols]
'\sigma_w' = { unit = "m s^-2", domain = '\sigma_w > 0', meaning = "deviation" }
'\sigma_v' = { quantity = "measurement_noise_deviation", meaning = "deviation" }
'\Lambda' = { quantity = "tracking_index", meaning = "tracking index" }
'b' = { unit = "1", meaning = "anything" }
[settings.loop]
title = "loop"
kind = "fixed_gain"
states = 2
[settings.loop.symbols]
'\alpha' = { quantity = "filter_gain.1", meaning = "gain" }
'\beta' = { quantity = "filter_gain.2", meaning = "gain" }
[settings.m]
title = "m"
kind = "matrices"
sizes = ['n']
[settings.m.symbols]
'A' = { shape = ["n", "n"], is = ["invertible"], meaning = "any" }
'B' = { definition = 'A + A^T', meaning = "sum" }
[[claims]]
id = "c"
place = "p"
kind = "definition"
"""


def judged(setting: str, latex: str) -> ClaimVerdict:
    text = f"{HEAD}setting = '{setting}'\nlatex = '{latex}'\n"
    (verdict,) = judge_file(read_claim_text(text), ())
    return verdict


@pytest.mark.parametrize(
    ("setting", "latex", "token"),
    [
        ("a", "w = v + 2 a T", "w"),
        ("a", "w = v - a T", "w"),
        ("a", r"w = v + \frac{a T}{2}", "w"),
        ("a", "f(v) = 2 v^2", "f"),
        ("own", r"\Lambda = \frac{2 \sigma_w T^2}{\sigma_v}", r"\Lambda"),
        ("own", r"\Lambda = \left( \frac{\sigma_w T^2}{\sigma_v} \right)^2", r"\Lambda"),
        ("m", "B = A + 2 A^T", "B"),
        ("m", "B = A - A^T", "B"),
    ],
)
def test_another_formula_than_all_claims_use_is_refuted(
    setting: str, latex: str, token: str
) -> None:
    verdict = judged(setting, latex)
    assert verdict.verdict == "refuted"
    assert verdict.reason.startswith(f"not what {token} stands for in this setting: ")


@pytest.mark.parametrize(
    ("setting", "latex"),
    [
        ("a", "w = v + a T"),
        ("a", "w = a T + v"),
        ("a", "f(v) = v v"),
        ("a", r"q = \frac{r}{2}"),
        ("own", r"\Lambda = \frac{\sigma_w T^2}{\sigma_v}"),
        ("m", "B = A + A^T"),
        ("m", "B = A^T + A"),
    ],
)
def test_the_same_formula_is_said_to_be_that(setting: str, latex: str) -> None:
    verdict = judged(setting, latex)
    assert verdict.verdict == "definition"
    assert (verdict.method or "").startswith("equal to what ")


@pytest.mark.parametrize(
    ("setting", "latex"),
    [
        ("a", "v = a T"),  # free symbols: the formula itself says what one of them is
        ("own", r"\Lambda = b"),
        ("loop", r"\beta = \frac{\alpha^2}{2 - \alpha}"),
        ("a", "q = 2 r"),  # of a symbol that is never defined
    ],
)
def test_what_nothing_else_says_is_not_compared(setting: str, latex: str) -> None:
    verdict = judged(setting, latex)
    assert (verdict.verdict, verdict.method) == ("definition", None)


OPEN = ("line-residuals",)
"""A sum over terms of a sequence, which has no one value: it is seen to differ, and no more."""
SOURCES = ("patent-4869403", "suzuki", "kosuge-slides", "kosuge-doppler")


@pytest.mark.parametrize("source", cases(SOURCES, lambda source: source == SOURCES[0]))
def test_every_definition_of_a_source_is_tied(source: str) -> None:
    """Twice the formula, and its opposite, are something else."""
    claim_file = read_claim_file(CLAIMS / f"{source}.toml")
    solved: dict[Any, Any] = {}
    for claim in claim_file.claims:
        setting = claim_file.settings[claim.setting]
        if setting.matrices is not None or compared_token(claim, setting) is None:
            continue
        for factor in (2, -1):
            changed = _times(claim, factor)
            assert not is_as_declared(changed, setting)
            found = try_claim(changed, setting, (), solved).findings.values()
            verdicts = {finding.verdict for finding in found}
            assert verdicts, claim.id
            assert verdicts <= {"refuted", "undefined"} or claim.id in OPEN, (claim.id, verdicts)


def _times(claim: Claim, factor: int) -> Claim:
    assert claim.formula is not None
    readings = []
    for reading in claim.formula.readings:
        *before, relation = reading.relations
        right = to_graph(("mul", number(factor), to_tree(relation.right)))
        changed = (*before, replace(relation, right=right))
        readings.append(replace(reading, relations=changed))
    return replace(claim, formula=replace(claim.formula, readings=tuple(readings)))
