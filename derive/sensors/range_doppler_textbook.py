"""Range, range rate and their derivatives as textbooks have them: differentiated plain formulas.

Kernels are compared with these, never printed from them: they hold powers of the range up to the
fifth.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import sympy as sp

from gainproof.derive.algebra.derivative import by
from gainproof.derive.expression import real
from gainproof.derive.pages.kernel_formulas import PLANE
from gainproof.derive.sensors.range_doppler_names import (
    LIGHT,
    PLANE_AXES,
    SPACE_AXES,
    pairs,
    places,
    velocities,
)

Formulas = dict[str, sp.Expr]
Axes = tuple[str, ...]


def textbook() -> Mapping[str, Formulas]:
    """The outputs of each kernel over its inputs."""
    found: dict[str, Formulas] = {}
    for along, end in ((SPACE_AXES, ""), (PLANE_AXES, PLANE)):
        for name, formulas in _one_station(along).items():
            found[f"{name}{end}"] = formulas
        for name, formulas in _two_stations(along).items():
            found[f"{name}{end}"] = formulas
    return found


def _one_station(along: Axes) -> dict[str, Formulas]:
    distance, rate = _range(along, "station"), _rate(along, "station")
    shift = -rate * real("carrier_frequency") / LIGHT
    unit, turning = _slopes("range", distance, along), _slopes("range_rate", rate, along)
    by_velocity = {
        f"range_rate_D_{name.removeprefix('target_')}": by(rate, real(name))
        for name in velocities("target", along)
    }
    shifted = {
        f"doppler_shift_D_{name.removeprefix('target_')}": by(shift, real(name))
        for name in (*places("target", along), *velocities("target", along))
    }
    return {
        "slant_range": {"slant_range": distance},
        "range_jacobian": unit,
        "range_rate": {"range_rate": rate},
        "range_rate_jacobian": turning | by_velocity,
        "range_doppler": {"slant_range": distance, "range_rate": rate, **unit, **turning},
        "range_hessian": _bends("range", distance, along),
        "range_rate_hessian": _bends("range_rate", rate, along),
        "doppler_shift": {"doppler_shift": shift, **shifted},
    }


def _two_stations(along: Axes) -> dict[str, Formulas]:
    stations = ("first_station", "second_station")
    (one, other), (first, second) = (
        [formula(along, who) for who in stations] for formula in (_range, _rate)
    )
    kernels = (
        ("bistatic_range_doppler", "bistatic_range", "bistatic_range_rate", 1),
        ("range_doppler_difference", "range_difference", "range_rate_difference", -1),
    )
    found: dict[str, Formulas] = {}
    for kernel, name, rated, sign in kernels:
        values = {name: one + sign * other, rated: first + sign * second}
        slopes = [_slopes(each, value, along) for each, value in values.items()]
        found[kernel] = values | slopes[0] | slopes[1]
    return found


def _range(along: Axes, station: str) -> sp.Expr:
    return sp.sqrt(sp.Add(*(each**2 for each in _apart(places, along, station))))


def _rate(along: Axes, station: str) -> sp.Expr:
    place, velocity = (_apart(kind, along, station) for kind in (places, velocities))
    product = sp.Add(*(a * b for a, b in zip(place, velocity, strict=True)))
    return product / _range(along, station)


def _apart(kind: Callable[[str, Axes], Axes], along: Axes, station: str) -> list[sp.Expr]:
    names = zip(kind("target", along), kind(station, along), strict=True)
    return [real(target) - real(other) for target, other in names]


def _slopes(what: str, value: sp.Expr, along: Axes) -> Formulas:
    return {f"{what}_D_{axis}": by(value, real(f"target_{axis}")) for axis in along}


def _bends(what: str, value: sp.Expr, along: Axes) -> Formulas:
    return {
        f"{what}_D_{a}{b}": by(by(value, real(f"target_{a}")), real(f"target_{b}"))
        for a, b in pairs(along)
    }
