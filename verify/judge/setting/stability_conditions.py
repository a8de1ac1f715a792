"""Conditions for all roots of a real polynomial to lie in the left half plane or the unit circle.

Hurwitz: with a positive leading coefficient all coefficients and all Hurwitz determinants are
positive exactly if all roots have negative real parts. The map z = (1 + w) / (1 - w) takes the left
half plane of w to the inside of the unit circle of z. F. R. Gantmacher, Applications of the Theory
of Matrices, 1959, chapter V.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import comb

from gainproof.verify.judge.exact.expression import Expr, number, weighted
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.meaning.square_matrices import determinant

HIGHEST = 5


def circle_moved(known: Sequence[Expr]) -> list[Expr]:
    """Coefficients of (1 - w)^n p((1 + w) / (1 - w)), from power 0 up.

    Its highest coefficient is (-1)^n p(-1), positive where all roots of a polynomial with positive
    leading coefficient lie inside the unit circle.
    """
    degree = len(known) - 1
    weights = [[0] * (degree + 1) for _ in range(degree + 1)]  # of power k of w in that of p_j
    for j in range(degree + 1):
        for a in range(j + 1):
            for b in range(degree - j + 1):
                weights[a + b][j] += comb(j, a) * comb(degree - j, b) * (-1) ** b
    return [weighted(row, known) for row in weights]


def left_half_plane(known: Sequence[Expr]) -> list[Rel]:
    """That all roots have negative real parts, for coefficients from power 0 up. Raises Undecided
    beyond degree HIGHEST.
    """
    degree = len(known) - 1
    if degree > HIGHEST:
        raise Undecided(f"the place of roots of polynomials beyond degree {HIGHEST}")
    zero = number(0)
    found = [Rel(">", c, zero) for c in reversed(known)]
    for size in range(2, degree):
        rows = [[_entry(known, degree - 1 - 2 * c + r) for c in range(size)] for r in range(size)]
        found.append(Rel(">", determinant(tuple(map(tuple, rows))), zero))
    return found


def _entry(known: Sequence[Expr], k: int) -> Expr:
    return known[k] if 0 <= k < len(known) else number(0)
