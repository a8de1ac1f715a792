"""What the kernels of one station compute, entry by entry, in the plane and in space."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Step, kernel_step
from gainproof.derive.expression import column, real
from gainproof.derive.pages.kernel_formulas import PLANE
from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import Relation, equal
from gainproof.derive.sensors.range_doppler_names import LIGHT, PLANE_AXES, SPACE_AXES
from gainproof.derive.sensors.range_doppler_towers import (
    CARRIER,
    COS_B,
    RANGE,
    RATE,
    SIN_B,
    TILT,
    G,
    K,
    bearing_circle,
    frame,
    motions,
    of,
    rates,
    relative,
    tilt,
)


def along(tower: Tower) -> tuple[str, ...]:
    """The coordinates of a tower."""
    return PLANE_AXES if tower.name == "plane" else SPACE_AXES


def component_steps(towers: Sequence[Tower]) -> list[Step]:
    """What the names mean in each tower, and the derivatives along its parameters."""
    return [step for tower in towers for step in _steps(tower)]


def _steps(tower: Tower) -> list[Step]:
    name, axes = tower.name, along(tower)
    circle = bearing_circle()
    bearing = column(circle["cos_bearing"], circle["sin_bearing"])
    found = {"bearing": equal(column(COS_B, SIN_B), bearing)}
    if name != "plane":
        circle = tilt(1 if name == "above" else -1)
        found["tilt"] = equal(column(*map(real, circle)), column(*circle.values()))
    across = sp.ImmutableDenseMatrix(frame(axes))
    unit = sp.eye(len(axes)).as_immutable()
    found["frame"] = equal(sp.MatMul(across, across.T.as_immutable(), evaluate=False), unit)
    found["sight"] = named(relative(axes))
    found["station"] = named({k: v for k, v in motions(axes).items() if k.startswith("station")})
    found["target"] = named({k: v for k, v in motions(axes).items() if k.startswith("target")})
    found["parts"] = named(rates(axes))
    made = [quiet(f"{name}-{part}", relation, name) for part, relation in found.items()]
    return [*made, *_chains(tower)]


def quiet(name: str, relation: Relation, tower: str) -> Step:
    """What names mean, not shown."""
    return Step(name, "What the names mean.", relation, "As before.", tower=tower, shown=False)


def named(meant: Mapping[str, sp.Expr]) -> Relation:
    """Each name stands for its expression; of many entries rows of four, filled up with 0."""
    left, right = ([*side] for side in (map(real, meant), meant.values()))
    rows = -(-len(left) // 4)
    fill = [sp.Integer(0)] * (4 * rows - len(left))
    matrix = sp.ImmutableDenseMatrix
    return equal(matrix(rows, 4, [*left, *fill]), matrix(rows, 4, [*right, *fill]))


def _chains(tower: Tower) -> list[Step]:
    """Along each parameter of the place, and along each of the velocity."""
    axes, name = along(tower), tower.name
    unit, place, turning = (of(kind, axes) for kind in ("unit", "place", "turning"))
    angles = [G, K] if name == "plane" else [G, K, TILT]

    def chain(slope: Sequence[sp.Symbol], by: sp.Symbol) -> sp.Expr:
        return sp.Add(*(s * sp.Derivative(p, by) for s, p in zip(slope, place, strict=True)))

    ranges = column(*(sp.Derivative(RANGE, by) for by in (RANGE, *angles)))
    found = [
        quiet(
            f"{name}-range-chain",
            equal(ranges, column(*(chain(unit, by) for by in (RANGE, *angles)))),
            name,
        )
    ]
    # the velocity held: its own change along the parameter is taken off
    held = column(
        *(
            sp.Add(
                chain(turning, by),
                *(
                    u * sp.Derivative(w, by)
                    for u, w in zip(unit, of("velocity", axes), strict=True)
                ),
            )
            for by in (RANGE, *angles)
        )
    )
    rates = column(*(sp.Derivative(RATE, by) for by in (RANGE, *angles)))
    return [*found, quiet(f"{name}-rate-chain", equal(rates, held), name)]


def kernel_steps(graphs: Mapping[str, Graph]) -> list[Step]:
    """Each kernel computes what it says, in every tower of its dimension."""
    return [
        _kernel(name, graph, tower)
        for name, graph in graphs.items()
        for tower in (("plane",) if name.endswith(PLANE) else ("above", "below"))
    ]


def _kernel(name: str, graph: Graph, tower: str) -> Step:
    names = graph.get("names", {}).items()
    nodes = {str(number): real(name) for name, number in names if name != str(RANGE)}
    outputs = {each: meant(each) for each in graph["outputs"]}
    step = name if tower == "plane" else f"{name}_{tower}"
    return kernel_step(name, graph, outputs, tower, step, nodes, roots={"slant_range": RANGE})


def meant(output: str) -> sp.Expr:
    """What an output stands for, over the names of the towers."""
    what, _, by = output.partition("_D_")
    if what == "doppler_shift":
        slope = f"turning_{by}" if by in SPACE_AXES else f"unit_{by[-1:]}"
        return -real(slope if by else "range_rate") * CARRIER / LIGHT
    if not by:
        return real(what)
    if by[:-1] in SPACE_AXES:
        return _second(what, *by)
    if what == "range" or by.startswith("velocity_"):
        return real(f"unit_{by[-1]}")
    return real(f"turning_{by[-1]}")


def _second(what: str, a: str, b: str) -> sp.Expr:
    """An entry of P/f, or of M as the derivation writes it."""
    (u, v), (g, h) = (map(real, (f"{kind}_{a}", f"{kind}_{b}")) for kind in ("unit", "turning"))
    flat = sp.Integer(a == b) - u * v
    if what == "range":
        return flat / RANGE
    return -(u * h + g * v + RATE / RANGE * flat) / RANGE
