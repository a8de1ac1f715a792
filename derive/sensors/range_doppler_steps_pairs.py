"""Steps on what the kernels of two stations compute, by components."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import Relation, described
from gainproof.derive.sensors.polar_steps_kernels import quiet
from gainproof.derive.sensors.range_doppler_names import PLANE
from gainproof.derive.sensors.range_doppler_pair_towers import (
    PAIRS,
    along_of,
    circles,
    of_other,
    other,
    seen,
    stations,
)
from gainproof.derive.sensors.range_doppler_steps_kernels import named

SUMS = {
    "bistatic_range": ("slant_range", 1),
    "bistatic_range_rate": ("range_rate", 1),
    "range_difference": ("slant_range", -1),
    "range_rate_difference": ("range_rate", -1),
}
"""What is added up, or subtracted."""
VECTORS = {"baseline": ("place", -1), "drift": ("velocity", -1), "reach": ("place", 1)}
WORDS = {
    "pair_plane": "",
    "pair_above": " (neither station straight above)",
    "pair_below": " (neither station straight below)",
    "pair_aside": " (neither station straight aside)",
}


def pair_steps(graphs: Mapping[str, Graph]) -> list[Step]:
    """What the names mean in the towers of two stations, and the kernels."""
    opening = Step(
        "pairs",
        "From two stations a target is seen in any two directions. In space the pairs without "
        "straight down, those without straight up, and those without straight along the first "
        "axis backwards are all pairs.",
        described("B = L - r, B_2 = L - r_2, and so the velocities"),
        "Of straight up and straight down neither is along the first axis.",
        "pair_plane",
    )
    kernels = [
        _kernel(name, graph, tower)
        for name, graph in graphs.items()
        for tower in PAIRS
        if (tower == "pair_plane") is name.endswith(PLANE)
    ]
    return [opening, *(step for tower in PAIRS for step in _meanings(tower)), *kernels]


def _meanings(tower: str) -> list[Step]:
    name = tower.replace("_", "-")
    first = {**circles(tower), **seen(tower)}
    parts = {"first": first, "second": other(first), "stations": stations(along_of(tower))}
    found = []
    for part, meant in parts.items():
        entries = list(meant.items())
        for number, start in enumerate(range(0, len(entries), 16), 1):
            relation = named(dict(entries[start : start + 16]))
            found.append(quiet(f"{name}-{part}-{number}", relation, tower))
    return found


def _kernel(name: str, graph: Graph, tower: str) -> Step:
    roots = {"slant_range": real("slant_range"), "other_range": real("other_range")}
    names = graph.get("names", {}).items()
    nodes = {str(number): meant(name) for name, number in names if name not in roots}
    end = tower.removeprefix("pair_")
    return Step(
        f"kernel-{name.replace('_', '-')}{'' if end == 'plane' else f'-{end}'}",
        f"The kernel {name} computes what it says{WORDS[tower]}.",
        Relation(
            "program",
            {
                "program": name,
                "outputs": {each: meant(each) for each in graph["outputs"]},
                "nodes": nodes,
            },
        ),
        "Evaluate the kernel's graph.",
        tower=tower,
        hint={"graph": graph, "roots": roots},
        shown=False,
    )


def meant(output: str) -> sp.Expr:
    """What an output or a named node stands for: a sum, a difference, or a name of the tower."""
    word, axis = output[:-2], output[-1]
    if word in VECTORS:
        vector, sign = VECTORS[word]
        return real(f"{vector}_{axis}") + sign * of_other(f"{vector}_{axis}")
    what, _, by = output.partition("_D_")
    if what not in SUMS:
        return real(output)
    quantity, sign = SUMS[what]
    slope = {"slant_range": "unit", "range_rate": "turning"}[quantity]
    first = f"{slope}_{by}" if by else quantity
    return real(first) + sign * of_other(first)
