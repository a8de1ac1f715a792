"""The printed module of polar coordinates: domains of its kernels, and what they say."""

from __future__ import annotations

from collections.abc import Mapping
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

FORMULAS = Path(__file__).with_name("polar_kernels.md")
MEANINGS = {
    "x": "distance east, m",
    "y": "distance north, m",
    "z": "height, m",
    "slant_range": "range, m",
    "elevation": "elevation above the horizontal, between -pi/2 and pi/2, rad",
    "bearing": "bearing from north, clockwise seen from above, between -pi and pi, rad",
    **{
        f"{place}_D_{polar}": f"derivative of {place} by the {word}, {unit}"
        for place in "xyz"
        for polar, word, unit in (
            ("slant_range", "range", "dimensionless"),
            ("elevation", "elevation", "m/rad"),
            ("bearing", "bearing", "m/rad"),
        )
    },
    **{
        f"{polar}_D_{place}": f"derivative of the {word} by {place}, {unit}"
        for place in "xyz"
        for polar, word, unit in (
            ("slant_range", "range", "dimensionless"),
            ("elevation", "elevation", "rad/m"),
            ("bearing", "bearing", "rad/m"),
        )
    },
    **{f"covariance_{a}{a}": f"variance of {a}, m^2" for a in "xyz"},
    **{f"covariance_{a}{b}": f"covariance of {a} and {b}, m^2" for a, b in ("xy", "xz", "yz")},
    **{f"mean_{a}": f"mean of the converted {a}, m" for a in "xyz"},
    **{f"bias_{a}": f"mean less true value of {a}, m" for a in "xyz"},
    "range_rate": "range rate, m/s (Doppler shift: -2 times it over the wavelength)",
    "elevation_rate": "rate of the elevation, rad/s",
    "bearing_rate": "rate of the bearing, rad/s",
    "range_acceleration": "second derivative of the range, m/s^2, never negative",
    "elevation_acceleration": "second derivative of the elevation, rad/s^2",
    "bearing_acceleration": "second derivative of the bearing, rad/s^2",
}

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


FROM_PLACE = ("to_polar", *DIVIDES)


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    return page_graphs(FORMULAS, _inputs)


def _inputs(kernel: str) -> dict[str, str]:
    place = kernel in FROM_PLACE
    return {
        name: name
        for name in DOMAINS
        if (name in ("x", "y", "z") or name.startswith("velocity_")) is place
    }


def kernel_module(name: str, title: str, graphs: Mapping[str, Graph]) -> Module:
    """The module of polar coordinates."""
    words = kernel_words(FORMULAS, graphs)
    kernels = (_kernel(name, kernel, graph, *words[kernel]) for kernel, graph in graphs.items())
    return catalogue_module(name, title, kernels)


def _kernel(
    name: str, kernel: str, graph: Graph, summary: str, equations: tuple[str, ...]
) -> Kernel:
    used = set(symbols_of(graph))
    required = _required(kernel)
    hidden = {each.name for each in required}
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=summary,
        equations=equations,
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
