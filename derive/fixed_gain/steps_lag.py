"""Steps on the steady error behind a target that moves otherwise than predicted."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import Loop, product, total
from gainproof.derive.fixed_gain.steps_answer import Z
from gainproof.derive.relation import equal

K = real("k")
MOTIONS = ("position", "velocity", "acceleration", "jerk", "snap")


def lag_steps(loop: Loop) -> list[Step]:
    """Every motion with one constant derivative, from rest to the one beyond the first lag."""
    size = loop.size
    steps = [
        Step(
            "target",
            "A target whose derivative of order `p` is constant, all lower ones being 0 at sample "
            f"0, is at `k^p/p!`. For orders below {size} (at rest, at constant velocity"
            f"{', at constant acceleration' if size == 3 else ''}) it moves as predicted:",
            equal(
                _stacked([_true(size, p, K + 1) for p in range(size)]),
                product(loop.transition, _stacked([_true(size, p, K) for p in range(size)])),
                free=("k",),
            ),
            "Binomial theorem, row by row; the columns are the orders.",
            heading="Lag",
        ),
        Step(
            "no-lag",
            "So the error of the prediction obeys `e(k + 1) = A e(k)`, whose only steady solution "
            "is 0: no lag, in any output.",
            equal(sp.Subs(loop.polynomial(Z), Z, sp.Integer(1)), loop.gains[-1], free=("z",)),
            "`det(I - A) = c(1)`, which is not 0; by step @stable every start is forgotten.",
        ),
    ]
    return [*steps, *_lag(loop, size), *_lag(loop, size + 1)]


def _true(size: int, order: int, time: sp.Expr) -> list[sp.Expr]:
    return [
        time ** (order - n) / sp.factorial(order - n) if order >= n else sp.Integer(0)
        for n in range(size)
    ]


def _stacked(columns: list[list[sp.Expr]]) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix(columns).T.as_immutable()


def unforeseen(loop: Loop, order: int) -> sp.ImmutableDenseMatrix:
    """What a target does in one interval beyond the prediction: x(k + 1) - F x(k)."""
    ahead = sp.Matrix(_true(loop.size, order, K + 1))
    return (ahead - loop.transition * sp.Matrix(_true(loop.size, order, K))).applyfunc(sp.expand)


def steady_error(loop: Loop, order: int) -> sp.ImmutableDenseMatrix:
    """The polynomial e(k) with e(k + 1) = A e(k) + w(k): what every error tends to."""
    degree = order - loop.size
    names = [[sp.Symbol(f"e{n}_{d}") for d in range(degree + 1)] for n in range(loop.size)]
    error = sp.Matrix([sum(x * K**d for d, x in enumerate(line)) for line in names])
    left = error.subs(K, K + 1) - loop.closed * error - unforeseen(loop, order)
    equations = [c for x in left for c in sp.Poly(sp.expand(x), K).all_coeffs()]
    solved = sp.solve(equations, [x for line in names for x in line], dict=True)[0]
    return error.subs(solved).applyfunc(lambda x: _by_time(x, degree)).as_immutable()


def _by_time(value: sp.Expr, degree: int) -> sp.Expr:
    polynomial = sp.Poly(sp.together(sp.expand(value)).as_numer_denom()[0], K)
    below = sp.together(sp.expand(value)).as_numer_denom()[1]
    return sum(
        (sp.factor(polynomial.coeff_monomial(K**d) / below) * K**d for d in range(degree + 1)),
        sp.Integer(0),
    )


def _lag(loop: Loop, order: int) -> list[Step]:
    size, motion = loop.size, MOTIONS[order]
    error = steady_error(loop, order)
    smoothed = (loop.rest * error).applyfunc(lambda x: _by_time(x, order - size))
    diverges = order > size
    free = ("k",) if diverges else ()
    ahead = error.subs(K, K + 1).as_immutable()
    last = loop.gain_names[-1]
    unit = f"times `t^{order}`, the {motion} being 1"
    sentence = (
        f"Behind a constant {motion} the error grows without limit, along a line `e(k)` ({unit}), "
        f"the position's by `1/{last}` a sample, whatever the filter."
        if diverges
        else f"Behind a constant {motion} the error of the prediction settles ({unit})."
    )
    steps = [
        Step(
            f"lag-{motion}",
            sentence,
            equal(
                ahead,
                total(product(loop.closed, error), unforeseen(loop, order).as_immutable()),
                free=free,
            ),
            "In one interval the target does `w = x(k + 1) - F x(k)` beyond the prediction, and "
            "`e(k + 1) = A e(k) + w(k)`. The difference of two solutions tends to 0 (step "
            "@stable).",
        ),
        Step(
            f"smoothed-lag-{motion}",
            "After the update, each entry:",
            equal(smoothed, product(loop.rest, error), free=free),
            "`(I - K H) e`.",
        ),
    ]
    if diverges:
        first = error[0]
        rate = sp.Subs(first, K, K + 1) - first
        steps.append(joined(f"lag-{motion}-rate", equal(rate, 1 / loop.gains[-1], free=free)))
    return steps
