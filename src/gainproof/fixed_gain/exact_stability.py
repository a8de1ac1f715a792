"""Whether a filter with matrix gains is stable, decided exactly for the floats given.

Floats are rational numbers: the characteristic polynomial of F (I - K H) comes in integers by
Faddeev and LeVerrier, and the test of Schur and Cohn says whether all its roots lie inside the unit
circle. Nothing is rounded. For n coordinates it takes some 16 n^4 products of long integers.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import gcd, lcm

import numpy as np

from gainproof.fixed_gain.arguments import Reals


def stable(position_gain: Reals, velocity_gain: Reals, interval: float) -> bool:
    """Whether all eigenvalues of F (I - K H) have moduli below 1.

    position_gain: K1, velocity_gain: K2, both n x n and finite; interval: T above 0.
    """
    return schur(closed_loop_polynomial(position_gain, velocity_gain, interval))


def closed_loop_polynomial(
    position_gain: Reals, velocity_gain: Reals, interval: float
) -> tuple[int, ...]:
    """Coefficients of a multiple of det(z I - F (I - K H)), the leading one first and above 0."""
    size = len(position_gain)
    step = Fraction(interval)
    first = [[Fraction(x) for x in row] for row in position_gain.tolist()]
    second = [[step * Fraction(x) for x in row] for row in velocity_gain.tolist()]
    # velocities times T: F is I, I over 0, I, and K is K1 over T K2
    rows = []
    for i in range(size):
        one = [Fraction(i == j) for j in range(size)]
        rows.append([one[j] - first[i][j] - second[i][j] for j in range(size)] + one)
    for i in range(size):
        one = [Fraction(i == j) for j in range(size)]
        rows.append([-x for x in second[i]] + one)
    common = lcm(*(x.denominator for row in rows for x in row))
    matrix = np.array([[int(x * common) for x in row] for row in rows], dtype=object)
    # of the matrix times `common`: its roots are those wanted times `common`
    found = _characteristic(matrix)
    order = 2 * size
    return tuple(c * common ** (order - k) for k, c in enumerate(found))


def _characteristic(matrix: np.ndarray[tuple[int, int], np.dtype[np.object_]]) -> list[int]:
    """det(z I - M) of integers, leading coefficient first."""
    order = len(matrix)
    one = np.array([[int(i == j) for j in range(order)] for i in range(order)], dtype=object)
    found, power = [1], one
    for k in range(1, order + 1):
        product = matrix @ power
        last = -int(np.trace(product)) // k  # k divides it
        found.append(last)
        power = product + last * one
    return found


def schur(polynomial: Sequence[int]) -> bool:
    """Whether all roots have moduli below 1 (Schur and Cohn); coefficients, leading one first.

    The last coefficient must be the smaller of the two ends; then (a_0 p - a_n p*)/z, of one degree
    less, has all its roots inside exactly where p has. A root on the circle is not inside.
    """
    left = list(polynomial)
    while len(left) > 1:
        top, end = left[0], left[-1]
        if not abs(end) < abs(top):
            return False
        left = [
            top * a - end * b for a, b in zip(left[:-1], list(reversed(left))[:-1], strict=True)
        ]
        shared = gcd(*left)
        left = [a // shared for a in left]
    return True


def determinant(matrix: Reals) -> Fraction:
    """Of a square matrix of finite floats."""
    exact = [[Fraction(x) for x in row] for row in matrix.tolist()]
    common = lcm(*(x.denominator for row in exact for x in row))
    whole = np.array([[int(x * common) for x in row] for row in exact], dtype=object)
    order = len(whole)
    return Fraction((-1) ** order * _characteristic(whole)[-1], common**order)
