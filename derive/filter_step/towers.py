"""The parameters of a step: any state, any observation, any gains.

A parameter of a tower has a least value. A quantity of either sign is u - 1/u of a positive u,
which takes every real number once.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.expression import real
from gainproof.derive.filter_step.forms import AXES
from gainproof.derive.filter_step.names import (
    BY_AXIS,
    GAINS,
    POSITION_GAINS,
    STATES,
    VELOCITY_GAINS,
    gain_row,
    root_of,
)


def towers() -> tuple[Tower, ...]:
    """That of one coordinate, and one for each coordinate of three."""
    return main_tower(), *(along(axis) for axis in AXES)


def main_tower() -> Tower:
    """Two and three states; any gains, an interval above 0."""
    return _tower("main", (*STATES, "observed", *GAINS), ())


def along(axis: str) -> Tower:
    """One of three coordinates that interact, with the rows of K1 and K2 that correct it.

    The other rows are 0 here: nothing that is said of this coordinate uses them.
    """
    own = gain_row(axis)
    states = [name for names in BY_AXIS.values() for name in names]
    others = [name for name in (*POSITION_GAINS, *VELOCITY_GAINS) if name not in own]
    return _tower(f"along_{axis}", (*states, *own), others)


def _tower(name: str, signed: Sequence[str], zeros: Sequence[str]) -> Tower:
    parameters = (Parameter("t"), *(Parameter(root_of(each)) for each in signed))
    return Tower(name, parameters, (), {**_either(signed), **dict.fromkeys(zeros, real("t") * 0)})


def meanings(tower: Tower) -> dict[str, sp.Expr]:
    """What each name of a tower stands for, over its parameters."""
    free = {parameter.symbol for parameter in tower.parameters}
    signed = [name for name in tower.elements if root_of(name) in free]
    return {**dict.fromkeys(tower.elements, sp.Integer(0)), **_either(signed)}


def _either(signed: Sequence[str]) -> dict[str, sp.Expr]:
    return {each: real(root_of(each)) - 1 / real(root_of(each)) for each in signed}
