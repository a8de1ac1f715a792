"""Steps on what the kernels compute, by components in the plane and in space."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import Relation, described, equal
from gainproof.derive.sensors.polar_names import G, K, column
from gainproof.derive.sensors.polar_steps_map import BELOW
from gainproof.derive.sensors.range_doppler_names import PLANE, PLANE_AXES, SPACE_AXES
from gainproof.derive.sensors.range_doppler_towers import (
    COS_B,
    COS_T,
    RANGE,
    SIN_B,
    SIN_T,
    TILT,
    meanings,
    of,
)

SIDES = {"plane": "", "above": " (the target above)", "below": " (the target below)"}


def along(tower: Tower) -> tuple[str, ...]:
    """The coordinates of a tower."""
    return PLANE_AXES if tower.name == "plane" else SPACE_AXES


def component_steps(towers: Sequence[Tower]) -> list[Step]:
    """What the names mean in each tower, and the derivatives along its parameters."""
    opening = Step(
        "components",
        "The kernels compute entries. In the plane `u = (\\sin B, \\cos B)` with any bearing `B`; "
        "in space it is tilted from straight up by any angle but a half turn, and from straight "
        "down likewise, so that no direction is left out.",
        described("r = f u, w = (w_x, w_y, w_z), L = B + r, L' = B' + w, all of any sign"),
        "Sines and cosines are fractions of polynomials in tangents of half angles. What each "
        "kernel computes is proved for all of these numbers; the derivatives once more, along each "
        "parameter of the place.",
        "plane",
        heading="What the kernels compute",
    )
    return [opening, *(step for tower in towers for step in _steps(tower))]


def _steps(tower: Tower) -> list[Step]:
    name, axes_ = tower.name, along(tower)
    bearing = column(
        (4 * G * K - (1 - G**2) * (1 - K**2)) / BELOW,
        -(2 * G * (1 - K**2) + 2 * K * (1 - G**2)) / BELOW,
    )
    direction: tuple[sp.Expr, ...] = (SIN_B, COS_B)
    made = [_quiet(f"{name}-bearing", equal(column(COS_B, SIN_B), bearing), name)]
    if name != "plane":
        side = 1 if name == "above" else -1
        tilt = column(side * (1 - TILT**2) / (1 + TILT**2), 2 * TILT / (1 + TILT**2))
        made.append(_quiet(f"{name}-tilt", equal(column(COS_T, SIN_T), tilt), name))
        direction = (SIN_T * SIN_B, SIN_T * COS_B, COS_T)
    unit = of("unit", axes_)
    made.append(_quiet(f"{name}-unit", equal(column(*unit), column(*direction)), name))
    one = sp.Add(*(each**2 for each in unit))
    made.append(_quiet(f"{name}-unit-length", equal(one, sp.Integer(1)), name))
    meant = meanings(axes_)
    for start in range(0, len(meant), 8):
        part = dict(list(meant.items())[start : start + 8])
        relation = equal(column(*map(real, part)), column(*part.values()))
        made.append(_quiet(f"{name}-names-{start // 8 + 1}", relation, name))
    return [*made, *_chains(tower)]


def _chains(tower: Tower) -> list[Step]:
    """Along each parameter of the place, and along the velocity."""
    axes_ = along(tower)
    unit, place, turning = (of(kind, axes_) for kind in ("unit", "place", "turning"))
    parameters = [RANGE, G, K] if tower.name == "plane" else [RANGE, G, K, TILT]
    found = []
    for value, slope, what in ((RANGE, unit, "range"), (real("range_rate"), turning, "rate")):
        sides = [
            [
                sp.Derivative(value, by),
                sp.Add(*(s * sp.Derivative(p, by) for s, p in zip(slope, place, strict=True))),
            ]
            for by in parameters
        ]
        left, right = (column(*each) for each in zip(*sides, strict=True))
        found.append(_quiet(f"{tower.name}-{what}-chain", equal(left, right), tower.name))
    faster = [sp.Derivative(real("range_rate"), real(f"more_{axis}")) for axis in axes_]
    relation = equal(column(*faster), column(*unit))
    return [*found, _quiet(f"{tower.name}-rate-by-velocity", relation, tower.name)]


def kernel_steps(graphs: Mapping[str, Graph]) -> list[Step]:
    """Each kernel computes what it says, in every tower of its dimension."""
    return [
        _kernel(name, graph, tower)
        for name, graph in graphs.items()
        for tower in (("plane",) if name.endswith(PLANE) else ("above", "below"))
    ]


def _quiet(name: str, relation: Relation, tower: str) -> Step:
    return Step(name, "What the names mean.", relation, "As before.", tower=tower, shown=False)


def _kernel(name: str, graph: Graph, tower: str) -> Step:
    end = "" if tower == "plane" else f"-{tower}"
    return Step(
        f"kernel-{name.replace('_', '-')}{end}",
        f"The kernel {name} computes what it says{SIDES[tower]}.",
        Relation(
            "program",
            {"program": name, "outputs": {each: meant(each) for each in graph["outputs"]}},
        ),
        "Evaluate the kernel's graph.",
        tower=tower,
        hint={"graph": graph, "roots": {"slant_range": RANGE}},
        shown=False,
    )


def meant(output: str) -> sp.Expr:
    """The quantity of the tower that an output stands for."""
    what, _, by = output.partition("_D_")
    if not by:
        return real(what)
    if what == "range" or by.startswith("velocity_"):
        return real(f"unit_{by[-1]}")
    return real(f"turning_{by[-1]}")
