"""Covariance at the end of a track by least squares over the whole of it, all at once.

Independent because there is no recursion: the unknowns are the state at the start and every
disturbance in between, the normal equations of all measurements together are inverted once, and
the state at the end is a linear function of the unknowns. Nothing is predicted, no gain occurs. In
fractions it is exact; the work grows like the cube of the track's length.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from gainproof.verify.oracles.matrices import (
    Matrix,
    add,
    identity,
    product,
    scale,
    solve,
    symmetric,
    transpose,
)


@dataclass(frozen=True)
class Move:
    """From one time to the next: x' = F x + G w, var w = W, definite."""

    transition: Matrix
    shape: Matrix
    disturbance: Matrix


def last_covariance(
    start: Matrix, moves: Sequence[Move], measured: Sequence[bool], row: Matrix, variance: Any
) -> Matrix:
    """Covariance of the state at the last time, all measurements taken in.

    start: covariance at the first time, nothing measured yet. measured: at which times (one more
    than moves) H x + v, var v = variance, is known. Raises ValueError for lists that do not fit.
    """
    if len(measured) != len(moves) + 1:
        raise ValueError(f"{len(moves)} moves need {len(moves) + 1} times, got {len(measured)}")
    blocks = [start, *(move.disturbance for move in moves)]
    sizes = [len(block) for block in blocks]
    total = sum(sizes)
    information = [[0 * start[0][0]] * total for _ in range(total)]
    place = 0
    for block in blocks:
        inverse = solve(block, identity(len(block), block[0][0] / block[0][0]))
        for i, entries in enumerate(inverse):
            information[place + i][place : place + len(block)] = list(entries)
        place += len(block)
    normal: Matrix = tuple(map(tuple, information))
    now = _columns(identity(sizes[0], start[0][0] / start[0][0]), 0, total)
    place = sizes[0]
    for number, seen in enumerate(measured):
        if seen:
            sight = product(row, now)
            normal = add(normal, scale(1 / variance, product(transpose(sight), sight)))
        if number < len(moves):
            move = moves[number]
            now = add(product(move.transition, now), _columns(move.shape, place, total))
            place += len(move.disturbance)
    return symmetric(product(now, solve(normal, transpose(now))))


def _columns(block: Matrix, place: int, total: int) -> Matrix:
    """A block among zeros, from a column on."""
    zero = 0 * block[0][0]
    width = len(block[0])
    return tuple((zero,) * place + row + (zero,) * (total - place - width) for row in block)
