"""`explain` goes through the certificate of every verdict again and comes to what `check` said:
committed claims, claims drawn at random, and those that once came out otherwise.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from typing import Any

import pytest
from drawn_claims import drawn_claims
from lecture_judged import claims_of
from one_of_each import cases
from samples import samples
from small_claims import judged

from gainproof.claims.claim_proofs import DECIDED, NOT_AGAIN, checked
from gainproof.files import places
from gainproof.subjects.derivations import outlines
from gainproof.verify.judge.claim.file import read_claim_file
from gainproof.verify.judge.judge import judge_file

LECTURE = "kosuge-slides"
PARTS = {"kosuge-doppler": 24, "patent-4869403": 12, "suzuki": 12}
"""Of the sources that have claims on the other kinds of setting, and conditional ones, the default
run judges each so-and-so-manyth claim.
"""


@cache
def said_of(source: str) -> dict[str, tuple[bool, str]]:
    """Of each committed claim whether it comes out as before, and words on that."""
    return {claim["id"]: checked(claim) for claim in claims_of(source)}


def elsewhere(said: Mapping[str, tuple[bool, str]]) -> dict[str, str]:
    """What is said of those that do not come out as before."""
    return {name: words for name, (good, words) in said.items() if not good}


@pytest.mark.parametrize(
    "source", cases(sorted(p.stem for p in places.claim_files()), lambda source: source == LECTURE)
)
def test_committed_claims(source: str) -> None:
    assert elsewhere(said_of(source)) == {}


@pytest.mark.parametrize("source", PARTS)
def test_some_committed_claims(source: str) -> None:
    (path,) = (path for path in places.claim_files() if path.stem == source)
    file = read_claim_file(path)
    some = replace(file, claims=file.claims[:: PARTS[source]])
    models = {m["name"]: m for entry in outlines() if (m := entry["model"])}
    verdicts = judge_file(some, list(models.values()))
    assert {verdict.verdict for verdict in verdicts} & set(DECIDED)
    assert elsewhere({v.id: checked(v.to_json()) for v in verdicts}) == {}


def test_hardly_any_committed_verdict_rests_on_what_is_not_kept() -> None:
    decided = [c["id"] for c in claims_of(LECTURE) if c["verdict"] in DECIDED]
    again = [name for name in decided if not said_of(LECTURE)[name][1].startswith(NOT_AGAIN)]
    assert len(again) > 0.8 * len(decided)


@pytest.mark.sampled
def test_drawn_claims() -> None:
    repeated: Counter[str] = Counter()
    others: list[Any] = []
    for drawn in drawn_claims(37, samples(48)):
        claim = drawn.judged().to_json()
        good, said = checked(claim)
        if not good:
            others.append((drawn, claim["verdict"], said))
        elif claim["verdict"] in DECIDED:
            repeated[NOT_AGAIN if said.startswith(NOT_AGAIN) else claim["verdict"]] += 1
    assert others == []
    assert min(repeated[verdict] for verdict in DECIDED) >= samples(3), repeated
    assert repeated[NOT_AGAIN] <= samples(2), repeated


@pytest.mark.parametrize(
    ("kind", "latex", "domain", "wanted"),
    [
        # refuted for one whole number, where it is true on a part
        (
            "identity",
            r"\frac{d x^n}{dx} = n x^{n-1}",
            r"0 \leq x < 2, n \geq 0",
            "refuted",
        ),
        ("identity", r"x^n = x", r"x > 0, n \geq 1", "refuted"),
        # seen at points alone
        ("inequality", r"\sin x + \sin 2 x < 1", r"0 < x < 3", "refuted"),
        ("inequality", r"e^x > x + 3/2", r"0 < x < 3", "refuted"),
        # in two directions, and in places
        ("equivalence", r"x y > 0 \iff y > 0", r"x > 0", "proved"),
        (
            "inequality",
            r"\frac{d (y^2)^{3/4}}{dy} \leq 2",
            r"-1 < y < 1",
            "proved",
        ),
        (
            "inequality",
            r"\frac{d (y^2)^{3/4}}{dy} \neq 0",
            r"-1 < y < 1",
            "conditional",
        ),
        (
            "inequality",
            r"\frac{d \sqrt{y^2}}{dy} \leq 2",
            r"-1 < y < 1",
            "conditional",
        ),
    ],
)
def test_single_claims(kind: str, latex: str, domain: str, wanted: str) -> None:
    claim = judged(kind, f"latex = '{latex}'\ndomain = '{domain}'").to_json()
    assert claim["verdict"] == wanted, claim["reason"]
    good, said = checked(claim)
    assert good, said
    assert said != NOT_AGAIN


def test_an_altered_part_is_rejected() -> None:
    fields = "latex = '\\frac{d (y^2)^{3/4}}{dy} \\leq 2'\ndomain = '-1 < y < 1'"
    claim = judged("inequality", fields).to_json()
    certificate = claim["evidence"]["certificate"]
    assert set(certificate) >= {"elsewhere", "at y = 0"}
    for name in ("elsewhere", "at y = 0"):
        statement = certificate[name]["statement"]
        turned = [{**rel, "operator": ">"} for rel in statement["relations"]]
        part = {**certificate[name], "statement": {**statement, "relations": turned}}
        altered = {**claim["evidence"], "certificate": {**certificate, name: part}}
        good, said = checked({**claim, "evidence": altered})
        assert not good
        assert f"{name}: wanted proved" in said
