"""Steps on the start of three states from the first three positions."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.recursion.triple_names import R, S, T, sheared, start_names, transition
from gainproof.derive.recursion.triple_noise import TripleNoise
from gainproof.derive.recursion.triple_start import named, newer, older, sights, weights
from gainproof.derive.relation import Relation, equal, positive

TOWER = "start"


def start_steps(noises: tuple[TripleNoise, ...]) -> list[Step]:
    """The covariance after three positions, whatever the state was thought to be."""
    rows, back = sights(), transition(-S)
    first, *others = (_start(noise) for noise in noises)
    zeros = [sp.Integer(0)] * 3
    return [
        Step(
            "start-sights",
            "A track starts from three positions `z0`, `z1` and `z2`, an interval `s` and then an "
            "interval `t` apart. Without process noise each shows the last state through one of "
            "these rows, the newest first. `W` is the inverse of the three rows: it turns "
            "`z2, z1, z0` into the parabola through them.",
            equal(sp.MatMul(named("w"), rows, evaluate=False), sp.eye(3).as_immutable()),
            "Multiply out. Row by row it is `H`, `H F(t)^-1` and `H F(s + t)^-1`. No other "
            "weights give the state for every state, and a filter of whose start nothing is known "
            "has to take these.",
            tower=TOWER,
            heading="The start",
        ),
        joined("start-weights", _rows("w", weights()), tower=TOWER),
        Step(
            "start-newer",
            "Noise `w` of the second interval shifts the older two positions against the last "
            "state, by `H F(t)^-1 w` and `H F(s + t)^-1 w`; the state is wrong by `-A w`.",
            equal(
                named("newer"),
                sp.MatMul(
                    named("w"),
                    sp.ImmutableDenseMatrix([zeros, list(rows[1, :]), list(rows[2, :])]),
                    evaluate=False,
                ),
            ),
            "The state before `w` is `F(t)^-1` times the last one less `w`.",
            tower=TOWER,
        ),
        joined("start-newer-entries", _rows("newer", newer()), tower=TOWER),
        Step(
            "start-older",
            "Noise of the first interval shifts the oldest position only, by `H F(s)^-1` times "
            "the noise; the state is wrong by `-B` times the noise.",
            equal(
                named("older"),
                sp.MatMul(
                    named("w"),
                    sp.ImmutableDenseMatrix([zeros, zeros, list(back[0, :])]),
                    evaluate=False,
                ),
            ),
            "As in step @start-newer.",
            tower=TOWER,
        ),
        joined("start-older-entries", _rows("older", older()), tower=TOWER),
        Step(
            first[0],
            "The errors of three measurements and the noises are independent: the covariance is "
            "`r W W' + A Q(t) A' + B Q(s) B'`. The kernels compute its factors, for the four "
            "noises in turn.",
            first[1],
            "Insert both sides and multiply out.",
            tower=TOWER,
        ),
        *(joined(name, relation, tower=TOWER) for name, relation in others),
        *_positive(noises),
    ]


def _start(noise: TripleNoise) -> tuple[str, Relation]:
    names = tuple(map(real, start_names(noise)))
    two, one, square = named("newer"), named("older"), named("w")
    relation = equal(
        sheared(names),
        sp.MatAdd(
            sp.MatMul(R, square, square.T, evaluate=False),
            sp.MatMul(two, noise.covariance, two.T, evaluate=False),
            sp.MatMul(one, noise.covariance.subs(T, S), one.T, evaluate=False),
            evaluate=False,
        ),
    )
    return f"{_key(noise)}-start", relation


def _rows(prefix: str, matrix: sp.ImmutableDenseMatrix) -> Relation:
    """What a matrix's named entries are; the first row has none."""
    return equal(named(prefix)[1:, :].as_immutable(), matrix[1:, :].as_immutable())


def _positive(noises: tuple[TripleNoise, ...]) -> list[Step]:
    """Every factor is a quotient without a minus sign."""
    named = [
        (f"{_key(noise)}-start-positive-{place}", positive(real(name)))
        for noise in noises
        for place, name in enumerate(start_names(noise), 1)
    ]
    return [
        Step(
            named[0][0],
            "All six factors are above zero, with every noise: the recursion can go on from them.",
            named[0][1],
            "There is no minus sign.",
            tower=TOWER,
        ),
        *(Step(name, "", found, "", tower=TOWER, shown=False) for name, found in named[1:]),
    ]


def _key(noise: TripleNoise) -> str:
    return noise.name.replace("_", "-")
