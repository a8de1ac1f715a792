"""The recursion of position and velocity with measured position, over any intervals.

The derivation is the page `recursion-two-states` of `derive/pages`.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from gainproof.derive.derivation import Derivation, Step
from gainproof.derive.expression import real
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.recursion.kernels import graphs
from gainproof.derive.recursion.module import kernel_module
from gainproof.derive.recursion.names import (
    FACTORS,
    PARAMETERS,
    Q,
    T,
    predicted_names,
    start_names,
    step_names,
)
from gainproof.derive.recursion.noise import Noise, noises
from gainproof.derive.recursion.towers import (
    entries_tower,
    intervals_tower,
    main_tower,
    pair_tower,
    samples_tower,
    start_tower,
)
from gainproof.derive.relation import Relation
from gainproof.derive.source import GAUSS_MARKOV, SPECTRAL
from gainproof.derive.subject import Program, Subject

NAME = "recursion-two-states"


def build() -> Subject:
    """Derive the recursion with the process noises of the two-state families."""
    known = noises()
    made = graphs(known)
    towers = (
        main_tower(known),
        intervals_tower(),
        entries_tower(),
        start_tower(known),
        pair_tower(),
        samples_tower(),
    )
    page = written(NAME, Given(towers, slots={noise.name: _slots(noise) for noise in known}))
    steps = (*page.steps, *(_program(name, graph, known) for name, graph in made.items()))
    return Subject(
        name=NAME,
        title=page.title,
        model=None,
        derivation=Derivation(page.opening, steps, (SPECTRAL.key, GAUSS_MARKOV.key), page.latex),
        towers=page.towers,
        programs={
            name: Program(
                {entry: PARAMETERS.get(entry, entry) for entry in symbols_of(graph)}, graph
            )
            for name, graph in made.items()
        },
        module=kernel_module(NAME, page.title, known, made),
        textbook=dict,
    )


def _slots(noise: Noise) -> dict[str, Any]:
    """What the prediction's part says of one noise."""
    return {
        "name": noise.name,
        "key": noise.name.replace("_", "-"),
        "gained": noise.velocity(Q, T),
        "middle": T / 2 if noise.share else sp.Integer(0),
        "own": noise.position(Q, T) or sp.Integer(0),
        "middle_words": "`t/2`" if noise.share else "0",
        "own_words": f"`q t^3/{1 / noise.floor}` of its own and " if noise.floor else "",
    }


def _program(name: str, graph: Graph, known: tuple[Noise, ...]) -> Step:
    return Step(
        f"kernel-{name.replace('_', '-')}",
        f"The kernel {name} computes what it says.",
        Relation("program", {"program": name, "outputs": _meant(name, graph, known)}),
        "Evaluate the kernel's graph as a rational function.",
        tower={"hand": "samples", "start": "start"}.get(name.split("_")[0], "main"),
        hint={"graph": graph, "roots": {"root": real("root")}},
        shown=False,
    )


def _meant(name: str, graph: Graph, known: tuple[Noise, ...]) -> dict[str, object]:
    """The quantity that each output stands for."""
    noise = next((each for each in known if name.endswith(each.name)), None)
    names = {output: output for output in graph["outputs"]}
    if noise is not None and name.startswith("start"):
        names = dict(zip(FACTORS, start_names(noise), strict=True))
    elif noise is not None and name.startswith("predict"):
        names = dict(zip(FACTORS, predicted_names(noise), strict=True))
    elif noise is not None:
        names = step_names(noise)
    elif name == "update":
        names = {output: f"updated_{output}" for output in FACTORS}
    return {output: real(meant) for output, meant in names.items()}
