"""The printed module of polar coordinates: which domains its kernels have, and what they are."""

from __future__ import annotations

from collections.abc import Mapping

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
from gainproof.derive.sensors.polar_words import EQUATIONS, MEANINGS, PLANE, SUMMARIES

RANGE = ("1e-20", "1e60", ("1e-6", "1e12"))
DEVIATION = ("1e-20", "2", ("1e-9", "2"))
PLACE = ("1e-150", "1e150", ("1e-18", "1e18"))
NEAR = ("1e-20", "1e30", ("1e-6", "1e12"))
SPEED = ("1e-20", "1e30", ("1e-9", "1e9"))
DOMAINS: dict[str, Input] = {
    "slant_range": closed("slant_range", "range, m", *RANGE),
    "elevation": signed(
        "elevation",
        "elevation above the horizontal, rad",
        "1e-20",
        "1.5707963267948966",
        ("1e-12", "1.5707962"),
    ),
    "bearing": signed(
        "bearing",
        "bearing from north, clockwise seen from above, rad",
        "1e-20",
        "6.2832",
        ("1e-12", "6.2832"),
    ),
    "range_deviation": closed(
        "range_deviation", "standard deviation of the range, m", *RANGE, zero=True
    ),
    **{
        f"{angle}_deviation": closed(
            f"{angle}_deviation", f"standard deviation of the {angle}, rad", *DEVIATION, zero=True
        )
        for angle in ("elevation", "bearing")
    },
    **{
        place: signed(place, f"{meaning}, m", *PLACE)
        for place, meaning in (("x", "distance east"), ("y", "distance north"), ("z", "height"))
    },
    **{
        f"velocity_{place}": signed(f"velocity_{place}", f"velocity {meaning}, m/s", *SPEED)
        for place, meaning in (("x", "east"), ("y", "north"), ("z", "upwards"))
    },
}
"""The arguments in their order."""

AXIS = Requirement("horizontal_distance", "distance from the vertical axis", "1e-20", "1e-3")
POINT = Requirement("slant_range", "distance from the origin", "1e-20", "1e-3")
DIVIDES = ("polar_derivatives", "straight_course_rates")
"""Kernels that divide by distances: x, y, z are in a narrower domain, and apart from the axis."""


def kernel_module(name: str, title: str, graphs: Mapping[str, Graph]) -> Module:
    """The module of polar coordinates."""
    kernels = (_kernel(name, kernel, graph) for kernel, graph in graphs.items())
    return catalogue_module(name, title, kernels)


def _kernel(name: str, kernel: str, graph: Graph) -> Kernel:
    used = set(symbols_of(graph))
    required = _required(kernel)
    hidden = {each.name for each in required}
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=SUMMARIES[kernel],
        equations=EQUATIONS[kernel],
        inputs=tuple(_input(kernel, entry) for entry in DOMAINS if entry in used),
        outputs=tuple(
            Output(entry, MEANINGS[entry], by_terms=cancels(kernel, entry))
            for entry in graph["outputs"]
            if entry not in hidden
        ),
        graph=graph,
        source=f"derivation {name}",
        requirements=required,
    )


def _required(kernel: str) -> tuple[Requirement, ...]:
    if kernel.removesuffix(PLANE) not in DIVIDES:
        return ()
    return (POINT,) if kernel.endswith(PLANE) else (AXIS,)


def _input(kernel: str, entry: str) -> Input:
    if kernel.removesuffix(PLANE) in DIVIDES and entry in ("x", "y", "z"):
        return signed(entry, DOMAINS[entry].meaning, *NEAR)
    return DOMAINS[entry]


def cancels(kernel: str, entry: str) -> bool:
    """Whether an output is a sum whose terms may have different signs."""
    match kernel.removesuffix(PLANE):
        case "noise_covariance":
            return entry in ("covariance_xy", "covariance_xz", "covariance_yz")
        case "straight_course_rates":
            return True
    return False
