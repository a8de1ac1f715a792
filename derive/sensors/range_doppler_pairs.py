"""Two stations, each with its own direction and velocity: towers, and what the kernels compute.

In space three towers hold every pair of directions: straight down is left out for both in `above`,
straight up in `below`, and a pair of these two in neither lies in `aside`, where the first axis'
other end is left out.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.algebra.variables import above_zero, from_zero
from gainproof.derive.derivation import Step, kernel_step
from gainproof.derive.expression import real
from gainproof.derive.pages.kernel_formulas import PLANE
from gainproof.derive.printer.graph import Graph
from gainproof.derive.sensors.range_doppler_components import named, quiet
from gainproof.derive.sensors.range_doppler_names import (
    PLANE_AXES,
    SPACE_AXES,
    places,
    velocities,
)
from gainproof.derive.sensors.range_doppler_towers import (
    Axes,
    Elements,
    bearing_circle,
    difference,
    frame,
    parts,
    relative,
    signed,
    tilt,
)

OTHER = "other_"
STATIONS = {"": "first_station", OTHER: "second_station"}


def pair_towers() -> tuple[Tower, ...]:
    """The plane, and the three that hold space."""
    return tuple(_tower(name, along_of(name)) for name in PAIRS)


PAIRS = ("pair_plane", "pair_above", "pair_below", "pair_aside")


def along_of(tower: str) -> Axes:
    """The coordinates of a tower."""
    return PLANE_AXES if tower == "pair_plane" else SPACE_AXES


def circles(tower: str) -> Elements:
    """Cosines and sines of the first direction."""
    if tower == "pair_plane":
        return bearing_circle()
    return {**bearing_circle(), **tilt(-1 if tower == "pair_below" else 1)}


def seen(tower: str) -> Elements:
    """Direction, place, velocity and their parts, from the first station."""
    along = along_of(tower)
    rows = frame(along)
    if tower == "pair_aside":
        rows = [[*row[-1:], *row[:-1]] for row in rows]
    return relative(
        along, rows, lambda part: signed(part) if part == "range_rate" else difference(part)
    )


def other(elements: Elements) -> Elements:
    """The same from the second station: every name with `other_` before it."""
    return {
        f"{OTHER}{name}": value.xreplace(
            {symbol: of_other(symbol.name) for symbol in value.free_symbols}
        )
        for name, value in elements.items()
    }


def of_other(name: str) -> sp.Symbol:
    """A name from the second station; its range is short of a word."""
    return real("other_range" if name == "slant_range" else f"{OTHER}{name}")


def stations(along: Axes) -> Elements:
    """The target, and the stations by what it is seen at from them."""
    found = {
        name: signed(name) for name in (*places("target", along), *velocities("target", along))
    }
    for start, who in STATIONS.items():
        for axis in along:
            found[f"{who}_{axis}"] = real(f"target_{axis}") - real(f"{start}place_{axis}")
            found[f"{who}_velocity_{axis}"] = real(f"target_velocity_{axis}") - real(
                f"{start}velocity_{axis}"
            )
    return found


def _tower(name: str, along: Axes) -> Tower:
    angles = ("g", "k") if along == PLANE_AXES else ("g", "k", "a")
    both = (*places("target", along), *velocities("target", along))
    roots = [*(f"root_of_{each}" for each in both), *(f"{o}root_of_range_rate" for o in STATIONS)]
    across = [f"{side}_{part}" for part in parts(along)[1:] for side in ("more", "less")]
    closed = [f"{start}{each}" for start in STATIONS for each in (*angles, *across)]
    parameters = (
        *above_zero("slant_range", "other_range", *roots),
        *from_zero(*closed),
    )
    first = {**circles(name), **seen(name)}
    return Tower(name, parameters, (), {**first, **other(first), **stations(along)})


SUMS = {
    "bistatic_range": ("slant_range", 1),
    "bistatic_range_rate": ("range_rate", 1),
    "range_difference": ("slant_range", -1),
    "range_rate_difference": ("range_rate", -1),
}
"""What is added up, or subtracted."""
VECTORS = {"baseline": ("place", -1), "drift": ("velocity", -1), "reach": ("place", 1)}


def pair_steps(graphs: Mapping[str, Graph]) -> list[Step]:
    """What the names mean in the towers of two stations, and the kernels."""
    kernels = [
        _kernel(name, graph, tower)
        for name, graph in graphs.items()
        for tower in PAIRS
        if (tower == "pair_plane") is name.endswith(PLANE)
    ]
    return [*(step for tower in PAIRS for step in _meanings(tower)), *kernels]


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
    outputs = {each: meant(each) for each in graph["outputs"]}
    end = tower.removeprefix("pair").removesuffix("_plane")
    return kernel_step(name, graph, outputs, tower, name + end, nodes, roots=roots)


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
