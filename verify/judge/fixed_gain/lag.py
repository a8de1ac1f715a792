"""Lags of a filter with free gains: what its errors come to without noise.

For a target whose derivative of order m is constant, its state of n components moves as
x(k+1) = F x(k) + u(k), where u(k) holds the derivatives from n on: a polynomial of degree m - n in
k. The errors of the prediction satisfy e(k+1) = A e(k) + u(k); of a stable filter they approach the
one polynomial in k that satisfies this too, whatever they start from. It is a constant for m <= n;
beyond, the error grows without bound.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import comb, factorial

from gainproof.verify.judge.exact.expression import Expr, number, symbol, whole_power
from gainproof.verify.judge.exact.polynomial import Poly, constant
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.fixed_gain.closed_loop import Loop
from gainproof.verify.judge.fixed_gain.rational_system import solved
from gainproof.verify.judge.setting.environment import SAMPLE
from gainproof.verify.judge.setting.matrices import Numbers

MOST_ORDER = 3


@dataclass(frozen=True)
class Lag:
    """True minus predicted, and true minus updated state, of a target with a constant derivative 1
    of some order, in units T = 1, once the start is forgotten. Derivatives from the number of
    states on, below the constant one, are 0 at sample 0.
    """

    predicted: tuple[Expr, ...]
    updated: tuple[Expr, ...]


def is_taylor(transition: Numbers) -> bool:
    """Whether states are position, velocity and so on, carried on by Taylor's formula."""
    return all(
        entry == (Fraction(1, factorial(j - i)) if j >= i else 0)
        for i, row in enumerate(transition)
        for j, entry in enumerate(row)
    )


def lag(loop: Loop, order: int) -> Lag:
    """The lag for a target whose derivative of this order is constant. Raises Undecided."""
    size, context = loop.size, loop.ring
    if not is_taylor(loop.transition):
        raise Undecided("lags of a filter whose states are no position with its derivatives")
    degree = max(order - size, 0)
    matrix = [
        [constant(context, int(i == j)) - loop.closed[i][j] for j in range(size)]
        for i in range(size)
    ]
    driven = _driven(size, order)
    below = constant(context, 1)
    parts: dict[int, list[Poly]] = {}
    # coefficient of k^r: e_r - A e_r = u_r - sum over s > r of binom(s, r) e_s, all over `below`
    for r in range(degree, -1, -1):
        right = []
        for i in range(size):
            known = constant(context, driven[r][i]) * below
            for s in range(r + 1, degree + 1):
                known = known - parts[s][i] * comb(s, r)
            right.append(known)
        (found,) = solved(matrix, [right])
        *tops, det = found
        parts = {s: [p * det for p in entries] for s, entries in parts.items()}
        parts[r] = tops
        below = below * det
    _check(loop, parts, driven, below)
    predicted = [
        _polynomial([loop.quotient(parts[r][i], below) for r in range(degree + 1)])
        for i in range(size)
    ]
    after = {r: _updated(loop, entries) for r, entries in parts.items()}
    updated = [
        _polynomial([loop.quotient(after[r][i], below) for r in range(degree + 1)])
        for i in range(size)
    ]
    return Lag(tuple(predicted), tuple(updated))


def _driven(size: int, order: int) -> list[list[Fraction]]:
    """u by power of k and component: the derivative of order j at sample k is
    k^(order-j) / (order-j)!, and it moves component i by one part in (j-i)!.
    """
    degree = max(order - size, 0)
    found = [[Fraction(0)] * size for _ in range(degree + 1)]
    for j in range(size, order + 1):
        for i in range(size):
            found[order - j][i] += Fraction(1, factorial(order - j) * factorial(j - i))
    return found


def _check(
    loop: Loop, parts: dict[int, list[Poly]], driven: list[list[Fraction]], below: Poly
) -> None:
    """e(k+1) = A e(k) + u(k) for every power of k. Raises Undecided."""
    for r in range(len(driven)):
        for i in range(loop.size):
            rest = sum((a * e for a, e in zip(loop.closed[i], parts[r], strict=True)), 0 * below)
            rest = rest + constant(loop.ring, driven[r][i]) * below
            for s in range(r, len(driven)):
                rest = rest - parts[s][i] * comb(s, r)
            if not rest.is_zero():
                raise Undecided("the lag that was found does not satisfy the recursion of errors")


def _updated(loop: Loop, entries: Sequence[Poly]) -> list[Poly]:
    seen = sum(
        (constant(loop.ring, h) * e for h, e in zip(loop.measurement, entries, strict=True)),
        0 * entries[0],
    )
    return [e - loop.ring.gen(i) * seen for i, e in enumerate(entries)]


def _polynomial(coefficients: Sequence[Expr]) -> Expr:
    found: Expr | None = None
    for power_of_k, c in enumerate(coefficients):
        if c == number(0):
            continue
        term = c * whole_power(symbol(SAMPLE), power_of_k) if power_of_k else c
        found = term if found is None else found + term
    return number(0) if found is None else found
