"""What the pages of two and three states share and the program works out for each of them."""

from __future__ import annotations

from typing import Any

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import WORDS, Loop, listed, lyapunov, lyapunov_map, pairs, row
from gainproof.derive.fixed_gain.process_noise import NOISE, inverse, symmetric_of

Slots = dict[str, Any]
Z, K = real("z"), real("k")
STATE, OBSERVED = (tuple(map(real, (f"{x}1", f"{x}2", f"{x}3"))) for x in "sz")
MOTIONS = (*WORDS, "jerk", "snap")
SAID: dict[int, Slots] = {
    2: {
        "kept": "position and velocity",
        "corrected": "`alpha`, `beta/t`",
        "velocity_words": "the predicted velocity",
        "parts": "a proportional part `alpha` and an integral part `beta`",
        "controller": "hence PI",
        "motions": "at rest, at constant velocity",
    },
    3: {
        "kept": "position, velocity and acceleration",
        "corrected": "`alpha`, `beta/t`, `gamma/t^2`",
        "velocity_words": "the mean velocity of the interval",
        "parts": "a proportional part, an integral part and the integral of an integral",
        "controller": "but with one more integral",
        "motions": "at rest, at constant velocity, at constant acceleration",
    },
}


def page_slots(loop: Loop, lecture: sp.Expr) -> Slots:
    """The slots of a page by name; `lecture`: the variance of the predicted position there."""
    return {
        **SAID[loop.size],
        "states": ", ".join(map(str, STATE[: loop.size])),
        "gains": ", ".join(loop.gain_names),
        "order": str(loop.size),
        **_answer(loop),
        **_variance(loop, lecture),
        **_lag(loop),
    }


def _numerators(loop: Loop) -> list[sp.Expr]:
    """What stands over c(z) in the transfer functions to the smoothed state."""
    system = sp.Matrix(Z * sp.eye(loop.size) - loop.smoothed)
    answer = system.adjugate(method="berkowitz") * sp.Matrix(Z * loop.column)
    return [sp.expand(x) for x in answer]


def _answer(loop: Loop) -> Slots:
    """How a filter answers its one input: transfer functions, sums of sums, recursion."""
    size, polynomial, numerators = loop.size, loop.polynomial(Z), _numerators(loop)
    sums = [Z / (Z - 1), Z / (Z - 1) ** 2, Z * (Z + 1) / (2 * (Z - 1) ** 3)]
    top = _weighed(loop.gains, sums)
    command = _weighed(loop.gains, [sp.Integer(1), 1 / (Z - 1), (Z + 1) / (2 * (Z - 1) ** 2)])
    parts = [top, _weighed(loop.gains[1:], sums), *[loop.gains[-1] * sums[0]] * (size - 2)]
    states = [sp.ImmutableDenseMatrix(STATE[:size])]
    for entry in OBSERVED[:size]:
        states.append(sp.ImmutableDenseMatrix(loop.smoothed * states[-1] + loop.column * entry))
    feedback = [-x for x in sp.Poly(polynomial, Z).all_coeffs()[1:]]
    forward = [sp.Poly(x, Z).all_coeffs() for x in numerators]
    seen = list(reversed(OBSERVED[:size]))
    recursion = [
        _weighed(feedback, [x[n] for x in reversed(states[:-1])]) + _weighed(forward[n], seen)
        for n in range(size)
    ]
    return {
        "collected": sp.collect(polynomial, Z),
        "transfer": sp.ImmutableDenseMatrix([sp.factor(x) / polynomial for x in numerators]),
        "sums": sp.ImmutableDenseMatrix(parts),
        "position_answer": top,
        "command": command,
        "seen": ", ".join(map(str, OBSERVED[:size])),
        "two_samples": states[-1],
        "recursion": sp.ImmutableDenseMatrix(recursion),
    }


def _weighed(weights: Any, values: Any) -> sp.Expr:
    return sum((w * x for w, x in zip(weights, values, strict=False)), sp.Integer(0))


def _variance(loop: Loop, lecture: sp.Expr) -> Slots:
    """Steady covariances: of the measurements' noise, and of any process noise beside."""
    above, below = inverse(loop)
    size, names = loop.size, [f"{NOISE}_{ij}" for ij in pairs(loop.size)]
    noise = sp.ImmutableDenseMatrix(list(map(real, names)))
    entries = [sp.collect(sp.expand(x), list(noise)) for x in above * noise]
    seen = loop.transition * loop.column * loop.column.T * loop.transition.T
    matrix = symmetric_of(size, [real(f"predicted_{ij}") for ij in pairs(size)])
    return {
        "map": lyapunov_map(loop),
        "above": above,
        "below": below,
        "diagonal": (below * sp.eye(len(names))).as_immutable(),
        "listed": row(*listed(matrix)),
        "solution": row(*listed(lyapunov(loop, seen))),
        "lecture": lecture,
        "noise": noise,
        "noise_entries": sp.ImmutableDenseMatrix(entries),
        "noise_names": ", ".join(f"q{ij}" for ij in pairs(size)),
        "noise_matrix": symmetric_of(size, [x / below for x in entries]),
    }


def _lag(loop: Loop) -> Slots:
    """The steady error behind the first constant derivative that is not foreseen, and the next."""
    size = loop.size
    found: Slots = {
        "target": _stacked([_true(size, p, K) for p in range(size)]),
        "target_next": _stacked([_true(size, p, K + 1) for p in range(size)]),
        "last": loop.gains[-1],
        "last_name": loop.gain_names[-1],
        "motion": MOTIONS[size],
        "far_motion": MOTIONS[size + 1],
        "far_order": str(size + 1),
    }
    for prefix, order in (("lag", size), ("far", size + 1)):
        error = _steady_error(loop, order)
        found |= {
            f"{prefix}_error": error,
            f"{prefix}_ahead": error.subs(K, K + 1).as_immutable(),
            f"{prefix}_unforeseen": _unforeseen(loop, order).as_immutable(),
            f"{prefix}_smoothed": (loop.rest * error).applyfunc(
                lambda x, degree=order - size: _by_time(x, degree)
            ),
            f"{prefix}_rate": sp.Subs(error[0], K, K + 1) - error[0],
        }
    return found


def _true(size: int, order: int, time: sp.Expr) -> list[sp.Expr]:
    return [
        time ** (order - n) / sp.factorial(order - n) if order >= n else sp.Integer(0)
        for n in range(size)
    ]


def _stacked(columns: list[list[sp.Expr]]) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix(columns).T.as_immutable()


def _unforeseen(loop: Loop, order: int) -> sp.ImmutableDenseMatrix:
    """What a target does in one interval beyond the prediction: x(k + 1) - F x(k)."""
    ahead = sp.Matrix(_true(loop.size, order, K + 1))
    return (ahead - loop.transition * sp.Matrix(_true(loop.size, order, K))).applyfunc(sp.expand)


def _steady_error(loop: Loop, order: int) -> sp.ImmutableDenseMatrix:
    """The polynomial e(k) with e(k + 1) = A e(k) + w(k): what every error tends to."""
    degree = order - loop.size
    names = [[sp.Symbol(f"e{n}_{d}") for d in range(degree + 1)] for n in range(loop.size)]
    error = sp.Matrix([sum(x * K**d for d, x in enumerate(line)) for line in names])
    left = error.subs(K, K + 1) - loop.closed * error - _unforeseen(loop, order)
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
