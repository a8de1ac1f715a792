"""Steps of fixed-gain filters, with their kernels.

The derivation is the page `filter-step` of `derive/pages`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import sympy as sp

from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.derivation import Derivation, Step, kernel_step
from gainproof.derive.expression import real
from gainproof.derive.filter_step import forms
from gainproof.derive.filter_step.forms import AXES
from gainproof.derive.filter_step.kernels import graphs, inputs
from gainproof.derive.filter_step.names import (
    BY_AXIS,
    GAINS,
    LATEX,
    POSITION_GAINS,
    STATES,
    VELOCITY_GAINS,
    gain_row,
    root_of,
)
from gainproof.derive.pages.derivation import FOLDER, Given, written
from gainproof.derive.pages.kernel_page import page_module
from gainproof.derive.printer.graph import Graph
from gainproof.derive.source import LECTURE
from gainproof.derive.subject import Program, Subject

NAME = "filter-step"
WORDS = Path(__file__).with_name("kernels.md")
SYMBOLS = {"interval": "t"}


def build(folder: Path = FOLDER) -> Subject:
    """Derive the steps.

    `folder`: where the page is. Raises PageError with the line of a mistake on it.
    """
    made = graphs()
    kernels = [step for name, graph in made.items() for step in _programs(name, graph)]
    page = written(NAME, Given(towers(), slots=_slots(), steps={"kernels": kernels}), folder)
    return Subject(
        name=NAME,
        title=page.title,
        model=None,
        derivation=Derivation(page.opening, page.steps, (LECTURE.key,), LATEX),
        towers=page.towers,
        programs={
            name: Program({entry: SYMBOLS.get(entry, entry) for entry in inputs(name)}, graph)
            for name, graph in made.items()
        },
        module=page_module(WORDS, made, NAME, page.title),
        textbook=dict,
    )


def _slots() -> dict[str, dict[str, Any]]:
    """The names of each tower and what they stand for: without this a claim could be one on some
    numbers alone.
    """
    found: dict[str, dict[str, Any]] = {"": {}}
    for tower in towers():
        names = _listed([real(name) for name in tower.elements])
        values = _listed(list(meanings(tower).values()))
        if tower.name == "main":
            found[""] |= {"names_main": names, "values_main": values}
        else:
            key = tower.name.replace("_", "-")
            found[tower.name] = {
                "key": key,
                "tower": tower.name,
                "names": names,
                "values": values,
            }
    return found


def _listed(values: list[sp.Expr]) -> sp.ImmutableDenseMatrix:
    """A column; of many entries four, filled up with 0: a certificate has no more than 8 rows."""
    if len(values) <= 8:
        return sp.ImmutableDenseMatrix(values)
    rows = -(-len(values) // 4)
    return sp.ImmutableDenseMatrix(rows, 4, [*values, *[sp.Integer(0)] * (4 * rows - len(values))])


def _programs(name: str, graph: Graph) -> list[Step]:
    """What a kernel computes; of three coordinates one after the other."""
    if name != "step_interacting":
        size = 2 if name == "step_two_states" else 3
        state, gains = (list(map(real, names[:size])) for names in (STATES, GAINS))
        found = forms.stepped(state, real("t"), real("observed"), gains)
        return [_program(name, graph, dict(zip(STATES, found, strict=False)), "main")]
    positions, velocities, observed = ([real(each) for each in BY_AXIS[x]] for x in BY_AXIS)
    given = forms.Interacting(
        positions, velocities, observed, _rows(POSITION_GAINS), _rows(VELOCITY_GAINS)
    )
    position, velocity = forms.interacting(given, real("t"))
    steps = []
    for place, axis in enumerate(forms.AXES):
        meant = {f"{axis}_position": position[place], f"{axis}_velocity": velocity[place]}
        steps.append(_program(name, graph, meant, f"along_{axis}"))
    return steps


def _rows(names: Sequence[str]) -> list[list[sp.Symbol]]:
    return [[real(name) for name in names[start : start + 3]] for start in (0, 3, 6)]


def _program(name: str, graph: Graph, meant: Mapping[str, sp.Expr], tower: str) -> Step:
    outputs = {f"updated_{output}": value for output, value in meant.items()}
    step = name if tower == "main" else f"{name}_{tower}"
    return kernel_step(name, graph, outputs, tower, step)


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
