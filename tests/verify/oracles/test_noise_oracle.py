"""Integrated process noise against integrals known in closed form."""

from __future__ import annotations

from typing import Any

import mpmath
import pytest

from gainproof.verify.oracles import noise
from gainproof.verify.oracles.matrices import Matrix


def near(found: Matrix, expected: list[list[Any]], tolerance: float = 1e-38) -> bool:
    return all(
        abs(x - mpmath.mpf(y)) <= tolerance * max(1, abs(y))
        for row, known in zip(found, expected, strict=True)
        for x, y in zip(row, known, strict=True)
    )


def mp(p: int, q: int) -> mpmath.mpf:
    with mpmath.workdps(60):
        return mpmath.mpf(p) / q


def test_white_acceleration_of_two_states() -> None:
    found = noise.white(*noise.chain(2), interval=3)
    with mpmath.workdps(60):
        assert near(found, [[9, mp(9, 2)], [mp(9, 2), 3]])
        assert not near(found, [[9, mp(9, 2)], [mp(9, 2), 3 + mp(1, 10**30)]])


def test_white_jerk_of_three_states() -> None:
    found = noise.white(*noise.chain(3))
    with mpmath.workdps(60):
        assert near(
            found,
            [
                [mp(1, 20), mp(1, 8), mp(1, 6)],
                [mp(1, 8), mp(1, 3), mp(1, 2)],
                [mp(1, 6), mp(1, 2), 1],
            ],
        )


def test_acceleration_held_over_the_interval() -> None:
    with mpmath.workdps(60):
        assert near(noise.held(*noise.chain(2)), [[mp(1, 4), mp(1, 2)], [mp(1, 2), 1]])


def test_jump_at_the_end_of_the_interval() -> None:
    assert noise.increment(noise.chain(2)[1]) == ((0, 0), (0, 1))


def test_a_decaying_motion_whose_exponential_is_no_polynomial() -> None:
    with mpmath.workdps(60):
        decay = (1 - mpmath.exp(-4)) / 2
        assert near(noise.white([[-1]], [[1]], interval=2), [[decay]])
        assert near(noise.held([[-1]], [[1]], interval=2), [[(1 - mpmath.exp(-2)) ** 2]])
        assert near(noise.transition([[-1]], 2), [[mpmath.exp(-2)]])
        turn = noise.transition([[0, 1], [-1, 0]], 1)
        assert near(turn, [[mpmath.cos(1), mpmath.sin(1)], [-mpmath.sin(1), mpmath.cos(1)]])


def test_no_noise_is_mistaken_for_another() -> None:
    kinds = [
        noise.white(*noise.chain(2)),
        noise.held(*noise.chain(2)),
        noise.increment(noise.chain(2)[1]),
    ]
    for i, one in enumerate(kinds):
        for other in kinds[:i]:
            assert abs(float(one[0][0]) - float(other[0][0])) > 0.01


def test_an_empty_matrix_is_refused() -> None:
    with pytest.raises(ValueError, match="rows of one positive length"):
        noise.white([], [[1]])
