"""The printed module of range and Doppler: domains of its kernels, and what they say."""

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
_SPACE = {
    "slant_range": "Distance of targets from stations.",
    "range_jacobian": "Derivative of the range: the unit vector from station to target.",
    "range_rate": "Range rate of moving targets from moving stations.",
    "range_rate_jacobian": "Derivative of the range rate by position and velocity.",
    "range_doppler": "Range and range rate with their derivatives.",
    "range_hessian": "Second derivatives of the range by the position.",
    "range_rate_hessian": "Second derivatives of the range rate by the position.",
    "doppler_shift": "Doppler shift of a carrier that the target sends, with its derivatives.",
    "bistatic_range_doppler": "Range and range rate over two stations, with their derivatives.",
    "range_doppler_difference": "Differences of range and range rate at two stations (TDOA, FDOA).",
}
SUMMARIES = {
    f"{name}{end}": text.replace(".", " in the plane.") if end else text
    for end in ("", PLANE)
    for name, text in _SPACE.items()
}
_R = "r = target - station, f = |r|"
_W = "r = target - station, f = |r|, u = r/f, w = target velocity - station velocity"
_MINUS = "By the station's position and velocity the derivatives are these with the other sign"
_SIZE = "The terms of g, |u_i w_i|, add up to at most |w|"
_NEAR = (
    "The terms of h add up to at most 2 |w|/f: where the target moves nearly along the line of",
    "sight, w and g u nearly agree, and h has lost as many digits as |w| is larger than |h| f",
)
_EQUATIONS: dict[str, tuple[str, ...]] = {
    "slant_range": (_R,),
    "range_jacobian": (f"u = r/f, {_R}.", "By the station's position the derivative is -u"),
    "range_rate": (f"g = u'w, {_W}.", _SIZE),
    "range_rate_jacobian": (
        "by the position h = (w - g u)/f with g = u'w, by the velocity u;",
        f"{_W}.",
        f"{_MINUS}.",
        *_NEAR,
    ),
    "range_doppler": (
        "f, g = u'w, their derivatives by the position u and h = (w - g u)/f, that of g by the",
        "velocity, u;",
        f"{_W}.",
        f"{_MINUS}.",
        f"{_SIZE}.",
        *_NEAR,
    ),
    "range_hessian": (
        f"(I - u u')/f, u = r/f, {_R}.",
        "Of the range rate these are the second derivatives by a position and a velocity; by two",
        "velocities these are 0. Each time that the station's is taken for the target's the sign",
        "changes",
    ),
    "range_rate_hessian": (
        "-(u h' + h u' + (g/f) (I - u u'))/f, g = u'w, h = (w - g u)/f,",
        f"{_W};",
        "by position and velocity see `range_hessian`, by two velocities it is 0. The terms of an",
        "entry add up to at most 5 |w|/f^2",
    ),
    "doppler_shift": (
        "-(fc/c) g and its derivatives -(fc/c) h, -(fc/c) u, c = 299792458 m/s, g = u'w,",
        "h = (w - g u)/f;",
        f"{_W}.",
        "This is the narrow-band shift of one way, of first order in speeds over c: at a station",
        "at rest the classical one is fc/(1 + g/c) - fc, fc g^2/(c (c + g)) above it. An echo has",
        "twice the shift",
    ),
    "bistatic_range_doppler": (
        "f_1 + f_2, g_1 + g_2, u_1 + u_2, h_1 + h_2 with f, g, u, h of `range_doppler` from each",
        "station; the derivative of the rate by the target's velocity is u_1 + u_2 too, by a",
        "station's position and velocity they are -u, -h and -u of its own. Terms are those of",
        "`range_doppler`",
    ),
    "range_doppler_difference": (
        "f_1 - f_2 = s'(r_1 + r_2)/(f_1 + f_2), r = target - station, s = second - first station,",
        "so that errors are parts of |s| and not of the ranges: terms, those of r_1 and of r_2",
        "each for itself, add up to at most |s|;",
        "u_1 - u_2 = (s - (f_1 - f_2) u_2)/f_1, g_1 - g_2 = u_1's_v + (u_1 - u_2)'w_2,",
        "h_1 - h_2 = (s_v - (g_1 - g_2) u_1 - g_2 (u_1 - u_2) - (f_1 - f_2) h_2)/f_1 with the",
        "f, g, u, h of `range_doppler`; derivatives by a station's position and velocity are those",
        "of its own range and rate",
    ),
}
EQUATIONS = {f"{name}{end}": text for end in ("", PLANE) for name, text in _EQUATIONS.items()}
