"""The kernels compute what the derivation calls their outputs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import Relation
from gainproof.derive.vector_measurement import pole_kernels, pole_towers, poles
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.derivative_kernels import DERIVATIVES, SCALE
from gainproof.derive.vector_measurement.ends import FAR
from gainproof.derive.vector_measurement.module import KNOWN
from gainproof.derive.vector_measurement.names import DELTA, INDEX, RATIO, SIGMA
from gainproof.derive.vector_measurement.pole_kernels import MEAN, MODULUS, SQUARE
from gainproof.derive.vector_measurement.pole_module import is_of_poles
from gainproof.derive.vector_measurement.pole_towers import X
from gainproof.derive.vector_measurement.rates import Rates
from gainproof.derive.vector_measurement.towers import graph_roots, rational

A = real("pole_mean")


def kernel_steps(c: Context, graphs: Mapping[str, Graph]) -> list[Step]:
    """One step for each kernel; the position's limits live in the tower over the index alone."""
    known = "without_ratio" if c.noise.determinant else "ends"
    roots = {**graph_roots(c.noise), "far": FAR}
    steps = [
        _program(name, "", _meant(c, name, graph), known if name == KNOWN else "main", graph, roots)
        for name, graph in graphs.items()
        if not is_of_poles(name)
    ]
    return steps + _pole_steps(c, graphs)


def _meant(c: Context, kernel: str, graph: Graph) -> dict[str, sp.Expr]:
    """What each output stands for; a scale is the sum of the terms whose difference it measures."""
    if kernel == KNOWN:
        return {output: real(f"known_{output}") for output in graph["outputs"]}
    _, by, variable = kernel.partition("_by_")
    if not by:
        return {output: real(output) for output in graph["outputs"]}
    found = DERIVATIVES[kernel](Rates(c.basis))
    return {
        output: sp.Add(*found[output.removesuffix(SCALE)])
        if output.endswith(SCALE)
        else sp.Derivative(real(output), real(variable))
        for output in graph["outputs"]
    }


def _pole_steps(c: Context, graphs: Mapping[str, Graph]) -> list[Step]:
    """One step for each kernel of the poles, and one on each side for what an absolute value has
    part in.
    """
    graph = graphs[pole_kernels.POLES]
    squared: sp.Expr = sp.Integer(1)
    if c.noise.determinant:
        squared += rational(poles.spread(c.noise)) * INDEX**2
    near = INDEX**2 * (1 / RATIO**2 - rational(poles.centre(c.noise)))
    outputs = {
        MEAN: A,
        MODULUS: 1 / SIGMA,
        SQUARE: A**2 - 1 / SIGMA**2,
        SQUARE + SCALE: (near**2 + (2 * INDEX) ** 2 * squared) / (2 * SIGMA * DELTA) ** 2,
    }
    roots, places = graph_roots(c.noise), {}
    if c.noise.e != 1:
        roots["slope_place"] = pole_towers.place(c.noise)
        places["centre_place"] = pole_towers.centre_place(c.noise)
    return [
        _program(pole_kernels.POLES, "", outputs, pole_towers.POLES, graph, roots | places),
        *_sides(c, graph, roots),
        _turning(c, graphs[pole_kernels.REAL]),
    ]


def _sides(c: Context, graph: Graph, roots: Mapping[str, sp.Expr]) -> list[Step]:
    """What half the sum is measured by is itself while 1/S^2 is above f; then its terms' sum."""
    if c.noise.e == 1:
        return []
    place = pole_towers.place(c.noise)
    x = c.basis
    both = x.index * x.width + x.eta_scaled
    size = x.index / both * x.index / x.sigma_scaled * rational(poles.slope(c.noise))
    sides: tuple[tuple[str, sp.Expr, str, sp.Expr], ...] = (
        (pole_towers.BELOW, A, "negative", place * X / (1 + X)),
        (pole_towers.ABOVE, 4 / (SIGMA**2 + 1) - A, "positive", X),
    )
    return [
        _program(
            pole_kernels.POLES,
            f"-{tower.removeprefix('poles_')}",
            {MEAN + SCALE: scale},
            tower,
            graph,
            roots,
            {"second_size": branch},
            {"second_size": size * distance * (RATIO + place)},
        )
        for tower, scale, branch, distance in sides
    ]


def _turning(c: Context, graph: Graph) -> Step:
    outputs = {output: real(output) for output in graph["outputs"]}
    roots = {"spread_root": pole_towers.spread_root(c.noise)}
    return _program(pole_kernels.REAL, "", outputs, pole_towers.TURNING, graph, roots)


def _program(
    kernel: str,
    suffix: str,
    outputs: Mapping[str, sp.Expr],
    tower: str,
    graph: Graph,
    roots: Mapping[str, sp.Expr],
    branches: Mapping[str, str] | None = None,
    gaps: Mapping[str, Any] | None = None,
) -> Step:
    return Step(
        f"kernel-{kernel.replace('_', '-')}{suffix}",
        f"The kernel {kernel} computes what it says.",
        Relation("program", {"program": kernel, "outputs": outputs}),
        "Evaluate the kernel's graph in the tower.",
        tower=tower,
        hint={"graph": graph, "roots": roots, "branches": branches or {}, "gaps": gaps or {}},
        shown=False,
    )
