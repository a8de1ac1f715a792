"""Steady quantities of filters with free gains, in multiprecision numbers: covariances by a
Kronecker product, lags by the fixed point of the errors, stability by eigenvalues.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import comb, factorial
from typing import Any

import mpmath
from mutation.arithmetic import real

from claim_campaign.compare import FINE
from claim_campaign.point import NotCovered
from claim_campaign.quantities import Place
from gainproof.verify.judge.claim.record import Setting

BASES = ("filter_gain.", "target_motion.")
"""Beginnings of the quantities that are drawn like free numbers; the others follow from them."""
BORDER = mpmath.mpf(10) ** -12
ROUNDING = mpmath.mpf(10) ** -300


def drawn_always(setting: Setting) -> set[str]:
    """Symbols of free gains and of the target's motion: all else follows from them."""
    if setting.kind != "fixed_gain":
        return set()
    return {t for t, e in setting.symbols.items() if (e.quantity or "").startswith(BASES)}


def loop_of(gains: Sequence[Any]) -> tuple[Any, Any]:
    """F and F (I - K H) of a kinematic filter whose position is measured, T = 1."""
    size = len(gains)
    transition = mpmath.matrix(size, size)
    for i in range(size):
        for j in range(i, size):
            transition[i, j] = real(1) / factorial(j - i)
    left = mpmath.eye(size)
    for i, gain in enumerate(gains):
        left[i, 0] -= gain
    return transition, transition * left


def radius(gains: Sequence[Any]) -> Any:
    """The largest absolute value of a pole, to sixteen digits."""
    with mpmath.workdps(30):
        values, _ = mpmath.eig(loop_of([mpmath.mpf(g) for g in gains])[1])
        return max(abs(value) for value in values)


def covariances(gains: Sequence[Any]) -> tuple[Any, Any]:
    """Predicted and updated, under measurement noise of variance 1, T = 1."""
    with mpmath.workdps(FINE):
        size = len(gains)
        transition, loop = loop_of(gains)
        column = mpmath.matrix([[gain] for gain in gains])
        driven = transition * column
        whole = mpmath.eye(size * size)
        source = mpmath.matrix(size * size, 1)
        for i in range(size):
            for j in range(size):
                source[i * size + j] = driven[i] * driven[j]
                for p in range(size):
                    for q in range(size):
                        whole[i * size + j, p * size + q] -= loop[i, p] * loop[j, q]
        entries = mpmath.lu_solve(whole, source)
        predicted = mpmath.matrix(size, size)
        for i in range(size):
            for j in range(size):
                predicted[i, j] = entries[i * size + j]
        left = transition**-1 * loop
        return predicted, left * predicted * left.T + column * column.T


def lags(gains: Sequence[Any], order: int, sample: Any) -> tuple[list[Any], list[Any]]:
    """True minus predicted and minus updated state for a derivative 1 of this order, T = 1: the
    polynomial in the sample number that the errors approach, found power by power.
    """
    with mpmath.workdps(FINE):
        size = len(gains)
        _, loop = loop_of(gains)
        degree = max(order - size, 0)
        parts: dict[int, Any] = {}
        for r in range(degree, -1, -1):
            right = mpmath.matrix(size, 1)
            for i in range(size):
                j = order - r
                if j >= size:
                    right[i] = real(1) / (factorial(r) * factorial(j - i))
                for s in range(r + 1, degree + 1):
                    right[i] -= comb(s, r) * parts[s][i]
            parts[r] = mpmath.lu_solve(mpmath.eye(size) - loop, right)
        before = [sum(parts[r][i] * sample**r for r in parts) for i in range(size)]
        after = [e - gain * before[0] for e, gain in zip(before, gains, strict=True)]
        return before, after


def steady(setting: Setting, place: Place, free: Mapping[str, Any]) -> dict[str, Any]:
    """By name of the quantity, for values of the drawn symbols; without what only a stable filter
    has where this one is not. Raises NotCovered for matrices of the source's own.
    """
    if setting.gain_matrices:
        raise NotCovered("free gains of own matrices")
    interval, deviation = real(place.interval), real(place.deviation)
    sample = real(int(place.parameter))
    known = {"sampling_interval": interval, "sample_number": sample}
    known |= {"measurement_noise_deviation": deviation}
    known["measurement_noise_variance"] = deviation**2
    values = {setting.symbols[token].quantity: value for token, value in free.items()}
    names = [f"filter_gain.{i + 1}" for i in range(setting.states or 0)]
    if any(name not in values for name in names):
        return known
    gains = [values[name] for name in names]
    if radius(gains) < 1 - BORDER:
        with mpmath.workdps(FINE):
            known |= _covariances(gains, interval, deviation)
            for order in range(4):
                # of a motion that no symbol stands for, one value is as good as another
                motion = values.get(f"target_motion.{order}", real(3))
                known |= _lags(gains, order, motion, interval, sample)
    return known


def _covariances(gains: Sequence[Any], interval: Any, deviation: Any) -> dict[str, Any]:
    predicted, updated = covariances(gains)
    found = {"innovation_variance": (predicted[0, 0] + 1) * deviation**2}
    for which, matrix in (("predicted", predicted), ("updated", updated)):
        for i in range(len(gains)):
            for j in range(len(gains)):
                entry = matrix[i, j] * deviation**2 / interval ** (i + j)
                found[f"{which}_covariance.{i + 1}.{j + 1}"] = entry
    return found


def _lags(
    gains: Sequence[Any], order: int, motion: Any, interval: Any, sample: Any
) -> dict[str, Any]:
    found = {}
    for which, errors in zip(("predicted", "updated"), lags(gains, order, sample), strict=True):
        for i, error in enumerate(errors):
            # what is zero comes out as a rounding error
            kept = error if abs(error) > ROUNDING else real(0)
            found[f"{which}_lag.{i + 1}.{order}"] = kept * motion * interval ** (order - i)
    return found
