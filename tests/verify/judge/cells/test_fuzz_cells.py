"""Random statements in several parameters: no verdict may disagree with plain evaluation."""

from __future__ import annotations

import pytest
from cell_fuzz import disagreements
from samples import samples

from gainproof.verify.judge.cells.critical_polynomials import CellQuestion


@pytest.mark.sampled
@pytest.mark.parametrize(
    "seed", [0, *(pytest.param(seed, marks=pytest.mark.thorough) for seed in (1, 2))]
)
def test_no_disagreement(seed: int) -> None:
    wrong, verdicts = disagreements(seed, samples(40))
    assert not wrong
    assert min(verdicts[v] for v in ("proved", "refuted", "conditional")) > 3


def test_the_comparison_sees_an_engine_without_borders(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(CellQuestion, "borders", lambda _: [])
    assert any(disagreements(seed, 10)[0] for seed in range(15))
