"""Steps on the prediction of three states over any interval, one noise after the other."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.recursion.triple_names import (
    PLACES,
    Q,
    T,
    filled,
    predicted_names,
    sheared,
    symmetric,
    transition,
)
from gainproof.derive.recursion.triple_noise import TripleNoise
from gainproof.derive.relation import equal, positive

TITLES = {
    "acceleration_increments": "Prediction, acceleration increments",
    "wiener_acceleration": "Prediction, acceleration through t^2/2, t, 1",
    "random_jerk": "Prediction, jerk constant over the interval",
    "continuous_white_jerk": "Prediction, continuous white jerk",
}
SHAPES = {
    "acceleration_increments": [0, 0, 1],
    "wiener_acceleration": [T**2 / 2, T, 1],
    "random_jerk": [T**3 / 6, T**2 / 2, T],
}


def predict_steps(noise: TripleNoise) -> list[Step]:
    """Noise over an interval, and the prediction with it."""
    key = noise.name.replace("_", "-")
    names = tuple(map(real, predicted_names(noise)))
    move = transition(T)
    moved = sp.MatMul(move, symmetric("covariance"), move.T, evaluate=False)
    first, *others = (
        (f"{key}-positive-{place}", positive(name)) for place, name in enumerate(names, 1)
    )
    return [
        *(_integral(noise, key) if noise.continuous else [_square(noise, key)]),
        _over_two(noise, key),
        Step(
            f"{key}-prediction",
            "The predicted covariance `F P F' + Q` has the factors `e1`, `e2`, `e3` and the shears "
            "`alpha`, `beta`, `gamma` that the kernel computes: `e3` and the last row of `U` are "
            "means, `e2` and `e1` grow by the spread of what is averaged, and the minor that gives "
            "`gamma` is a sum of products.",
            equal(
                sheared(names),
                sp.MatAdd(moved, symmetric(f"{noise.name}_noise"), evaluate=False),
            ),
            "`F P F'` has the shears of a product of `F` and `U`; insert both sides and multiply "
            "out.",
            tower=noise.name,
        ),
        Step(
            first[0],
            "All six stay above zero: motion and this noise keep what the update needs.",
            first[1],
            "There is no minus sign, over an interval above zero.",
            tower=noise.name,
        ),
        *(joined(name, relation, tower=noise.name) for name, relation in others),
    ]


def _square(noise: TripleNoise, key: str) -> Step:
    shape = sp.ImmutableDenseMatrix([[entry] for entry in SHAPES[noise.name]])
    return Step(
        f"{key}-noise",
        f"The process noise is {noise.words}.",
        equal(symmetric(f"{noise.name}_noise"), Q * shape * shape.T),
        "The square of what one unit of it does until the interval's end, times its variance.",
        tower=noise.name,
        heading=TITLES[noise.name],
    )


def _integral(noise: TripleNoise, key: str) -> list[Step]:
    named = symmetric(f"{noise.name}_noise")
    response = sp.ImmutableDenseMatrix([[T**2 / 2], [T], [1]])
    square = Q * response * response.T
    return [
        Step(
            f"{key}-noise",
            f"The process noise is {noise.words}.",
            equal(named, noise.covariance),
            "The integral over the interval of what enters at each instant and is carried on to "
            "its end: of `q h h'` with `h = [x^2/2; x; 1]` over `x` from 0 to `t`.",
            tower=noise.name,
            heading=TITLES[noise.name],
        ),
        Step(
            f"{key}-integral",
            "That it is this integral: its rate is the integrand.",
            equal(
                _row(*(sp.Derivative(named[place], T) for place in PLACES)),
                _row(*(square[place] for place in PLACES)),
            ),
            "Differentiate; each entry has the factor `t`, and so starts from zero.",
            tower=noise.name,
        ),
    ]


def _row(*entries: sp.Expr) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix([entries])


def _over_two(noise: TripleNoise, key: str) -> Step:
    """What two intervals do, against one of both together."""
    s = real("s")
    matrix = noise.covariance
    first, both = matrix.subs(T, s), matrix.subs(T, s + T)
    after = sp.MatMul(transition(T), first, transition(T).T, evaluate=False)
    if noise.continuous:
        return Step(
            f"{key}-two-intervals",
            "Any interval means any: two predictions, one after the other, are one over the sum "
            "of their intervals.",
            equal(both, sp.MatAdd(after, matrix, evaluate=False)),
            "Multiply out; with step @intervals-add the same holds for `F P F' + Q`.",
            tower="intervals",
        )
    apart = transition(T) * first * transition(T).T + matrix - both
    return Step(
        f"{key}-two-intervals",
        "This noise belongs to the samples, not to the time: to cut an interval in two is to say "
        "that something else is drawn in between. Two intervals differ from one of both together "
        "by:",
        equal(
            sp.MatAdd(after, matrix, -both, evaluate=False),
            filled([sp.factor(apart[place]) for place in PLACES]),
        ),
        "Multiply out.",
        tower="intervals",
    )
