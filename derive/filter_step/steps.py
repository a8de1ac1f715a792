"""Steps: what is printed is the filter's equations in matrix form, interacting or not."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.filter_step import forms
from gainproof.derive.filter_step.names import (
    BY_AXIS,
    GAINS,
    POSITION_GAINS,
    STATES,
    VELOCITY_GAINS,
)
from gainproof.derive.filter_step.towers import meanings, towers
from gainproof.derive.fixed_gain.loop import product, shift, total
from gainproof.derive.relation import described, equal

T, SEEN = real("t"), real("observed")
Matrix = sp.ImmutableDenseMatrix


def filter_steps() -> list[Step]:
    """What a step is, and that the forms printed are it."""
    return [
        Step(
            "model",
            "A filter with fixed gains predicts over the interval `t` since its last update as if "
            "the last of its states stayed what it is, and corrects each state by a part of the "
            "innovation, what is observed less what was predicted. The interval may be another one "
            "at each step; the gains are numbers, of which nothing is assumed.",
            described("prediction by a Taylor shift, correction by fixed gains"),
            "These are the definitions.",
            heading="The filter",
        ),
        *_signs(),
        _matrix_form(2, "two"),
        _matrix_form(3, "three"),
        _missed(2),
        _missed(3),
        *_interacting(),
        *_alone(),
    ]


def _signs() -> list[Step]:
    """What each name stands for: without this a claim could be one on some numbers alone."""
    return [
        Step(
            f"signs-{tower.name.replace('_', '-')}",
            "States, observations and gains may have either sign: each is `u - 1/u` of a positive "
            "`u` of its own, which takes every real number once as `u` grows.",
            equal(
                _listed([real(name) for name in tower.elements]),
                _listed(list(meanings(tower).values())),
            ),
            "These are the definitions; in what follows only the names occur.",
            tower=tower.name,
            shown=tower.name == "main",
        )
        for tower in towers()
    ]


def _listed(values: list[sp.Expr]) -> sp.ImmutableDenseMatrix:
    """A column; of many entries four, filled up with 0: a certificate has no more than 8 rows."""
    if len(values) <= 8:
        return Matrix(values)
    rows = -(-len(values) // 4)
    return Matrix(rows, 4, [*values, *[sp.Integer(0)] * (4 * rows - len(values))])


def updated(
    size: int,
) -> tuple[sp.ImmutableDenseMatrix, tuple[sp.Symbol, ...], tuple[sp.Symbol, ...]]:
    """The state after a step as it is printed, with the symbols of state and gains."""
    state, gains = (tuple(map(real, names[:size])) for names in (STATES, GAINS))
    return Matrix(forms.stepped(state, T, SEEN, gains)), state, gains


def _matrix_form(size: int, word: str) -> Step:
    found, state, gains = updated(size)
    moving = shift(size, T)
    column = Matrix([gain / T**n for n, gain in enumerate(gains)])
    row = Matrix([[1] + [0] * (size - 1)])
    ahead = product(moving, Matrix(state))
    innovation = total(Matrix([[SEEN]]), product(-1, row, moving, Matrix(state)))
    *first, last = (f"`{gain}{('', '/t', '/t^2')[n]}`" for n, gain in enumerate(GAINS[:size]))
    listed = f"{', '.join(first)} and {last}"
    return Step(
        f"step-{word}",
        f"With {word} states the gains of the states are {listed}. In matrix form the step is "
        "`F s + K (z - H F s)`.",
        equal(found, total(ahead, product(column, innovation))),
        "Multiply out, row by row.",
    )


def _missed(size: int) -> Step:
    found, state, gains = updated(size)
    relation = equal(found.subs(dict.fromkeys(gains, 0)), product(shift(size, T), Matrix(state)))
    if size > 2:
        return joined(f"missed-{size}", relation)
    return Step(
        f"missed-{size}",
        "Where nothing was observed all gains are 0, and what is left is the prediction, whatever "
        "stands for the observation.",
        relation,
        "Insert the gains.",
    )


def interacting_form() -> forms.Interacting:
    """The symbols of three coordinates that interact."""
    return forms.Interacting(
        [real(name) for name in BY_AXIS["position"]],
        [real(name) for name in BY_AXIS["velocity"]],
        [real(name) for name in BY_AXIS["observed"]],
        _rows(POSITION_GAINS),
        _rows(VELOCITY_GAINS),
    )


def _interacting() -> list[Step]:
    """One coordinate after the other: two rows of the six."""
    given = interacting_form()
    found = forms.interacting(given, T)
    moved = product(T, Matrix(given.velocity))
    innovation = total(Matrix(given.observed), product(-1, total(Matrix(given.position), moved)))
    steps: list[Step] = []
    for place, axis in enumerate(forms.AXES):
        state = Matrix([given.position[place], given.velocity[place]])
        gain = Matrix([given.position_gain[place], given.velocity_gain[place]])
        ahead = product(shift(2, T), state)
        relation = equal(
            Matrix([part[place] for part in found]), total(ahead, product(gain, innovation))
        )
        if steps:
            steps.append(joined(f"step-interacting-{axis}", relation, f"along_{axis}"))
            continue
        steps.append(
            Step(
                f"step-interacting-{axis}",
                "In three coordinates the gains of the positions are a matrix `K1`, those of the "
                "velocities a matrix `K2` (in 1/s): each coordinate is corrected by the "
                "innovations of all. Of `F s + K (z - H F s)` with `K1` above `K2` these are the "
                "rows of each coordinate, its position and its velocity.",
                relation,
                "Multiply out, row by row.",
                tower=f"along_{axis}",
                heading="Coordinates that interact",
            )
        )
    return steps


def _alone() -> list[Step]:
    """Diagonal matrices."""
    given = interacting_form()
    found = forms.interacting(given, T)
    steps: list[Step] = []
    for place, axis in enumerate(forms.AXES):
        gains = given.position_gain[place], given.velocity_gain[place]
        off = {entry: 0 for row in gains for n, entry in enumerate(row) if n != place}
        state = given.position[place], given.velocity[place]
        own = gains[0][place], T * gains[1][place]
        relation = equal(
            Matrix([part[place] for part in found]).subs(off),
            Matrix(forms.stepped(state, T, given.observed[place], own)),
        )
        if steps:
            steps.append(joined(f"non-interacting-{axis}", relation, f"along_{axis}"))
            continue
        steps.append(
            Step(
                f"non-interacting-{axis}",
                "Where `K1` and `K2` are diagonal each coordinate is a filter of its own, with the "
                "diagonals as its `alpha` and its `beta/t`.",
                relation,
                "Insert the zeros.",
                tower=f"along_{axis}",
            )
        )
    return steps


def _rows(names: Sequence[str]) -> list[list[sp.Symbol]]:
    return [[real(name) for name in names[start : start + 3]] for start in (0, 3, 6)]
