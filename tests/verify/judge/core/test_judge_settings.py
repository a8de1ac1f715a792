"""Claim files judged whole: verdicts, conventions found once for a setting, witnesses, limits."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from claim_texts import SOLVED

from gainproof.verify.judge.claim.file import read_claim_file, read_claim_text
from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.convention_choice import choose
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.trial import Trial, try_claim
from gainproof.verify.judge.verdict import ClaimVerdict

COMPARED = ("abg-update", "abg-predict")
"""Definitions of the lecture that are compared with the fit of a parabola."""
LECTURE = Path(__file__).parents[4] / "verify" / "claims" / "kosuge-slides.toml"
MODELS: tuple[dict[str, Any], ...] = tuple(
    {
        "name": name,
        "transition": [["1", "1"], ["0", "1"]],
        "process_noise": noise,
        "measurement": [["1", "0"]],
        "measurement_noise": [["1"]],
    }
    for name, noise in (
        ("random-velocity", [["0", "0"], ["0", "1"]]),
        ("random-acceleration", [["1/4", "1/2"], ["1/2", "1"]]),
        ("continuous-white-acceleration", [["1/3", "1/2"], ["1/2", "1"]]),
    )
)
OF_THREE_STATES: tuple[dict[str, Any], ...] = tuple(
    {
        "name": name,
        "transition": [["1", "1", "1/2"], ["0", "1", "1"], ["0", "0", "1"]],
        "process_noise": noise,
        "measurement": [["1", "0", "0"]],
        "measurement_noise": [["1"]],
    }
    for name, noise in (
        ("acceleration-increments", [["0", "0", "0"], ["0", "0", "0"], ["0", "0", "1"]]),
        ("random-jerk", [["1/36", "1/12", "1/6"], ["1/12", "1/4", "1/2"], ["1/6", "1/2", "1"]]),
    )
)
HEAD = """
format = "gainproof claims 1"
[source]
key = "test"
title = "made for this test"
authors = ["nobody"]
publication = "nowhere"
[symbols]
'k' = { quantity = "sample_number", meaning = "sample" }
'T' = { quantity = "sampling_interval", meaning = "interval" }
'\\Lambda' = { quantity = "tracking_index", meaning = "index" }
'\\alpha' = { quantity = "gain.1", meaning = "gain" }
'\\beta' = { quantity = "gain.2", meaning = "gain" }
'\\lambda' = { undefined = true, meaning = "never said" }
"""
STEADY = "[settings.s]\ntitle = 's'\nkind = 'steady_state'\nmodel = '{}'\ngain = '{}'\n"


def judged(setting: str, *claims: tuple[str, str], **options: Any) -> list[ClaimVerdict]:
    text = HEAD + setting
    for number, (kind, latex) in enumerate(claims):
        text += f"[[claims]]\nid = 'c{number}'\nplace = 'p'\nkind = '{kind}'\nsetting = 's'\n"
        text += f"latex = '{latex}'\n"
    return list(judge_file(read_claim_text(text), MODELS, solved=SOLVED, **options))


def test_lecture_is_decided_and_plain_data() -> None:
    seen: list[tuple[int, int]] = []
    lecture = read_claim_file(LECTURE)
    verdicts = judge_file(
        lecture,
        MODELS + OF_THREE_STATES,
        progress=lambda tried, total: seen.append((tried, total)),
    )
    settled = {"proved", "conditional", "refuted", "definition", "remark"}
    assert {v.verdict for v in verdicts} == settled
    # printed without the brackets of the product that is transposed
    assert [v.id for v in verdicts if v.verdict == "refuted"] == ["interacting-smoothing"]
    # the relation alone admits a second, unstable gain of the velocity
    assert [v.id for v in verdicts if v.verdict == "conditional"] == ["features-ab-stable-RA"]
    wanted = [v for v in verdicts if v.kind not in ("definition", "remark")]
    # After these the seven of the refuted one's setting under conventions that it excludes and the
    # repairs of these two; and the definitions that are compared with what their symbols stand for.
    # The definition that the refuted one uses is borne out by the others.
    setting = {claim.id: claim.setting for claim in lecture.claims}
    beside = [v for v in wanted if setting[v.id] == setting["interacting-smoothing"]]
    assert len(beside) == 7
    tried = len(wanted) + len(beside) + 2 + len(COMPARED)
    assert seen == [(n + 1, len(wanted)) for n in range(tried)]
    data = json.loads(json.dumps([v.to_json() for v in verdicts]))
    by_id = {claim["id"]: claim for claim in data}
    assert by_id["table-ab-RV"]["convention"] == "process noise random-velocity"
    assert by_id["table-ab-RA"]["convention"] == "process noise random-acceleration"
    assert set(data[0]) == {
        "id", "place", "kind", "latex", "verdict", "domain", "evidence", "repair", "repairs",
        "truth", "convention", "reading", "undefined", "any_filter", "reason", "accident",
        "seconds",
    }  # fmt: skip
    assert set(data[0]["evidence"]) == {"method", "certificate", "witness"}


def test_row_that_fits_no_family_is_refuted_with_a_witness_for_each() -> None:
    (verdict,) = judged(
        STEADY.format("search", "filter"), ("identity", r"\alpha(\alpha + \beta) = 3\beta")
    )
    assert verdict.verdict == "refuted"
    assert verdict.convention is None
    others = verdict.certificate["against other conventions"]
    assert len(others) == len(MODELS)
    assert all(set(witness["point"]) == {r"\Lambda"} for witness in others.values())
    assert all(set(witness["values"]) == {r"\alpha", r"\beta"} for witness in others.values())
    assert verdict.witness is not None


def test_several_families_fit() -> None:
    (verdict,) = judged(STEADY.format("search", "filter"), ("inequality", r"\alpha < 1"))
    assert verdict.verdict == "proved"
    assert verdict.convention is not None
    assert verdict.convention.startswith("any of: ")
    assert verdict.convention.count("process noise") == len(MODELS)


def test_choice_is_made_once_for_the_setting() -> None:
    verdicts = judged(
        STEADY.format("search", "filter"),
        ("inequality", r"\alpha < 1"),
        ("identity", r"\left(\alpha + \frac{\beta}{2}\right)^2 = 2\beta"),
        ("identity", r"\alpha = \beta"),
    )
    assert [v.verdict for v in verdicts] == ["proved", "proved", "refuted"]
    assert verdicts[0].convention == verdicts[1].convention == "process noise random-acceleration"
    assert "random-acceleration" in str(verdicts[2].reason)


def test_claims_that_need_different_families_are_conditional() -> None:
    verdicts = judged(
        STEADY.format("search", "filter"),
        ("identity", r"\alpha(\alpha + \beta) = 2\beta"),
        ("identity", r"\left(\alpha + \frac{\beta}{2}\right)^2 = 2\beta"),
    )
    assert [v.verdict for v in verdicts] == ["conditional", "conditional"]
    assert "no single convention" in verdicts[0].reason


def test_form_of_the_gain_is_found() -> None:
    # with predictor gains a, b: the filter gain of the position is a - b
    (verdict,) = judged(
        STEADY.format("random-velocity", "search"),
        ("identity", r"(\alpha - \beta)\alpha = 2\beta"),
    )
    assert verdict.verdict == "proved"
    assert verdict.convention is not None
    assert "predictor" in verdict.convention


def test_true_on_a_part_of_the_domain() -> None:
    (verdict,) = judged(STEADY.format("random-velocity", "filter"), ("inequality", r"\Lambda < 1"))
    assert verdict.verdict == "conditional"
    assert verdict.domain == r"for 0 < \Lambda < 1"
    assert verdict.witness is not None
    assert verdict.witness["point"] == {r"\Lambda": "2"}


def test_stated_start_is_taken_at_its_word() -> None:
    line = "[settings.s]\ntitle = 's'\nkind = 'growing_memory'\ndegree = 1\ngain = 'filter'\n"
    good, early, late = judged(
        line,
        ("identity", r"\beta = \frac{6}{(k+1)(k+2)} \quad (1 \leq k)"),
        ("identity", r"\beta = \frac{6}{(k+1)(k+2)} \quad (0 \leq k)"),
        ("identity", r"\beta = \frac{6}{(k+1)(k+3)} \quad (4 \leq k)"),
    )
    assert good.verdict == "proved"
    assert early.verdict == "conditional"
    assert early.domain == "for integers with k >= 1"
    assert late.verdict == "refuted"
    assert late.witness is not None
    assert late.witness["point"] == {"k": "4"}


def test_undefined_symbol_is_named() -> None:
    (verdict,) = judged(
        STEADY.format("random-velocity", "filter"), ("identity", r"\alpha = \lambda")
    )
    assert verdict.verdict == "undefined"
    assert verdict.undefined[0]["symbol"] == r"\lambda"


def test_unknown_model_and_uncovered_claims_are_undecided_with_reasons() -> None:
    (verdict,) = judged(STEADY.format("no-such-model", "filter"), ("identity", r"\alpha = \beta"))
    assert verdict.verdict == "undecided"
    assert "no-such-model" in verdict.reason
    assert not verdict.settled


@pytest.mark.slow
def test_child_processes_give_the_same_verdicts_and_can_be_killed() -> None:
    claims = (
        ("identity", r"\alpha(\alpha + \beta) = 2\beta"),
        ("identity", r"\alpha = \beta"),
    )
    setting = STEADY.format("search", "filter")
    here = judged(setting, *claims)
    apart = judged(setting, *claims, seconds=60.0, processes=2)
    assert [(v.verdict, v.convention) for v in here] == [(v.verdict, v.convention) for v in apart]
    hard = r"\sqrt{\alpha + \sqrt{\beta + \sqrt{\alpha}}} + \sqrt{\beta} = \sqrt{\alpha + 2}"
    (stopped,) = judged(setting, ("identity", hard), seconds=0.0)
    assert stopped.verdict == "undecided"
    assert "stopped after" in stopped.reason


def test_a_claim_that_failed_does_not_spoil_the_choice_for_the_others() -> None:
    verdicts = judged(
        STEADY.format("search", "filter"),
        ("identity", r"\alpha = \lambda"),
        ("identity", r"\alpha(\alpha + \beta) = 2\beta"),
    )
    assert [v.verdict for v in verdicts] == ["undefined", "proved"]
    setting, claim = settings_and_claim(r"\alpha(\alpha + \beta) = 2\beta")
    good = try_claim(claim, setting, MODELS, {})
    failed = Trial(replace(claim, id="x"), {}, (), False, 0.0, "stopped")
    chosen = choose([failed, good])
    assert [v.verdict for v in chosen] == ["undecided", "proved"]


def settings_and_claim(latex: str) -> tuple[Setting, Claim]:
    text = HEAD + STEADY.format("search", "filter")
    text += "[[claims]]\nid = 'y'\nplace = 'p'\nkind = 'identity'\nsetting = 's'\n"
    claim_file = read_claim_text(f"{text}latex = '{latex}'\n")
    return claim_file.settings["s"], claim_file.claims[0]
