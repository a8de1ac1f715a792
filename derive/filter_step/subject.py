"""Steps of fixed-gain filters, with their kernels."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.derivation import Derivation, Step
from gainproof.derive.expression import real
from gainproof.derive.filter_step import forms
from gainproof.derive.filter_step.kernels import graphs, inputs
from gainproof.derive.filter_step.module import kernel_module
from gainproof.derive.filter_step.names import LATEX, STATES
from gainproof.derive.filter_step.steps import filter_steps, interacting_form, updated
from gainproof.derive.filter_step.towers import towers
from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import Relation
from gainproof.derive.source import LECTURE
from gainproof.derive.subject import Program, Subject

NAME = "filter-step"
TITLE = "One step of filters with fixed gains"
OPENING = (
    "What a fixed-gain filter does at each sample, over intervals that differ and with samples "
    "missed, in one coordinate and in three that interact."
)
SYMBOLS = {"interval": "t"}


def build() -> Subject:
    """Derive the steps."""
    made = graphs()
    programs = (step for name, graph in made.items() for step in _programs(name, graph))
    steps = (*filter_steps(), *programs)
    return Subject(
        name=NAME,
        title=TITLE,
        model=None,
        derivation=Derivation(OPENING, steps, (LECTURE.key,), LATEX),
        towers={tower.name: tower for tower in towers()},
        programs={
            name: Program({entry: SYMBOLS.get(entry, entry) for entry in inputs(name)}, graph)
            for name, graph in made.items()
        },
        module=kernel_module(NAME, TITLE, made),
        textbook=dict,
    )


def _programs(name: str, graph: Graph) -> list[Step]:
    """What a kernel computes; of three coordinates one after the other."""
    if name != "step_interacting":
        found, _, _ = updated(2 if name == "step_two_states" else 3)
        return [_program(name, graph, dict(zip(STATES, found, strict=False)), "main")]
    position, velocity = forms.interacting(interacting_form(), real("t"))
    steps = []
    for place, axis in enumerate(forms.AXES):
        meant = {f"{axis}_position": position[place], f"{axis}_velocity": velocity[place]}
        steps.append(_program(name, graph, meant, f"along_{axis}"))
    return steps


def _program(name: str, graph: Graph, meant: Mapping[str, sp.Expr], tower: str) -> Step:
    place = f" {tower.replace('_', ' ')}" if tower != "main" else ""
    outputs = {f"updated_{output}": value for output, value in meant.items()}
    return Step(
        f"kernel-{name.replace('_', '-')}{place.replace(' ', '-')}",
        f"The kernel {name} computes what it says{place}.",
        Relation("program", {"program": name, "outputs": outputs}),
        "Evaluate the kernel's graph as a rational function.",
        tower=tower,
        hint={"graph": graph, "roots": {}},
        shown=False,
    )
