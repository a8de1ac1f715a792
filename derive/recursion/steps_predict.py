"""Steps on the prediction over any interval, one process noise after the other."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.recursion.names import (
    D1,
    D2,
    ENTRIES,
    Q,
    T,
    U,
    predicted_names,
    shear_matrix,
    sheared,
    symmetric,
)
from gainproof.derive.recursion.noise import Noise
from gainproof.derive.relation import equal, positive

TITLES = {
    "random_velocity": "Prediction, random velocity",
    "random_acceleration": "Prediction, random acceleration",
    "continuous_white_acceleration": "Prediction, continuous white acceleration",
}


def shift_step() -> Step:
    """What F alone does."""
    return Step(
        "shift",
        "Without process noise a prediction adds the interval to `u` and changes nothing else: "
        "that is why the covariance is kept so.",
        equal(
            sp.MatMul(shear_matrix(T), sheared(D1, U, D2), shear_matrix(T).T, evaluate=False),
            sheared(D1, U + T, D2),
        ),
        "The product of two shears is the shear by the sum (step @intervals-add).",
    )


def predict_steps(noise: Noise) -> list[Step]:
    """Noise over an interval, and the prediction with it."""
    key = noise.name.replace("_", "-")
    first, shear, second = map(real, predicted_names(noise))
    noisy = symmetric(f"{noise.name}_noise")
    moved = sp.MatMul(shear_matrix(T), symmetric("covariance"), shear_matrix(T).T, evaluate=False)
    own = noise.floor and f"`q t^3/{1 / noise.floor}` of its own and "
    return [
        *(_integral(noise, key) if noise.continuous else [_square(noise, key)]),
        _over_two(noise, key),
        Step(
            f"{key}-prediction",
            f"The predicted covariance `M = F P F' + Q` has factors `e1`, `w` and `e2`. The "
            f"velocity's variances add; the new shear is the mean of `u + t` and "
            f"{'`t/2`' if noise.share else '0'}, weighed by them; the position's rest gains "
            f"{own or ''}the spread of the two.",
            equal(
                _row(first, shear, second),
                _row(*_shown(noise)),
            ),
            "The two sheared covariances `F P F'` (step @shift) and `Q` "
            f"(step @{key}-noise) are added: `a (x - y)^2` is what a mean of `x` and `y` leaves.",
        ),
        Step(
            f"{key}-prediction-proof",
            "That is the textbook's prediction.",
            equal(
                sheared(first, shear, second),
                sp.MatAdd(moved, noisy, evaluate=False),
            ),
            "Insert both sides and multiply out.",
        ),
        joined(
            f"{key}-predicted",
            equal(symmetric(f"{noise.name}_predicted"), sheared(first, shear, second)),
        ),
        Step(
            f"{key}-definite",
            "Its factors stay above zero.",
            positive(first),
            "There is no minus sign.",
        ),
        joined(f"{key}-definite-velocity", positive(second)),
    ]


def _shown(noise: Noise) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """The predicted factors as they are read, in the velocity's gain g."""
    gained = noise.velocity(Q, T)
    middle = T / 2 if noise.share else sp.Integer(0)
    own = noise.position(Q, T) or sp.Integer(0)
    spread = D2 * gained * (U + T - middle) ** 2 / (D2 + gained)
    return (
        D1 + own + spread,
        ((U + T) * D2 + middle * gained) / (D2 + gained),
        D2 + gained,
    )


def _row(*entries: sp.Expr) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix([entries])


def _square(noise: Noise, key: str) -> Step:
    shape = sp.ImmutableDenseMatrix([[0], [1]] if noise.power == 0 else [[T**2 / 2], [T]])
    return Step(
        f"{key}-noise",
        f"The process noise is {noise.words}.",
        equal(symmetric(f"{noise.name}_noise"), Q * shape * shape.T),
        "The square of what one unit of it does to position and velocity until the interval's "
        "end, times its variance.",
        heading=TITLES[noise.name],
    )


def _integral(noise: Noise, key: str) -> list[Step]:
    entries = [real(f"{noise.name}_noise_{ij}") for ij in ENTRIES]
    response = sp.ImmutableDenseMatrix([[T], [1]])
    square = Q * response * response.T
    flat = (square[0, 0], square[0, 1], square[1, 1])
    derivatives = _row(*(sp.Derivative(entry, T) for entry in entries))
    start = _row(*(sp.Subs(entry, T, sp.Integer(0)) for entry in entries))
    return [
        Step(
            f"{key}-noise",
            f"The process noise is {noise.words}.",
            equal(_row(*entries), _row(*noise_entries(noise))),
            "The integral over the interval of what enters at each instant and is carried on to "
            "its end: of `q [x; 1] [x, 1]` over `x` from 0 to `t`.",
            heading=TITLES[noise.name],
        ),
        Step(
            f"{key}-integral",
            "That it is this integral: its rate is the integrand, and it starts from zero.",
            equal(derivatives, _row(*flat)),
            "Differentiate; put `t = 0`.",
        ),
        joined(f"{key}-integral-start", equal(start, _row(*[sp.Integer(0)] * 3))),
    ]


def noise_entries(noise: Noise) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Entries 11, 12 and 22 over q and t."""
    matrix = noise.covariance
    return matrix[0, 0], matrix[0, 1], matrix[1, 1]


def _over_two(noise: Noise, key: str) -> Step:
    """What two intervals do, against one of both together."""
    s = real("s")
    matrix = noise.covariance
    first, both = matrix.subs(T, s), matrix.subs(T, s + T)
    after = sp.MatMul(shear_matrix(T), first, shear_matrix(T).T, evaluate=False)
    if noise.continuous:
        return Step(
            f"{key}-two-intervals",
            "Any interval means any: two predictions, one after the other, are one over the sum "
            "of their intervals.",
            equal(both, sp.MatAdd(after, matrix, evaluate=False)),
            "Multiply out; with step @intervals-add the same holds for `F P F' + Q`.",
            tower="intervals",
        )
    less = sp.ImmutableDenseMatrix(
        (shear_matrix(T) * first * shear_matrix(T).T + matrix - both).applyfunc(sp.factor)
    )
    words = {
        0: "one more sample is one more increment. So an interval is that between two samples, and "
        "a prediction to a time without a sample, or a missed one, is one increment too many or "
        "too few by choice",
        2: "an acceleration that is drawn twice disturbs less than one that lasts. So an interval "
        "is that between two draws, and to cut it in two is to say that another acceleration is "
        "drawn in between",
    }
    return Step(
        f"{key}-two-intervals",
        f"This noise belongs to the samples, not to the time: {words[noise.power]}. Two intervals "
        "differ from one of both together by:",
        equal(sp.MatAdd(after, matrix, -both, evaluate=False), less),
        "Multiply out.",
        tower="intervals",
    )
