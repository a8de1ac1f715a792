"""The doubling's own checks are seen to fail: a wrong run is never returned as converged."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from gainproof.verify.oracles import doubling
from gainproof.verify.oracles.matrices import matrix, scale
from gainproof.verify.oracles.riccati import in_numbers, update
from gainproof.verify.oracles.state_space import NotConverged, StateSpace, SteadyState

MODEL = StateSpace(
    matrix([[1, 1], [0, 1]], Fraction),
    matrix([[0, 0], [0, 1]], Fraction),
    matrix([[1, 0]], Fraction),
    ((Fraction(1),),),
)
honest = doubling._run


def spoil(monkeypatch: pytest.MonkeyPatch, factor: Any) -> None:
    """Make every run return a predicted covariance multiplied by factor(bits)."""

    def run(model: StateSpace, bits: int) -> SteadyState:
        state = honest(model, bits)
        own = state.predicted[0][0].context
        numbers = in_numbers(model, lambda x: own.mpf(x.numerator) / x.denominator)
        return update(numbers, scale(own.mpf(factor(bits)), state.predicted))

    monkeypatch.setattr(doubling, "_run", run)
    monkeypatch.setattr(doubling, "LARGEST_PRECISION", 2000)


def test_an_error_common_to_all_precisions_is_caught_by_the_newton_step(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    spoil(monkeypatch, lambda _: 1 + 2.0**-50)
    with pytest.raises(NotConverged, match=r"runs differ by 0\.0e\+00|Newton correction [1-9]"):
        doubling.steady_state(MODEL)


def test_an_error_that_changes_with_the_precision_is_caught_by_the_repetition(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    spoil(monkeypatch, lambda bits: 1 + bits * 2.0**-50)
    with pytest.raises(NotConverged, match=r"runs differ by [1-9]"):
        doubling.steady_state(MODEL)


def test_without_spoiling_the_same_path_succeeds(monkeypatch: pytest.MonkeyPatch) -> None:
    spoil(monkeypatch, lambda _: 1)
    assert doubling.steady_state(MODEL).bits <= doubling.LARGEST_PRECISION


def test_a_loop_that_does_not_shrink_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(NotConverged, match="does not shrink"):
        doubling._require_stable(matrix([[1, 1], [0, 1]], Fraction), 8)
    doubling._require_stable(matrix([[Fraction(9, 10), 5], [0, Fraction(9, 10)]]), 8)
