"""What the kernels of polar coordinates should return, by the oracle; and their sums of terms."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

import flint
from signed_graphs import with_terms

from gainproof.derive.sensors.polar_coordinates import graphs
from gainproof.verify.oracles import polar_enclosure

Values = Mapping[str, flint.arb]
PLACES, POLAR = ("x", "y", "z"), ("slant_range", "elevation", "bearing")
PLANE = "_in_plane"


def to_cartesian(r: float, e: float, b: float) -> Values:
    return dict(zip(PLACES, polar_enclosure.place(r, e, b), strict=True))


def to_polar(x: float, y: float, z: float) -> Values:
    return dict(zip(POLAR, polar_enclosure.polar(x, y, z), strict=True))


def cartesian_derivatives(r: float, e: float, b: float) -> Values:
    return _named(PLACES, POLAR, polar_enclosure.slopes(polar_enclosure.place, (r, e, b)))


def polar_derivatives(x: float, y: float, z: float) -> Values:
    return _named(POLAR, PLACES, polar_enclosure.polar_slopes((x, y, z)))


def noise_covariance(*given: float) -> Values:
    rows = polar_enclosure.covariance(given[:3], given[3:])
    return {f"covariance_{a}{b}": value for (a, b), value in _table(PLACES, PLACES, rows)}


def mean_of_converted(r: float, e: float, b: float, *deviations: float) -> Values:
    true, mean = polar_enclosure.place(r, e, b), polar_enclosure.mean_place((r, e, b), deviations)
    found = {f"mean_{name}": value for name, value in zip(PLACES, mean, strict=True)}
    with flint.ctx.workprec(polar_enclosure.BITS):
        for name, value, at in zip(PLACES, mean, true, strict=True):
            found[f"bias_{name}"] = value - at
    return found


def straight_course_rates(*given: float) -> Values:
    first, second = polar_enclosure.rates(given[:3], given[3:])
    names = ("range", "elevation", "bearing")
    rates = {f"{name}_rate": value for name, value in zip(names, first, strict=True)}
    return rates | {f"{name}_acceleration": v for name, v in zip(names, second, strict=True)}


IN_SPACE: Mapping[str, Callable[..., Values]] = {
    each.__name__: each
    for each in (
        to_cartesian,
        to_polar,
        cartesian_derivatives,
        polar_derivatives,
        noise_covariance,
        mean_of_converted,
        straight_course_rates,
    )
}
"""In the plane the same, without elevation, height and their noise."""
WITHOUT = {
    "to_cartesian": (1,),
    "to_polar": (2,),
    "cartesian_derivatives": (1,),
    "polar_derivatives": (2,),
    "noise_covariance": (1, 4),
    "mean_of_converted": (1, 3),
    "straight_course_rates": (2, 5),
}
"""Which arguments in space are 0 in the plane."""


def truth(kernel: str) -> Callable[..., Values]:
    """The truth of a kernel, from its arguments."""
    name = kernel.removesuffix(PLANE)
    if name == kernel:
        return IN_SPACE[name]

    def in_plane(*given: float) -> Values:
        values = list(given)
        for place in WITHOUT[name]:
            values.insert(place, 0.0)
        return IN_SPACE[name](*values)

    return in_plane


def terms(kernel: str) -> Callable[..., Values]:
    """The sums of terms taken positive: every sum in the graph over the magnitudes of its terms."""
    graph = _graphs()[kernel]
    names = [str(node[1]) for node in graph["nodes"] if node[0] == "symbol"]

    def found(*given: float) -> Values:
        point = dict(zip(arguments(kernel), given, strict=True))
        assert set(names) == set(point)
        return {name: total for name, (_, total) in with_terms(graph, point).items()}

    return found


def arguments(kernel: str) -> list[str]:
    """The names of a kernel's arguments in order."""
    from polar_points import signature

    from gainproof.generated import polar_coordinates

    return [domain.name for domain in signature(getattr(polar_coordinates, kernel)).inputs]


@cache
def _graphs() -> Mapping[str, Any]:
    return graphs()


def _named(rows: tuple[str, ...], columns: tuple[str, ...], values: Any) -> Values:
    return {f"{a}_D_{b}": value for (a, b), value in _table(rows, columns, values)}


def _table(rows: tuple[str, ...], columns: tuple[str, ...], values: Any) -> Any:
    for a, row in zip(rows, values, strict=True):
        for b, value in zip(columns, row, strict=True):
            yield (a, b), value
