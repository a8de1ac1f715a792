"""Steps on the start of a track from its first two positions."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.recursion.names import Q, R, T, shear_matrix, sheared, start_names, symmetric
from gainproof.derive.recursion.noise import Noise
from gainproof.derive.recursion.steps_update import rest
from gainproof.derive.relation import Relation, equal


def start_steps(noises: tuple[Noise, ...]) -> list[Step]:
    """The covariance after two positions, whatever the velocity was thought to be."""
    first, *others = (_start(noise) for noise in noises)
    name, relation = first
    return [
        *(_noise(noise) for noise in noises),
        Step(
            name,
            "A track starts from two positions an interval `t` apart: the second one is the "
            "position, their difference over `t` the velocity. That is the update with the gains 1 "
            "and `1/t`, and its covariance does not depend on the variance `x` that the velocity "
            "was given before. Its factors `d1`, `u`, `d2`, for the three noises in turn:",
            relation,
            "Joseph's form (step @joseph) with these gains; `(I - K H) F` has zeros in the column "
            "of the velocity. These gains are the limit of the Kalman gains as `x` grows.",
            tower="start",
            heading="The start",
        ),
        *(joined(other, found, tower="start") for other, found in others),
        *(joined(f"{_key(noise)}-start-factors", _shown(noise), tower="start") for noise in noises),
    ]


def _noise(noise: Noise) -> Step:
    """The process noise once more, over the parameters of the start: its names are tied there too.

    The step on a continuous noise shows that these entries are its integral.
    """
    return Step(
        f"{_key(noise)}-start-noise",
        "The same process noise, over the parameters of this part.",
        equal(symmetric(f"{noise.name}_noise"), noise.covariance),
        f"As in step @{_key(noise)}-noise.",
        tower="start",
        shown=False,
    )


def _start(noise: Noise) -> tuple[str, Relation]:
    move, left = shear_matrix(T), rest(sp.Integer(1), 1 / T)
    before = sp.ImmutableDenseMatrix([[R, 0], [0, real("x")]])
    predicted = move * before * move.T + symmetric(f"{noise.name}_noise")
    gain = sp.ImmutableDenseMatrix([[1], [1 / T]])
    first, shear, second = map(real, start_names(noise))
    relation = equal(
        sheared(first, shear, second),
        sp.MatAdd(
            sp.MatMul(left, predicted, left.T, evaluate=False),
            sp.MatMul(R, gain, gain.T, evaluate=False),
            evaluate=False,
        ),
        free=("x",),
    )
    return f"{_key(noise)}-start", relation


def _shown(noise: Noise) -> Relation:
    """The factors as they are read."""
    rate, gained = R / T**2, sp.Rational(str(noise.chord)) * noise.velocity(Q, T)
    total = 2 * rate + gained
    names = sp.ImmutableDenseMatrix([[real(name) for name in start_names(noise)]])
    values = (R * (rate + gained) / total, R / T / total, total)
    return equal(names, sp.ImmutableDenseMatrix([values]))


def _key(noise: Noise) -> str:
    return noise.name.replace("_", "-")
