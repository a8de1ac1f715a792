"""The kernels of one station, as expression graphs."""

from __future__ import annotations

from collections.abc import Callable

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.sensors.range_doppler_forms import (
    Sight,
    across,
    bending,
    differences,
    dot,
)
from gainproof.derive.sensors.range_doppler_names import (
    LIGHT,
    PLANE,
    PLANE_AXES,
    SPACE_AXES,
    places,
    velocities,
)

RANGE = "slant_range"
Outputs = dict[str, Node]
Motion = tuple[list[Node], list[Node]]
"""A position, and a velocity or nothing."""


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    made: dict[str, Callable[[tuple[str, ...]], Graph]] = {
        "slant_range": slant_range,
        "range_jacobian": range_jacobian,
        "range_rate": range_rate,
        "range_rate_jacobian": range_rate_jacobian,
        "range_doppler": range_doppler,
        "range_hessian": range_hessian,
        "range_rate_hessian": range_rate_hessian,
        "doppler_shift": doppler_shift,
    }
    return {
        f"{name}{end}": graph(along)
        for along, end in ((SPACE_AXES, ""), (PLANE_AXES, PLANE))
        for name, graph in made.items()
    }


def symbols(builder: GraphBuilder, along: tuple[str, ...], who: str, moving: bool) -> Motion:
    """Position and velocity of a target or a station."""
    place = [builder.symbol(name) for name in places(who, along)]
    return place, [builder.symbol(name) for name in velocities(who, along)] if moving else []


def sight(builder: GraphBuilder, target: Motion, station: Motion) -> Sight:
    """The target from the station."""
    place, velocity = (differences(*each) for each in zip(target, station, strict=True))
    distance = builder.sqrt(dot(place, place))
    return Sight(distance, [each / distance for each in place], velocity, place)


def seen(builder: GraphBuilder, along: tuple[str, ...], *, moving: bool = True) -> Sight:
    """The target from one station."""
    return sight(builder, *(symbols(builder, along, who, moving) for who in ("target", "station")))


def slant_range(along: tuple[str, ...]) -> Graph:
    """The range."""
    builder = GraphBuilder()
    return _graph(builder, seen(builder, along, moving=False), {})


def range_jacobian(along: tuple[str, ...]) -> Graph:
    """The unit vector."""
    builder = GraphBuilder()
    found = seen(builder, along, moving=False)
    return _graph(builder, found, unit_vector(found, along))


def range_rate(along: tuple[str, ...]) -> Graph:
    """The range rate."""
    builder = GraphBuilder()
    found = seen(builder, along)
    return _graph(builder, found, {"range_rate": found.rate})


def range_rate_jacobian(along: tuple[str, ...]) -> Graph:
    """By the position and by the velocity."""
    builder = GraphBuilder()
    found = seen(builder, along)
    by_velocity = {
        f"range_rate_D_velocity_{axis}": each for axis, each in zip(along, found.unit, strict=True)
    }
    return _graph(builder, found, turning(found, along) | by_velocity)


def range_doppler(along: tuple[str, ...]) -> Graph:
    """Values and derivatives at once; the derivative by the velocity is that of the range."""
    builder = GraphBuilder()
    found = seen(builder, along)
    values = {RANGE: found.range, "range_rate": found.rate}
    return _graph(builder, found, values | unit_vector(found, along) | turning(found, along))


def range_hessian(along: tuple[str, ...]) -> Graph:
    """By the position, twice; of the range rate by position and velocity too."""
    builder = GraphBuilder()
    found = seen(builder, along, moving=False)
    entries = {at: p / found.range for at, p in across(found.unit).items()}
    return _graph(builder, found, _twice("range", along, entries))


def range_rate_hessian(along: tuple[str, ...]) -> Graph:
    """By the position, twice."""
    builder = GraphBuilder()
    found = seen(builder, along)
    return _graph(builder, found, _twice("range_rate", along, bending(found)))


def _twice(what: str, along: tuple[str, ...], entries: dict[tuple[int, int], Node]) -> Outputs:
    return {f"{what}_D_{along[i]}{along[j]}": each for (i, j), each in entries.items()}


def unit_vector(found: Sight, along: tuple[str, ...]) -> Outputs:
    """The derivative of the range by the target's position."""
    return {f"range_D_{axis}": each for axis, each in zip(along, found.unit, strict=True)}


def turning(found: Sight, along: tuple[str, ...]) -> Outputs:
    """The derivative of the range rate by the target's position."""
    return {f"range_rate_D_{axis}": each for axis, each in zip(along, found.turning, strict=True)}


def doppler_shift(along: tuple[str, ...]) -> Graph:
    """In hertz, with derivatives by the target's position and velocity."""
    builder = GraphBuilder()
    found = seen(builder, along)
    scale = -(builder.symbol("carrier_frequency") / LIGHT)
    outputs = {"doppler_shift": found.rate * scale}
    for axis, h in zip(along, found.turning, strict=True):
        outputs[f"doppler_shift_D_{axis}"] = h * scale
    for axis, u in zip(along, found.unit, strict=True):
        outputs[f"doppler_shift_D_velocity_{axis}"] = u * scale
    return _graph(builder, found, outputs)


def named(found: Sight, start: str = "") -> Outputs:
    """The parts that proofs put names for."""
    parts = {"place": found.place, "velocity": found.velocity}
    if found.velocity:
        parts["turning"] = found.turning
    entries = {
        f"{start}{part}_{axis}": each
        for part, vector in parts.items()
        for axis, each in zip(SPACE_AXES, vector, strict=False)
    }
    return entries | ({f"{start}range_rate": found.rate} if found.velocity else {})


def _graph(builder: GraphBuilder, found: Sight, outputs: Outputs) -> Graph:
    """The outputs, and the range, which has to be above 0."""
    return builder.graph({**outputs, RANGE: found.range}, {**named(found), RANGE: found.range})
