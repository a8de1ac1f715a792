"""The printed module of range and Doppler: domains of its kernels, and what they say."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.printer.kernel import (
    Input,
    Kernel,
    Module,
    Output,
    Requirement,
    closed,
    signed,
)
from gainproof.derive.sensors.kernel_page import PLANE, kernel_words, page_graphs
from gainproof.derive.sensors.range_doppler_names import SPACE_AXES, places, velocities

FORMULAS = Path(__file__).with_name("range_doppler_kernels.md")
RANGE, OTHER = "slant_range", "other_range"
PAIRS = ("bistatic_range_doppler", "range_doppler_difference")
"""The kernels of two stations."""
NAMED = (
    "(other_)?((place|velocity|turning)_[xyz]|range_rate)|(baseline|drift|reach)_[xyz]"
    "|range_(rate_)?difference(_D_[xyz])?"
)
"""What proofs put names for."""
LENGTH = ("0", "1e60", ("0", "1e12"))
SPEED = ("0", "1e60", ("0", "1e9"))
NEAR, SLOW = ("0", "1e40", ("0", "1e10")), ("0", "1e30", ("0", "1e6"))
"""Of differences, whose bounds go through quotients that may be large."""
CARRIER = ("1e-10", "1e30", ("1e-3", "1e15"))
APART = Requirement(RANGE, "distance of the target from the station", "1e-20", "1e-6")
WHICH = {RANGE: "first", OTHER: "second"}


def apart(kernel: str, ranges: Iterable[str]) -> tuple[Requirement, ...]:
    """What the distances from the stations have to be."""
    if OTHER not in ranges:
        return (APART,)
    single = "1" if "difference" in kernel else "1e-6"
    return tuple(
        Requirement(name, f"distance of the target from the {which} station", "1e-20", single)
        for name, which in WHICH.items()
    )


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name, those of two stations last."""
    found = page_graphs(FORMULAS, _inputs, NAMED)
    return {name: found[name] for name in sorted(found, key=of_two_stations)}


def of_two_stations(kernel: str) -> bool:
    """Whether a kernel has a second station."""
    return kernel.removesuffix(PLANE) in PAIRS


def _inputs(kernel: str) -> dict[str, str]:
    who = {"target": "target", "station": "station"}
    if of_two_stations(kernel):
        who |= {"station": "first_station", "other_station": "second_station"}
    found = {
        name: argument
        for called, whose in who.items()
        for vector in (places, velocities)
        for name, argument in zip(
            vector(called, SPACE_AXES), vector(whose, SPACE_AXES), strict=True
        )
    }
    return {**found, "carrier_frequency": "carrier_frequency"}


def kernel_module(name: str, title: str, made: Mapping[str, Graph]) -> Module:
    """The module of range and Doppler."""
    words = kernel_words(FORMULAS, {kernel.removesuffix(PLANE) for kernel in made})
    kernels = (
        _kernel(name, kernel, graph, *words[kernel.removesuffix(PLANE)])
        for kernel, graph in made.items()
    )
    return catalogue_module(name, title, kernels)


def _kernel(
    name: str, kernel: str, graph: Graph, summary: str, equations: tuple[str, ...]
) -> Kernel:
    if kernel.endswith(PLANE):
        summary = summary.replace(".", " in the plane.")
    shown = [
        entry for entry in graph["outputs"] if entry not in (RANGE, OTHER) or with_range(kernel)
    ]
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=summary,
        equations=equations,
        inputs=tuple(_input(kernel, entry) for entry in symbols_of(graph)),
        outputs=tuple(Output(entry, meaning(entry), by_terms=cancels(entry)) for entry in shown),
        graph=graph,
        source=f"derivation {name}",
        requirements=apart(kernel, graph["outputs"]),
    )


def with_range(kernel: str) -> bool:
    """Whether the range is a result, and not only what must not be 0."""
    return kernel.removesuffix(PLANE) in ("slant_range", "range_doppler")


def cancels(entry: str) -> bool:
    """Whether an output is a sum whose terms may have different signs."""
    if "_D_velocity_" in entry or entry in ("slant_range", "bistatic_range"):
        return False
    return not entry.startswith("range_D_")


def _input(kernel: str, entry: str) -> Input:
    if entry == "carrier_frequency":
        return closed(entry, "frequency of the carrier, Hz", *CARRIER)
    length, speed = (NEAR, SLOW) if "difference" in kernel else (LENGTH, SPEED)
    return signed(entry, of_input(entry), *(speed if "_velocity_" in entry else length))


_BY = {
    "range": ("range", {"": "dimensionless"}),
    "range_rate": ("range rate", {"": "1/s", "velocity_": "dimensionless"}),
    "doppler_shift": ("shift", {"": "Hz/m", "velocity_": "Hz s/m"}),
    "bistatic_range": ("bistatic range", {"": "dimensionless"}),
    "bistatic_range_rate": ("rate of the bistatic range", {"": "1/s"}),
    "range_difference": ("difference of the ranges", {"": "dimensionless"}),
    "range_rate_difference": ("difference of the range rates", {"": "1/s"}),
}
"""Quantity of a derivative, and its unit by what it is taken by."""


def of_input(entry: str) -> str:
    """A position or a velocity."""
    *who, axis = entry.replace("_velocity", "").split("_")
    if "_velocity_" in entry:
        return f"velocity of the {' '.join(who)} along {axis}, m/s"
    return f"position of the {' '.join(who)} along {axis}, m"


def meaning(entry: str) -> str:
    """An output."""
    if entry in _VALUES:
        return _VALUES[entry]
    what, _, by = entry.partition("_D_")
    word, units = _BY[what]
    if by[:-1] in ("x", "y", "z"):
        axes = f"{by[0]}, twice" if by[0] == by[1] else f"{by[0]} and {by[1]}"
        unit = {"range": "1/m", "range_rate": "1/(m s)"}[what]
        return f"second derivative of the {word} by the target's position along {axes}, {unit}"
    kind = "velocity_" if by.startswith("velocity_") else ""
    text = f"derivative of the {word} by the target's {'velocity' if kind else 'position'}"
    return f"{text} along {by[-1]}, {units[kind]}"


_VALUES = {
    "slant_range": "distance of the target from the station, m",
    "range_rate": "its rate, m/s, above 0 where the target goes away",
    "doppler_shift": "received less sent frequency, Hz, below 0 where the target goes away",
    "bistatic_range": "sum of the target's distances from both stations, m",
    "bistatic_range_rate": "its rate, m/s",
    "range_difference": "distance from the first station less that from the second, m",
    "range_rate_difference": "its rate, m/s",
}
