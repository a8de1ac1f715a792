"""The kernels for correlated noises of range and azimuth: graphs, and what they compute."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.derivation import Step
from gainproof.derive.expression import column, real
from gainproof.derive.printer.graph import Graph, Node
from gainproof.derive.relation import Relation, equal
from gainproof.derive.sensors import converted_graphs
from gainproof.derive.sensors.converted_correlated_tower import LESS, MORE
from gainproof.derive.sensors.converted_names import (
    COS_A,
    KEPT,
    SIGMA_A,
    SIGMA_R,
    SIN_A,
    G,
    K,
    L,
    R,
)

UNBIASED = "correlated_unbiased_conversion_in_plane"
MODIFIED = "correlated_modified_unbiased_conversion_in_plane"
RHO = real("correlation")


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


def correlated_kernel_steps(plain: Mapping[str, Graph]) -> list[Step]:
    """Each kernel computes what it says; `plain` are graphs without calls."""
    below = (1 + G**2) * (1 + K**2)
    named = equal(
        column(COS_A, SIN_A, real("change_azimuth"), RHO),
        column(
            (4 * G * K - (1 - G**2) * (1 - K**2)) / below,
            -(2 * G * (1 - K**2) + 2 * K * (1 - G**2)) / below,
            L - 1,
            MORE - LESS,
        ),
    )
    tower, text = "correlated_plane", "What the names mean."
    return [
        Step("correlated-plane", text, named, "As before.", tower=tower, shown=False),
        _kernel(UNBIASED, plain[UNBIASED]),
        _kernel(MODIFIED, plain[MODIFIED]),
    ]


def _kernel(name: str, graph: Graph) -> Step:
    """Mean squares in x and y of the true place given the measurement, less what they should."""
    c = RHO * SIGMA_R * SIGMA_A
    cos2, sin2 = COS_A**2 - SIN_A**2, 2 * SIN_A * COS_A
    real_part = R**2 + SIGMA_R**2 - 4 * c**2  # of the mean of the squared place, turned back
    whole, across = R**2 + SIGMA_R**2, 4 * R * c
    xx = (whole + L**2 * (real_part * cos2 - across * sin2)) / 2
    yy = (whole - L**2 * (real_part * cos2 - across * sin2)) / 2
    xy = L**2 * (real_part * sin2 + across * cos2) / 2
    mean = KEPT * (R * COS_A - c * SIN_A), KEPT * (R * SIN_A + c * COS_A)
    place = mean
    if name == UNBIASED:
        place = (R * COS_A + c * SIN_A) / KEPT, (R * SIN_A - c * COS_A) / KEPT
    off = tuple(p - m for p, m in zip(place, mean, strict=True))
    meant = {
        "x": place[0],
        "y": place[1],
        "covariance_xx": xx - mean[0] ** 2 + off[0] ** 2,
        "covariance_xy": xy - mean[0] * mean[1] + off[0] * off[1],
        "covariance_yy": yy - mean[1] ** 2 + off[1] ** 2,
        "kept_azimuth_of": -(SIGMA_A**2) / 2,
        "change_azimuth_of": -(SIGMA_A**2),
    }
    return Step(
        f"kernel-{name.replace('_', '-')}",
        f"The kernel {name} computes what it says.",
        Relation(
            "program",
            {"program": name, "outputs": {each: meant[each] for each in graph["outputs"]}},
        ),
        "Mean squares less squares of means, and squares of what the place is off the mean.",
        tower="correlated_plane",
        hint={"graph": graph},
        shown=False,
    )
