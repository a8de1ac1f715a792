"""The recursion of position, velocity and acceleration with measured position, any intervals.

The derivation is the page `recursion-three-states` of `derive/pages`.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import sympy as sp

from gainproof.derive.derivation import Step, kernel_step
from gainproof.derive.expression import real
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.pages.kernel_page import page_module
from gainproof.derive.printer.graph import Graph
from gainproof.derive.recursion.three_state_kernels import graphs
from gainproof.derive.recursion.three_state_names import (
    FACTORS,
    PARAMETERS,
    PLACES,
    S,
    T,
    filled,
    predicted_names,
    start_names,
    transition,
)
from gainproof.derive.recursion.three_state_noise import TripleNoise, triple_noises
from gainproof.derive.recursion.three_state_towers import (
    entries_tower,
    intervals_tower,
    pair_tower,
    predict_tower,
    samples_tower,
    start_tower,
    update_tower,
)
from gainproof.derive.source import GAUSS_MARKOV, SPECTRAL
from gainproof.derive.subject import Subject, page_subject

NAME = "recursion-three-states"
WORDS = Path(__file__).with_name("three_states.md")
SHAPES = {
    "acceleration_increments": (sp.Integer(0), sp.Integer(0), sp.Integer(1)),
    "wiener_acceleration": (T**2 / 2, T, sp.Integer(1)),
    "random_jerk": (T**3 / 6, T**2 / 2, T),
}
"""What one unit of a noise of the samples does until the interval's end."""


def build() -> Subject:
    """Derive the recursion with the process noises of the three-state families."""
    known = triple_noises()
    made = graphs(known)
    towers = (
        update_tower(),
        intervals_tower(),
        entries_tower(),
        *map(predict_tower, known),
        start_tower(known),
        pair_tower(),
        samples_tower(),
    )
    given = Given(
        towers,
        slots={noise.name: _slots(noise) for noise in known},
        steps={"kernels": [_program(name, graph, known) for name, graph in made.items()]},
    )
    page = written(NAME, given)
    module = page_module(WORDS, made, NAME, page.title)
    sources = SPECTRAL.key, GAUSS_MARKOV.key
    return page_subject(NAME, page, module, made, sources, {"det": r"\det P"}, PARAMETERS)


def _slots(noise: TripleNoise) -> dict[str, Any]:
    """What the shared parts say of one noise."""
    slots: dict[str, Any] = {
        "name": noise.name,
        "key": noise.name.replace("_", "-"),
        "words": noise.words,
    }
    if noise.continuous:
        return slots
    matrix = noise.covariance
    first, both = matrix.subs(T, S), matrix.subs(T, S + T)
    apart = transition(T) * first * transition(T).T + matrix - both
    return slots | {
        "shape": sp.ImmutableDenseMatrix(SHAPES[noise.name]),
        "noise": matrix,
        "first": first,
        "both": both,
        "left": filled([sp.factor(apart[place]) for place in PLACES]),
    }


def _program(name: str, graph: Graph, known: tuple[TripleNoise, ...]) -> Step:
    noise = next((each for each in known if name.endswith(each.name)), None)
    starts = name.startswith("start")
    names = {output: output for output in graph["outputs"]}
    if noise is not None:
        meant = start_names(noise) if starts else predicted_names(noise)
        names = dict(zip(FACTORS, meant, strict=True))
    elif name == "update":
        names = {output: f"updated_{output}" for output in FACTORS}
    outputs = {output: real(meant) for output, meant in names.items()}
    tower = "main" if noise is None else "start" if starts else noise.name
    return kernel_step(name, graph, outputs, tower)
