"""Fading-memory polynomial filters: least squares over all samples of the past with a polynomial of
degree 0 to 3, in which a sample that is j samples old has the weight theta^j, 0 < theta < 1.

With phi(j)' = H F^-j the normal matrix is J = sum over j >= 0 of theta^j phi(j) phi(j)'. Its closed
form comes from sum of theta^j j^m, each the derivative of the one before, times theta. What makes
it the normal matrix is J = theta F^-T J F^-1 + H'H, shown identically in theta: as theta < 1 and
all eigenvalues of F are 1, there is one such matrix. Then the batch obeys J x = theta F^-T J
x_before + H'y, which the recursion with the gain K = J^-1 H' solves.

Of white noise of variance 1 the estimate J^-1 sum theta^j phi(j) y has the covariance J^-1 N J^-1,
where N is J with theta^2 in place of theta. A target whose derivative of order n, the number of
states, is 1 and constant lies t^n / n! off the polynomial that is fitted: its fit is the lag.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import comb, factorial

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated, substituted
from gainproof.verify.judge.exact.expression import Expr, number, power, symbol, whole_power
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.fixed_gain.rational_system import lowest
from gainproof.verify.judge.meaning.square_matrices import determinant, inverse
from gainproof.verify.judge.setting.environment import WEIGHT, Fact
from gainproof.verify.judge.setting.growing_memory import (
    MOST_DEGREE,
    first,
    of_recursion,
    shown_of,
    taylor,
)
from gainproof.verify.judge.setting.matrices import Exprs, exprs, minus, plus, times, transposed
from gainproof.verify.judge.setting.steady_state_conditions import characteristic

WITHIN = Box(lower=Fraction(0), upper=Fraction(1))
THETA = symbol(WEIGHT)


@dataclass(frozen=True)
class FadingMemory:
    """In units T = 1, measurement noise variance 1; expressions of theta. Lags are those of a
    target whose derivative of the order of the number of states is 1; `closed_loop` are the
    coefficients of z^0 and so on in the polynomial of the poles.
    """

    transition: Exprs
    gain: tuple[Expr, ...]
    updated: Exprs
    predicted: Exprs
    updated_lag: tuple[Expr, ...]
    predicted_lag: tuple[Expr, ...]
    closed_loop: tuple[Expr, ...]
    facts: tuple[Fact, ...]


def fading_memory(degree: int) -> FadingMemory:
    """Gain, covariances and lags, established. Raises Undecided beyond degree 3."""
    if not 0 <= degree <= MOST_DEGREE:
        raise Undecided(f"a fading memory of degree {degree} is not covered")
    size = degree + 1
    sums = _power_sums(2 * size)
    j = _rows([[_moment(sums, a, b) for b in range(size)] for a in range(size)])
    turned = inverse(j)
    assert isinstance(turned, tuple), "the inverse of a matrix"
    back = _rows(turned)
    gain = tuple(row[0] for row in back)
    other = _rows([[substituted(e, {WEIGHT: power(THETA, 2)}) for e in row] for row in j])
    updated = _rows(times(times(back, other), back))
    f = exprs(taylor(size, 1))
    predicted = _rows(times(times(f, updated), transposed(f)))
    column = tuple((_moment(sums, a, size),) for a in range(size))
    updated_lag = tuple(lowest(-row[0], (WEIGHT,)) for row in times(back, column))
    # the state that is not followed moves on by its own part in each component
    driven = tuple((number(Fraction(1, factorial(size - i))),) for i in range(size))
    moved = plus(times(f, tuple((e,) for e in updated_lag)), driven)
    predicted_lag = tuple(lowest(row[0], (WEIGHT,)) for row in moved)
    closed = tuple(
        number((-1) ** (size - i) * comb(size, i)) * whole_power(THETA, size - i)
        for i in range(size)
    )

    def shown(sentence: str, entries: Exprs, operator: str = "=") -> Fact:
        return shown_of(WEIGHT, {WEIGHT: WITHIN}, sentence, entries, operator)

    kept = minus(exprs(taylor(size, 0)), times(tuple((g,) for g in gain), first(size)))
    again = plus(
        times(times(kept, predicted), transposed(kept)),
        tuple(tuple(a * b for b in gain) for a in gain),
    )
    loop = tuple(characteristic(times(f, kept)))
    after = times(kept, tuple((e,) for e in predicted_lag))
    minors = tuple(determinant(tuple(row[:n] for row in j[:n])) for n in range(1, size + 1))
    before = tuple(tuple(THETA * e for e in row) for row in j)
    facts = (
        *of_recursion("J = theta F^-T J F^-1 + H'H", j, before, back, shown),
        shown("J is positive definite", (minors,), ">"),
        shown("all poles lie at theta", minus((loop,), (closed,))),
        shown("X = (I - K H) F X F' (I - K H)' + K K'", minus(updated, again)),
        shown(
            "the lag of the update is I - K H times that of the prediction",
            minus(tuple((e,) for e in updated_lag), after),
        ),
    )
    return FadingMemory(f, gain, updated, predicted, updated_lag, predicted_lag, closed, facts)


def _power_sums(count: int) -> list[Expr]:
    """The sums over j >= 0 of theta^j j^m for m = 0 to count - 1."""
    found = [1 / (1 - THETA)]
    while len(found) < count:
        found.append(lowest(THETA * differentiated(found[-1], WEIGHT), (WEIGHT,)))
    return found


def _moment(sums: Sequence[Expr], a: int, b: int) -> Expr:
    """The sum of theta^j (-j)^a / a! (-j)^b / b!."""
    return number(Fraction((-1) ** (a + b), factorial(a) * factorial(b))) * sums[a + b]


def _rows(matrix: Sequence[Sequence[Expr]]) -> Exprs:
    """The entries in lowest terms."""
    return tuple(tuple(lowest(e, (WEIGHT,)) for e in row) for row in matrix)
