"""Changed definitions with which a claim is seen to fail at a point are not tried to be proved."""

from __future__ import annotations

import pytest
from claim_texts import MODELS, algebra, claim_file, judged

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.convention import Convention, conventions
from gainproof.verify.judge.repair import definition, definition_chains
from gainproof.verify.judge.repair.definition import FAR_POINTS, far_points
from gainproof.verify.judge.repair.printed_formula import printed
from gainproof.verify.judge.repair.proof import standing
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import Environment

BOUNDED = algebra(
    "'n' = { unit = '1', domain = 'n > 0', meaning = 'a number' }\n"
    "'c' = { unit = '1', domain = 'c > 0', meaning = 'another' }\n"
    "'g' = { definition = '\\frac{n}{1 + n} + \\frac{c}{8 n (2 + n)}', meaning = 'a gain' }\n"
)


def test_changed_definitions_are_seen_to_fail_before_a_proof_is_tried(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    tried: list[str] = []

    def counted(claim: Claim, setting: Setting, environment: Environment) -> str | None:
        tried.append(claim.id)
        return standing(claim, setting, environment)

    monkeypatch.setattr(definition, "standing", counted)
    (verdict, *_) = judged(
        BOUNDED,
        ("inequality", r"g < 1"),
        ("equivalence", r"g < 1 \Leftrightarrow c (1 + n) < 8 n (2 + n)"),
    )
    assert verdict.verdict == "conditional"
    assert "would be proved" not in verdict.reason
    assert not tried


@pytest.mark.parametrize(("body", "denied"), [("n", True), ("c", True), ("1 + c", False)])
def test_equivalence_holds_where_both_parts_do_or_neither(body: str, denied: bool) -> None:
    found = claim_file(BOUNDED, [("equivalence", r"g < 1 + n \Leftrightarrow c < n")])
    convention = next(iter(conventions(found.settings["s"], MODELS, {})))
    assert isinstance(convention, Convention)
    scope = Scope(convention.setting, convention.environment)
    bodies = definition_chains.printed_bodies(convention.setting)
    points = {"c0": far_points(found.claims[0], "g", convention)}
    assert len(points["c0"]) == FAR_POINTS
    chain = definition_chains.Chain("g", found.claims, points, scope, bodies)
    read = claim_file(BOUNDED, [("identity", f"g = {body}")]).claims[0].formula
    assert read is not None
    side = printed(read.readings[0]).sides[1]
    assert chain.is_denied(side) is denied
    assert chain.agrees(side) is not denied


def test_definition_that_decides_where_a_claim_holds_is_not_denied_by_points() -> None:
    claims = [("inequality", r"c > n \quad (g > c)"), ("inequality", "c > n")]
    found = claim_file(BOUNDED, claims)
    convention = next(iter(conventions(found.settings["s"], MODELS, {})))
    assert isinstance(convention, Convention)
    decided, free = (far_points(c, "g", convention) for c in found.claims)
    assert not decided
    assert free
