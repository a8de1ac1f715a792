"""The kernels for correlated noises of range and azimuth, as expression graphs."""

from __future__ import annotations

from gainproof.derive.printer.graph import Graph, Node
from gainproof.derive.sensors import converted_graphs

UNBIASED = "correlated_unbiased_conversion_in_plane"
MODIFIED = "correlated_modified_unbiased_conversion_in_plane"


def graphs() -> dict[str, Graph]:
    """Of the conversions that are unbiased given the truth, and given the measurement."""
    return {UNBIASED: _graph(truth=True), MODIFIED: _graph(truth=False)}


def _graph(truth: bool) -> Graph:
    have = converted_graphs.given()
    (correlation,) = have.draft.given("correlation")
    noise, kept = have.noise()
    together = (have.range_ * have.azimuth) * correlation
    square, twice = noise.kept * noise.kept, 1 - 2 * noise.kept
    short = noise.r * noise.lost
    radial = (short * short + noise.s2 * (1 + square)) / 2 - 2 * (square * (together * together))
    cross = ((noise.r * noise.r + noise.s2) * (noise.lost * (1 + noise.kept))) / 2
    cross = cross - (noise.kept * (together * together)) * twice
    mixed = -((noise.kept * (noise.r * together)) * twice)
    if truth:
        ahead, beside = noise.r / kept, -(together / kept)
        level, aside = short / kept, -((together * (1 + noise.kept)) / kept)
        radial, cross = radial + level * level, cross + aside * aside
        mixed = mixed + level * aside
    else:
        ahead, beside = noise.r * kept, together * kept
    return _turned(have, (ahead, beside), (radial, cross, mixed))


def _turned(
    have: converted_graphs.Given, place: tuple[Node, Node], axes: tuple[Node, Node, Node]
) -> Graph:
    """Place and covariance, the frame of the line of sight turned by the azimuth."""
    (ahead, beside), (radial, cross, mixed) = place, axes
    c, s = have.cos, have.sin
    along, over, both = c * c, s * s, s * c
    return have.draft.graph(
        {
            "x": ahead * c - beside * s,
            "y": ahead * s + beside * c,
            "covariance_xx": along * radial + over * cross - 2 * (both * mixed),
            "covariance_xy": both * (radial - cross) + (along - over) * mixed,
            "covariance_yy": over * radial + along * cross + 2 * (both * mixed),
        }
    )
