"""The kernels of two stations, as expression graphs."""

from __future__ import annotations

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.sensors.range_doppler_forms import Sight, differences, dot
from gainproof.derive.sensors.range_doppler_graphs import RANGE, Outputs, named, sight, symbols
from gainproof.derive.sensors.range_doppler_names import PLANE, PLANE_AXES, SPACE_AXES

OTHER = "other_range"


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    made = {
        "bistatic_range_doppler": bistatic_range_doppler,
        "range_doppler_difference": range_doppler_difference,
    }
    return {
        f"{name}{end}": graph(along)
        for along, end in ((SPACE_AXES, ""), (PLANE_AXES, PLANE))
        for name, graph in made.items()
    }


def bistatic_range_doppler(along: tuple[str, ...]) -> Graph:
    """Sums of ranges and rates, with derivatives."""
    builder = GraphBuilder()
    target, *stations = _motions(builder, along)
    one, other = (sight(builder, target, station) for station in stations)
    outputs = {
        "bistatic_range": one.range + other.range,
        "bistatic_range_rate": one.rate + other.rate,
    }
    for axis, u, v in zip(along, one.unit, other.unit, strict=True):
        outputs[f"bistatic_range_D_{axis}"] = u + v
    for axis, h, k in zip(along, one.turning, other.turning, strict=True):
        outputs[f"bistatic_range_rate_D_{axis}"] = h + k
    return _graph(builder, one, other, outputs, {})


def range_doppler_difference(along: tuple[str, ...]) -> Graph:
    """Differences of ranges and rates, with derivatives, from what the stations differ by."""
    builder = GraphBuilder()
    target, first, second = _motions(builder, along)
    one, other = (sight(builder, target, station) for station in (first, second))
    baseline, drift = (differences(b, a) for a, b in zip(first, second, strict=True))
    reach = [a + b for a, b in zip(one.place, other.place, strict=True)]
    apart = dot(baseline, reach) / (one.range + other.range)
    units = [(s - apart * v) / one.range for s, v in zip(baseline, other.unit, strict=True)]
    rates = dot(one.unit, drift) + dot(units, other.velocity)
    turned = [
        (((d - rates * u) - other.rate * e) - apart * k) / one.range
        for d, u, e, k in zip(drift, one.unit, units, other.turning, strict=True)
    ]
    outputs = {"range_difference": apart, "range_rate_difference": rates}
    outputs |= {f"range_difference_D_{axis}": each for axis, each in zip(along, units, strict=True)}
    outputs |= {
        f"range_rate_difference_D_{axis}": each for axis, each in zip(along, turned, strict=True)
    }
    also = {
        f"{word}_{axis}": each
        for word, vector in (("baseline", baseline), ("drift", drift), ("reach", reach))
        for axis, each in zip(along, vector, strict=True)
    }
    return _graph(builder, one, other, outputs, {**also, **outputs})


def _motions(builder: GraphBuilder, along: tuple[str, ...]) -> list[tuple[list[Node], list[Node]]]:
    who = ("target", "first_station", "second_station")
    return [symbols(builder, along, each, True) for each in who]


def _graph(
    builder: GraphBuilder,
    one: Sight,
    other: Sight,
    outputs: Outputs,
    also: Outputs,
) -> Graph:
    """With both ranges, which have to be above 0."""
    ranges = {RANGE: one.range, OTHER: other.range}
    names = named(one) | named(other, "other_") | also
    return builder.graph({**outputs, **ranges}, {**names, **ranges})
