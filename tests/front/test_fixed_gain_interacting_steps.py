"""Steps in three coordinates that interact: matrix products, exact fractions, errors by name."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from gainproof.fixed_gain import steps

UNIT = 2.0**-52
INTERACTING = 3.51
"""The bound of `generated/filter_step.py`, in these units over the sum of the terms' magnitudes."""


def interacting_case(count: int) -> tuple[Any, ...]:
    generator = np.random.default_rng(6)
    position, velocity, observed = generator.normal(size=(3, 3, count))
    first, second = generator.normal(size=(2, 3, 3))
    return position, velocity, generator.uniform(0.5, 3, count), observed, first, second


def test_interacting_steps_are_matrix_products() -> None:
    position, velocity, t, observed, first, second = interacting_case(100)
    found: Any = steps.step_interacting(position, velocity, t, observed, first, second)
    ahead = position + t * velocity
    innovation = observed - ahead
    assert np.asarray(found.position) == pytest.approx(ahead + first @ innovation, abs=1e-13)
    assert np.asarray(found.velocity) == pytest.approx(velocity + second @ innovation, abs=1e-13)
    many = np.repeat(first[:, :, None], 100, axis=2), np.repeat(second[:, :, None], 100, axis=2)
    again: Any = steps.step_interacting(position, velocity, t, observed, *many)
    assert (np.asarray(again.position) == found.position).all()


def test_interacting_steps_are_within_the_bound_over_their_terms() -> None:
    """Observations next to the prediction, where all innovations cancel; rows multiplied out."""
    position, velocity, t, _, first, second = interacting_case(40)
    observed = position + t * velocity
    found: Any = steps.step_interacting(position, velocity, t, observed, first, second)

    def dot(row: Any, values: Sequence[Fraction]) -> Fraction:
        pairs = zip(map(Fraction, row.tolist()), values, strict=True)
        return sum((a * b for a, b in pairs), Fraction(0))

    for k in range(40):
        x, v, z = ([Fraction(float(c)) for c in a[:, k]] for a in (position, velocity, observed))
        step_time = Fraction(float(t[k]))
        ahead = [a + step_time * b for a, b in zip(x, v, strict=True)]
        sizes = [abs(a) + step_time * abs(b) for a, b in zip(x, v, strict=True)]
        innovation = [c - a for c, a in zip(z, ahead, strict=True)]
        terms = [abs(c) + s for c, s in zip(z, sizes, strict=True)]
        for axis in range(3):
            for value, start, size, gain in (
                (found.position, ahead[axis], sizes[axis], first[axis]),
                (found.velocity, v[axis], abs(v[axis]), second[axis]),
            ):
                truth = start + dot(gain, innovation)
                scale = size + dot(np.abs(gain), terms)
                error = abs(Fraction(float(value[axis, k])) - truth)
                assert error <= scale * INTERACTING * UNIT


def test_diagonal_matrices_are_filters_of_their_own() -> None:
    position, velocity, t, observed, *_ = interacting_case(20)
    alpha, beta = np.array([0.4, 0.5, 0.6]), np.array([0.1, 0.2, 0.3])
    found: Any = steps.step_interacting(
        position, velocity, 2.0, observed, np.diag(alpha), np.diag(beta / 2)
    )
    own: Any = steps.step_two_states(
        position, velocity, 2.0, observed, alpha[:, None], beta[:, None]
    )
    assert np.asarray(found.position) == pytest.approx(np.asarray(own.position), rel=1e-14)
    assert np.asarray(found.velocity) == pytest.approx(np.asarray(own.velocity), rel=1e-14)
    assert t.shape == (20,)


def test_interacting_steps_in_place_and_with_missed_detections() -> None:
    position, velocity, t, observed, first, second = interacting_case(1000)
    seen = np.arange(1000) % 3 > 0
    wanted: Any = steps.step_interacting(position, velocity, t, observed, first, second, seen)
    blind = np.where(seen, observed, np.nan)
    x, v = position.copy(), velocity.copy()
    found: Any = steps.step_interacting(x, v, t, blind, first, second, seen, out=(x, v))
    assert found.position is x
    assert (x == wanted.position).all()
    assert (v == wanted.velocity).all()
    assert (x[:, ~seen] == (position + t * velocity)[:, ~seen]).all()
    assert (v[:, ~seen] == velocity[:, ~seen]).all()


@pytest.mark.parametrize(
    ("change", "error", "told"),
    [
        ({0: np.zeros((2, 5))}, ValueError, r"position must have axes of three .* got shape \(2, "),
        ({3: np.zeros(())}, ValueError, "observed must have axes of three"),
        ({4: np.zeros((3, 2))}, ValueError, r"position_gain must have axes of three"),
        ({5: np.zeros((2, 3))}, ValueError, r"velocity_gain must have axes of three"),
        ({2: 0.0}, ValueError, "interval must be a number at least 1e-10"),
        ({4: np.full((3, 3), np.nan)}, ValueError, "position_gain_11 must be"),
        ({1: [["a"], ["b"], ["c"]]}, TypeError, "x_velocity must be real numbers"),
    ],
)
def test_what_does_not_fit_is_named(
    change: dict[int, Any], error: type[Exception], told: str
) -> None:
    given = list(interacting_case(5))
    for place, value in change.items():
        given[place] = value
    with pytest.raises(error, match=told):
        steps.step_interacting(*given)


@pytest.mark.parametrize(
    ("out", "error", "told"),
    [
        ([1, 2], ValueError, "out must be a tuple of two arrays"),
        ((np.zeros((3, 5)), [1]), TypeError, "out velocity must be an array, got list"),
        ((np.zeros((3, 5)), np.zeros(3)), ValueError, r"out velocity must have shape \(3, ...\)"),
        ((np.zeros((3, 4)), np.zeros((3, 4))), ValueError, "must have shape"),
    ],
)
def test_outputs_that_do_not_fit_are_named(out: Any, error: type[Exception], told: str) -> None:
    with pytest.raises(error, match=told):
        steps.step_interacting(*interacting_case(5), out=out)
