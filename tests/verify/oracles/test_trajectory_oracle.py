"""Least squares over a whole track against the recursion, exactly, and what it refuses."""

from __future__ import annotations

from fractions import Fraction

import pytest

from gainproof.verify.oracles.matrices import Matrix, add, matrix, product, transpose
from gainproof.verify.oracles.riccati import predict, update
from gainproof.verify.oracles.state_space import StateSpace
from gainproof.verify.oracles.trajectory import Move, last_covariance

ROW = matrix([[1, 0]], Fraction)
R = Fraction(3, 7)
START = matrix([["5/2", "1/3"], ["1/3", 2]], Fraction)


def move(t: Fraction, whole: bool) -> Move:
    """A disturbance through one shape, or one with a definite matrix of its own."""
    transition = ((Fraction(1), t), (Fraction(0), Fraction(1)))
    if whole:
        noise = ((t**3 / 3, t**2 / 2), (t**2 / 2, t))
        return Move(transition, matrix([[1, 0], [0, 1]], Fraction), noise)
    return Move(transition, ((t**2 / 2,), (t,)), ((Fraction(2),),))


def by_recursion(moves: list[Move], measured: list[bool]) -> Matrix:
    covariance = START
    for number, seen in enumerate(measured):
        model = StateSpace(START, START, ROW, ((R,),))
        if seen:
            covariance = update(model, covariance).updated
        if number < len(moves):
            each = moves[number]
            noise = product(each.shape, each.disturbance, transpose(each.shape))
            covariance = predict(StateSpace(each.transition, noise, ROW, ((R,),)), covariance)
    return covariance


@pytest.mark.parametrize("whole", [True, False])
@pytest.mark.parametrize("missed", [(), (2,), (0, 3), (5,), (0, 1, 2, 3, 4, 5)])
def test_the_batch_is_the_recursion(whole: bool, missed: tuple[int, ...]) -> None:
    moves = [move(Fraction(1 + k * k % 5, 3), whole) for k in range(5)]
    measured = [k not in missed for k in range(6)]
    found = last_covariance(START, moves, measured, ROW, R)
    assert found == by_recursion(moves, measured)
    if len(missed) < 6:
        assert found != last_covariance(START, moves, measured, ROW, R + 1)
        assert found != last_covariance(add(START, START), moves, measured, ROW, R)


def test_lists_that_do_not_fit() -> None:
    with pytest.raises(ValueError, match="1 moves need 2 times, got 1"):
        last_covariance(START, [move(Fraction(1), True)], [True], ROW, R)
