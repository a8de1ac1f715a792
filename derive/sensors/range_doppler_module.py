"""The printed module of range and Doppler: which domains its kernels have, and what they are."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

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
from gainproof.derive.sensors.range_doppler_graphs import RANGE
from gainproof.derive.sensors.range_doppler_names import PLANE
from gainproof.derive.sensors.range_doppler_pair_graphs import OTHER
from gainproof.derive.sensors.range_doppler_words import EQUATIONS, SUMMARIES, meaning, of_input

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


def kernel_module(name: str, title: str, made: Mapping[str, Graph]) -> Module:
    """The module of range and Doppler."""
    kernels = (_kernel(name, kernel, graph) for kernel, graph in made.items())
    return catalogue_module(name, title, kernels)


def _kernel(name: str, kernel: str, graph: Graph) -> Kernel:
    shown = [
        entry for entry in graph["outputs"] if entry not in (RANGE, OTHER) or with_range(kernel)
    ]
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=SUMMARIES[kernel],
        equations=EQUATIONS[kernel],
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
