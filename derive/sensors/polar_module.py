"""The printed module of polar coordinates: domains of its kernels, and what they say."""

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
from gainproof.derive.sensors.polar_graphs import PLANE

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

_SPACE = {
    "to_cartesian": "East, north and up from range, elevation and bearing.",
    "to_polar": "Range, elevation and bearing from east, north and up.",
    "cartesian_derivatives": "Derivatives of x, y, z by range, elevation and bearing.",
    "polar_derivatives": "Derivatives of range, elevation and bearing by x, y, z.",
    "noise_covariance": "Covariance of a converted measurement to first order in its noise.",
    "mean_of_converted": "Mean and bias of a converted measurement under Gaussian angle noise.",
    "straight_course_rates": "Rates of range and angles, and theirs, on a straight uniform course.",
}
_IN_PLANE = {
    "to_cartesian": "East and north from range and bearing in the plane.",
    "to_polar": "Range and bearing from east and north in the plane.",
    "cartesian_derivatives": "Derivatives of x and y by range and bearing in the plane.",
    "polar_derivatives": "Derivatives of range and bearing by x and y in the plane.",
    "noise_covariance": "Covariance of a converted measurement to first order, in the plane.",
    "mean_of_converted": "Mean and bias of a converted measurement in the plane.",
    "straight_course_rates": "Rates of range and bearing, and theirs, on a straight uniform course "
    "in the plane.",
}
SUMMARIES = {**_SPACE, **{f"{name}{PLANE}": text for name, text in _IN_PLANE.items()}}

EQUATIONS: dict[str, tuple[str, ...]] = {
    "to_cartesian": ("x = R cos E sin B, y = R cos E cos B, z = R sin E",),
    "to_polar": (
        "R = sqrt(x^2 + y^2 + z^2), E = atan2(z, sqrt(x^2 + y^2)), B = atan2(x, y).",
        "In the south the sign of a zero x decides between B = pi and -pi; where x = y = 0 nothing",
        "determines the bearing, and signs of zeros make it 0 or +-pi",
    ),
    "cartesian_derivatives": (
        "x_D_slant_range = cos E sin B, x_D_elevation = -R sin E sin B, x_D_bearing = y,",
        "y_D_slant_range = cos E cos B, y_D_elevation = -R sin E cos B, y_D_bearing = -x,",
        "z_D_slant_range = sin E, z_D_elevation = R cos E; z_D_bearing is 0",
    ),
    "polar_derivatives": (
        "slant_range_D_x = x/R and so on, elevation_D_x = -x z/(h R^2),",
        "elevation_D_y = -y z/(h R^2), elevation_D_z = h/R^2, bearing_D_x = y/h^2,",
        "bearing_D_y = -x/h^2, h = sqrt(x^2 + y^2), R = sqrt(h^2 + z^2); bearing_D_z is 0",
    ),
    "noise_covariance": (
        "J diag(sR^2, sE^2, sB^2) J' with J of `cartesian_derivatives`: at the true place the",
        "covariance of the converted position to first order, at the measured one its estimate",
    ),
    "mean_of_converted": (
        "mean_x = x exp(-(sE^2 + sB^2)/2), mean_y likewise, mean_z = z exp(-sE^2/2),",
        "bias = mean - true value, with x, y, z of `to_cartesian` at the true place. Exact where",
        "the noises are independent, of mean 0, and those of the angles Gaussian",
    ),
    "straight_course_rates": (
        "With the components w_R, w_E, w_B of the velocity in the directions in which range,",
        "elevation and bearing grow: R' = w_R, E' = w_E/R, B' = w_B/h, R'' = (w_E^2 + w_B^2)/R,",
        "E'' = -(2 w_R w_E + tan E w_B^2)/R^2, B'' = -2 B' h'/h; h = sqrt(x^2 + y^2)",
    ),
    "to_cartesian_in_plane": ("x = R sin B, y = R cos B",),
    "to_polar_in_plane": (
        "R = sqrt(x^2 + y^2), B = atan2(x, y). In the south the sign of a zero x decides between",
        "B = pi and -pi; at the origin signs of zeros make it 0 or +-pi",
    ),
    "cartesian_derivatives_in_plane": (
        "x_D_slant_range = sin B, x_D_bearing = y, y_D_slant_range = cos B, y_D_bearing = -x",
    ),
    "polar_derivatives_in_plane": (
        "slant_range_D_x = x/R, slant_range_D_y = y/R, bearing_D_x = y/R^2, bearing_D_y = -x/R^2",
    ),
    "noise_covariance_in_plane": (
        "J diag(sR^2, sB^2) J' with J of `cartesian_derivatives_in_plane`: at the true place the",
        "covariance of the converted position to first order, at the measured one its estimate",
    ),
    "mean_of_converted_in_plane": (
        "mean = exp(-sB^2/2) (x, y), bias = mean - (x, y), x and y of `to_cartesian_in_plane` at",
        "the true place. Exact where the noises are independent, of mean 0, and that of the",
        "bearing Gaussian",
    ),
    "straight_course_rates_in_plane": (
        "With the components w_R, w_B of the velocity along and across the line of sight",
        "R' = w_R, B' = w_B/R, R'' = w_B^2/R, B'' = -2 B' R'/R",
    ),
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
