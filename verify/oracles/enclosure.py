"""A rigorous enclosure of the steady state with any number of measured quantities.

Independent because it knows the matrices F, Q, H, R, an approximation M0 that doubling found, and
a theorem; no spectrum and no closed form enters, and nothing rests on the approximation being
good. With Phi the Riccati map, K(M) the gain and L(M) = F (I - K(M) H), for symmetric M and M0

    Phi(M) - Phi(M0) = L(M) (M - M0) L(M0)'

exactly. So M = M0 + E is a fixed point when E = C[r + (L(M0 + E) - L(M0)) E L(M0)'], where
r = Phi(M0) - M0 and C is the inverse of E -> E - L(M0) E L(M0)'. The right side is computed in
balls for a whole box of E: if it lies inside the box, there is a fixed point in it (Brouwer). If
some power of L, computed for the whole box, has a norm below one, the fixed point is a
stabilising solution of the Riccati equation; that there is no more than one is the textbook
theorem, cited. (A box round zero meets the symmetric E in a convex set that the right side maps
into symmetric ones, so that the fixed point is symmetric.) Exact numbers go in, balls that contain
the solution come out.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import flint

from gainproof.verify.oracles import doubling
from gainproof.verify.oracles.closed_loop import Unresolved
from gainproof.verify.oracles.matrices import Matrix
from gainproof.verify.oracles.multiprecision import bits_for, fraction
from gainproof.verify.oracles.state_space import NotConverged, StateSpace, SteadyState

# digits beyond those asked for, since small entries of an update are differences of large ones
GUARD = 20
LONGEST = 4000


def enclose(model: StateSpace, digits: int = 40) -> SteadyState:
    """Balls of relative radius at most 10^-digits round every entry of the steady state.

    Raises NotConverged when that is not reached (an entry may be zero), or where doubling finds
    no solution.
    """
    aimed = digits + GUARD
    while aimed <= LONGEST:
        start = doubling.steady_state(model, aimed).state.predicted
        # the start is taken exactly; products of its entries have three times its digits
        with flint.ctx.workprec(3 * bits_for(aimed) + 200):
            try:
                return _enclose(model, start, bits_for(digits))
            except (Unresolved, ZeroDivisionError):
                aimed *= 2
    raise NotConverged(f"no enclosure of every entry to {digits} digits")


def _enclose(model: StateSpace, start: Matrix, wanted: int) -> SteadyState:
    f, q, h, r = (
        _balls(x)
        for x in (
            model.transition,
            model.process_noise,
            model.measurement,
            model.measurement_noise,
        )
    )
    n = model.size
    unit = _balls([[Fraction(i == j) for j in range(n)] for i in range(n)])

    def gain(predicted: Any) -> Any:
        cross = predicted * h.transpose()
        return cross * (h * cross + r).inv()

    def loop(predicted: Any) -> Any:
        return f * (unit - gain(predicted) * h)

    middle = _balls([[fraction(x) for x in row] for row in start])
    first = loop(middle)
    residual = first * middle * f.transpose() + q - middle
    inverse = _lyapunov(first).inv()
    box = _box(inverse * _column(residual), middle)
    change = residual + (loop(middle + box) - first) * box * first.transpose()
    image = inverse * _column(change)
    if not all(_column(box)[i, 0].contains_interior(image[i, 0]) for i in range(n * n)):
        raise Unresolved
    predicted = middle + _square(image, n)
    _require_stable(loop(predicted))
    k = gain(predicted)
    kept = unit - k * h
    state = SteadyState(
        *(
            tuple(tuple(row) for row in x.tolist())
            for x in (predicted, kept * predicted, k, h * predicted * h.transpose() + r)
        )
    )
    if any(entry.rel_accuracy_bits() < wanted for entry in state.entries().values()):
        raise Unresolved
    return state


def _lyapunov(a: Any) -> Any:
    """The matrix of E -> E - A E A' on the entries of E, row after row."""
    n, rows = a.nrows(), a.tolist()
    pairs = [(i, j) for i in range(n) for j in range(n)]
    return flint.arb_mat(
        [[int((i, j) == (k, m)) - rows[i][k] * rows[j][m] for k, m in pairs] for i, j in pairs]
    )


def _box(correction: Any, middle: Any) -> Any:
    """Balls round zero, twice as wide as the first correction and never of width zero."""
    n = middle.nrows()
    least = flint.arb(2) ** -(flint.ctx.prec // 2)
    widths = [
        [2 * correction[i * n + j, 0].abs_upper() + least * abs(middle[i, j]) for j in range(n)]
        for i in range(n)
    ]
    return flint.arb_mat([[flint.arb(0, x.abs_upper()) for x in row] for row in widths])


def _require_stable(loop: Any) -> None:
    power = loop
    for _ in range(flint.ctx.prec):
        largest = [sum((abs(x) for x in row), flint.arb(0)) for row in power.tolist()]
        if all(bool(total < 1) for total in largest):
            return
        if not all(total.is_finite() for total in largest):
            break
        power = power * power
    raise Unresolved


def _column(a: Any) -> Any:
    return flint.arb_mat([[x] for row in a.tolist() for x in row])


def _square(column: Any, n: int) -> Any:
    return flint.arb_mat([[column[i * n + j, 0] for j in range(n)] for i in range(n)])


def _balls(rows: Any) -> Any:
    return flint.arb_mat(
        [[flint.arb(flint.fmpq(x.numerator, x.denominator)) for x in row] for row in rows]
    )
