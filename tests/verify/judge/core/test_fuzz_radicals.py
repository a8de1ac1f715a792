"""Random radical statements: no place may disagree with plain evaluation at random points."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
import radical_fuzz
from one_of_each import cases
from radical_fuzz import disagreements

from gainproof.verify.judge.exact import truth as truth_module
from gainproof.verify.judge.exact.statement import Rel


@pytest.mark.parametrize("seed", cases(range(4), lambda seed: seed < 2))
def test_no_disagreement(seed: int) -> None:
    wrong, verdicts = disagreements(seed, 60)
    assert not wrong
    assert verdicts["proved"] > 10
    assert verdicts["refuted"] + verdicts["conditional"] > 10


def test_the_comparison_sees_a_judge_that_errs(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = truth_module._holds

    def careless(work: object, local: object, rel: Rel, *, everywhere: bool) -> bool:
        shifted = replace(rel, operator={"<": "<=", ">": ">="}.get(rel.operator, rel.operator))
        work.differences[shifted] = work.differences[rel]  # type: ignore[attr-defined]
        work.split.add(shifted)  # type: ignore[attr-defined]
        return honest(work, local, shifted, everywhere=everywhere)  # type: ignore[arg-type]

    monkeypatch.setattr(truth_module, "_holds", careless)
    wrong, _ = disagreements(0, 60)
    assert wrong


def test_the_comparison_knows_the_difference() -> None:
    rel = Rel("=", radical_fuzz.X, radical_fuzz.X + 1)
    assert radical_fuzz.holds(rel, Fraction(1)) == "false"
