"""Steady covariances of a filter with free gains: the Lyapunov equation solved."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.polynomial import Poly, constant
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.fixed_gain.closed_loop import Loop, Polys
from gainproof.verify.judge.fixed_gain.rational_system import solved

Pair = tuple[int, int]


@dataclass(frozen=True)
class Covariance:
    """A predicted and the updated covariance, in units T = 1; entries are rational functions of the
    gains.
    """

    predicted: tuple[tuple[Expr, ...], ...]
    updated: tuple[tuple[Expr, ...], ...]


def from_measurement(loop: Loop) -> Covariance:
    """Under measurement noise of variance 1 alone: P = A P A' + F K (F K)' for the prediction,
    (I - K H) P (I - K H)' + K K' for the update. Raises Undecided.
    """
    gains = [loop.ring.gen(i) for i in range(loop.size)]
    source = _outer(loop.predictor)
    (numerators,) = _lyapunov(loop, [source])
    return _covariance(loop, numerators, _outer(gains))


def from_process(loop: Loop, pairs: Sequence[Pair]) -> list[Covariance]:
    """Under process noise alone, one for each pair: of a noise with entries 1 there and at its
    mirror, 0 elsewhere. Raises Undecided.
    """
    zero, one = constant(loop.ring, 0), constant(loop.ring, 1)
    indices = range(loop.size)
    sources = [
        tuple(tuple(one if (i, j) in (p, p[::-1]) else zero for j in indices) for i in indices)
        for p in pairs
    ]
    nothing = tuple(tuple(zero for _ in indices) for _ in indices)
    return [_covariance(loop, numerators, nothing) for numerators in _lyapunov(loop, sources)]


def _lyapunov(loop: Loop, sources: Sequence[Polys]) -> list[list[Poly]]:
    """The upper entries of P = A P A' + source, as numerators before their denominator; put into
    the equation, they must satisfy it. Raises Undecided.
    """
    a, size = loop.closed, loop.size
    pairs = _pairs(size)
    one, zero = constant(loop.ring, 1), constant(loop.ring, 0)
    rows = []
    for i, j in pairs:
        row = []
        for p, s in pairs:
            moved = a[i][p] * a[j][s] + (a[i][s] * a[j][p] if p != s else zero)
            row.append((one if (i, j) == (p, s) else zero) - moved)
        rows.append(row)
    found = solved(rows, [[source[i][j] for i, j in pairs] for source in sources])
    for numerators, source in zip(found, sources, strict=True):
        below = numerators[-1]
        whole = _filled(numerators, size)
        again = _product(_product(a, whole), _transposed(a))
        for i in range(size):
            for j in range(size):
                if not (again[i][j] + source[i][j] * below - whole[i][j]).is_zero():
                    raise Undecided("the covariance that was found is not the steady one")
    return found


def _covariance(loop: Loop, numerators: list[Poly], added: Polys) -> Covariance:
    size, below = loop.size, numerators[-1]
    whole = _filled(numerators, size)
    one, zero = constant(loop.ring, 1), constant(loop.ring, 0)
    left = tuple(
        tuple(
            (one if i == j else zero) - loop.ring.gen(i) * constant(loop.ring, loop.measurement[j])
            for j in range(size)
        )
        for i in range(size)
    )
    after = _product(_product(left, whole), _transposed(left))
    updated = tuple(
        tuple(after[i][j] + added[i][j] * below for j in range(size)) for i in range(size)
    )
    return Covariance(_entries(loop, whole, below), _entries(loop, updated, below))


def _entries(loop: Loop, matrix: Polys, below: Poly) -> tuple[tuple[Expr, ...], ...]:
    found = {(i, j): loop.quotient(matrix[i][j], below) for i, j in _pairs(loop.size)}
    indices = range(loop.size)
    return tuple(tuple(found[min(i, j), max(i, j)] for j in indices) for i in indices)


def _pairs(size: int) -> list[Pair]:
    return [(i, j) for i in range(size) for j in range(i, size)]


def _filled(numerators: list[Poly], size: int) -> Polys:
    entries = dict(zip(_pairs(size), numerators, strict=False))
    return tuple(tuple(entries[min(i, j), max(i, j)] for j in range(size)) for i in range(size))


def _outer(vector: Sequence[Poly]) -> Polys:
    return tuple(tuple(x * y for y in vector) for x in vector)


def _transposed(a: Polys) -> Polys:
    return tuple(zip(*a, strict=True))


def _product(a: Polys, b: Polys) -> Polys:
    return tuple(
        tuple(
            sum((x * y for x, y in zip(row, column, strict=True)), 0 * row[0])
            for column in zip(*b, strict=True)
        )
        for row in a
    )
