"""Kernels of fixed gains against simulated tracks, at a stated rate of false alarms, and their lags
against long runs without noise.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import factorial
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from gainproof.generated import (
    acceleration_increments,
    alpha_beta,
    alpha_beta_gamma,
    random_acceleration,
    random_jerk,
    random_velocity,
    wiener_acceleration,
)
from gainproof.verify.oracles import monte_carlo

FALSE_ALARM = 1e-6
"""Of each test: how often true kernels would be contradicted, were other seeds taken."""
TRACKS = 20_000
FORGOTTEN = 1e-7
TWO = ((0.4571, 0.5), (0.8, 1.9), (0.3, 0.05))
THREE = ((0.5, 0.3, 0.4), (0.9, 1.2, 0.2), (0.4, 0.9, 0.9))
"""alpha, beta, share of the largest gamma."""
FURTHER = pytest.mark.thorough
GAINS = [
    *TWO[:2],
    THREE[0],
    *(pytest.param(gains, marks=FURTHER) for gains in (TWO[2], *THREE[1:])),
]


def covariance(result: Any, kind: str) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """The matrix of the outputs ``kind``_ij."""
    found = {name: float(value) for name, value in result._asdict().items()}
    size = 3 if f"{kind}_13" in found else 2
    if kind == "updated":
        # fixed gains leave it as it was: printed once
        found.setdefault("updated_33", found.get("predicted_33", 0.0))
    rows = [
        [found[f"{kind}_{min(i, j)}{max(i, j)}"] for j in range(1, size + 1)]
        for i in range(1, size + 1)
    ]
    return np.array(rows)


def gammas(gains: tuple[float, ...]) -> tuple[float, ...]:
    """The gains as a filter takes them: a share of the largest gamma becomes gamma."""
    if len(gains) == 2:
        return gains
    alpha, beta, share = gains
    return alpha, beta, 2 * alpha * beta * share / (2 - alpha)


def lags(gains: tuple[float, ...]) -> dict[str, list[float]]:
    """Predicted and updated, in the order of the states."""
    kernel: Any = (alpha_beta if len(gains) == 2 else alpha_beta_gamma).lags
    found = kernel(*gains)._asdict()
    return {
        kind: [float(value) for name, value in found.items() if name in wanted]
        for kind in ("predicted", "updated")
        for wanted in [
            {f"{kind}_{state}_lag" for state in ("position", "velocity", "acceleration")}
        ]
    }


@pytest.mark.parametrize("gains", GAINS)
def test_variances_and_lags(gains: tuple[float, ...]) -> None:
    """Behind a target that is pushed: the spread about the lag, and the lag."""
    used = gammas(gains)
    samples = monte_carlo.samples_to_forget(used, FORGOTTEN)
    errors = monte_carlo.run(used, samples, TRACKS, 11, push=0.7)
    module: ModuleType = alpha_beta if len(gains) == 2 else alpha_beta_gamma
    stated = module.variances(*gains)
    for kind, found in (("predicted", errors.predicted), ("updated", errors.updated)):
        known, mean = covariance(stated, kind), 0.7 * np.array(lags(gains)[kind])
        told = monte_carlo.contradictions(found, mean, known, FALSE_ALARM / 2)
        assert told == ()
        # a variance, a covariance and a lag that are wrong by little are contradicted
        for wrong in (known * 1.1, known * 0.9, known * (2 * np.eye(len(known)) - 1)):
            assert monte_carlo.contradictions(found, mean, wrong, FALSE_ALARM / 2)
        aside = mean + 0.1 * np.sqrt(known.diagonal())
        assert monte_carlo.contradictions(found, aside, known, FALSE_ALARM / 2)


@pytest.mark.parametrize("gains", [*TWO, *THREE])
def test_lags_in_a_long_run_without_noise(gains: tuple[float, ...]) -> None:
    used = gammas(gains)
    samples = 2 * monte_carlo.samples_to_forget(used, FORGOTTEN)
    stood = monte_carlo.standing_errors(used, samples)
    # each sample rounds the truth, which has grown to this; the loop forgets in its own time
    rounded = 4 * np.finfo(float).eps * samples ** len(used) / factorial(len(used)) * samples
    for kind, errors in zip(("predicted", "updated"), stood, strict=True):
        known = np.array(lags(gains)[kind])
        assert np.abs(errors - known).max() < rounded + FORGOTTEN**2 * np.abs(known).max()
        assert rounded < 1e-3 * np.abs(known).max()


NOISES: tuple[tuple[ModuleType, Sequence[Sequence[float]]], ...] = (
    (random_velocity, ((0, 0), (0, 1))),
    (random_acceleration, ((1 / 4, 1 / 2), (1 / 2, 1))),
    (acceleration_increments, ((0, 0, 0), (0, 0, 0), (0, 0, 1))),
    (wiener_acceleration, ((1 / 4, 1 / 2, 1 / 2), (1 / 2, 1, 1), (1 / 2, 1, 1))),
    (random_jerk, ((1 / 36, 1 / 12, 1 / 6), (1 / 12, 1 / 4, 1 / 2), (1 / 6, 1 / 2, 1))),
)


@pytest.mark.parametrize(
    ("family", "noise"),
    [
        pytest.param(
            *pair,
            id=pair[0].__name__.split(".")[-1],
            marks=() if pair[0] in (random_velocity, random_jerk) else FURTHER,
        )
        for pair in NOISES
    ],
)
def test_steady_covariances_with_process_noise(
    family: ModuleType, noise: Sequence[Sequence[float]]
) -> None:
    """The named filters on targets that are shaken as their models say."""
    index = 0.8
    gains = tuple(float(gain) for gain in family.gains(index))
    samples = monte_carlo.samples_to_forget(gains, FORGOTTEN)
    shaken = index**2 * np.array(noise)
    errors = monte_carlo.run(gains, samples, TRACKS, 12, process_noise=shaken)
    none = np.zeros(len(gains))
    for kind, found in (("predicted", errors.predicted), ("updated", errors.updated)):
        known = covariance(getattr(family, f"{kind}_covariance")(index), kind)
        assert monte_carlo.contradictions(found, none, known, FALSE_ALARM / 2) == ()
        assert monte_carlo.contradictions(found, none, known * 1.1, FALSE_ALARM / 2)
        # another strength of the noise is another covariance
        other = covariance(getattr(family, f"{kind}_covariance")(1.2 * index), kind)
        assert monte_carlo.contradictions(found, none, other, FALSE_ALARM / 2)
