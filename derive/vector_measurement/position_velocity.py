"""The whole derivation of a family with position and velocity measured.

The steps are the page `position-velocity` of `derive/pages`; here is what it does not say.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import sympy as sp

from gainproof.derive.algebra.derivative import derivative
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Derivation, Step, kernel_step
from gainproof.derive.expression import real
from gainproof.derive.model import Model
from gainproof.derive.pages.derivation import FOLDER, Given, written
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.subject import Program, Subject
from gainproof.derive.vector_measurement import module, pole_kernels, pole_towers, poles, radicands
from gainproof.derive.vector_measurement.context import Context, context
from gainproof.derive.vector_measurement.corner_towers import (
    fixed_index_tower,
    narrow_tower,
    outer_tower,
)
from gainproof.derive.vector_measurement.derivative_kernels import DERIVATIVES, SCALE
from gainproof.derive.vector_measurement.evidence_hints import hints, tower_ends
from gainproof.derive.vector_measurement.first_derivatives import Rates
from gainproof.derive.vector_measurement.limit_towers import FAR, ends_tower, index_tower
from gainproof.derive.vector_measurement.module import KNOWN
from gainproof.derive.vector_measurement.names import DELTA, INDEX, LATEX, RATIO, SIGMA, UPDATED
from gainproof.derive.vector_measurement.page_slots import page_slots
from gainproof.derive.vector_measurement.pole_kernels import MEAN, MODULUS, POLES, SQUARE
from gainproof.derive.vector_measurement.pole_towers import X
from gainproof.derive.vector_measurement.towers import graph_roots, rational, symbolic_noise

# These forms subtract computed values and lose digits; nothing is printed from them.

Forms = Mapping[str, sp.Expr]


def textbook_forms(c: Context) -> Mapping[str, Forms]:
    """Expressions by kernel and output, over Lambda and S alone: sigma from its quadratic, then
    the equations of the filter solved one after another.
    """
    noise, area = symbolic_noise(c.noise), INDEX**2
    n = rational(c.noise.n)
    one = sp.sqrt(c.spectrum.constant)
    mean = (one + sp.sqrt(radicands.eta_squared(noise, INDEX, RATIO)) / RATIO) / 2
    delta = sp.sqrt(mean**2 - 4)
    sigma = (mean + delta) / 2
    cross = (area * (1 / sigma + n * delta) + RATIO**2 * one) / (delta**2 + RATIO**2)
    rate = delta * cross - n * area
    step = 2 * cross / sigma + rate + rational(c.noise.first) * area
    first = 1 - (rate + area + RATIO**2) / (RATIO**2 * sigma**2)
    updated = {"updated_11": first, "updated_12": cross / sigma, "updated_22": rate}
    gains = {
        "gain_11": first,
        "gain_12": cross / sigma / RATIO**2,
        "gain_21": cross / sigma,
        "gain_22": rate / RATIO**2,
    }
    return {
        "gains": gains,
        POLES: _poles(gains),
        "updated_covariance": updated,
        "predicted_covariance": {
            "predicted_11": first + step,
            "predicted_12": cross * sigma,
            "predicted_22": rate + area,
        },
    }


def _poles(gains: Forms) -> Forms:
    """From trace and determinant of F (I - K)."""
    half = (2 - gains["gain_11"] - gains["gain_21"] - gains["gain_22"]) / 2
    product = (1 - gains["gain_11"]) * (1 - gains["gain_22"]) - gains["gain_12"] * gains["gain_21"]
    return {
        MEAN: half,
        MODULUS: sp.sqrt(product),
        SQUARE: half**2 - product,
    }


NAME = "position-velocity"
"""The page, for every process noise in reach."""


@dataclass(frozen=True)
class Printed:
    """What a source prints: its symbols as elements of the main tower, what the page's steps on it
    leave open, and what it says at steps of the derivation, by their ids.
    """

    elements: Callable[[Tower], Mapping[str, sp.Expr]]
    slots: Callable[[Tower], Mapping[str, object]]
    remarks: Mapping[str, str]

    def beside(self, step: Step) -> Step:
        """The step with what the source says there after its sentence."""
        remark = self.remarks.get(step.id)
        return replace(step, sentence=f"{step.sentence} {remark}") if remark else step


NOTHING = Printed(lambda _: {}, lambda _: {"source": ""}, {})


def derive_position_velocity(
    model: Model,
    sources: tuple[str, ...],
    printed: Printed = NOTHING,
    folder: Path = FOLDER,
) -> Subject:
    """Derive everything about the steady state of a model with position and velocity measured.

    `folder`: where the page is. Raises ModelError, naming the reason, for a model outside the
    method's reach, and PageError with the line of a mistake on the page.
    """
    c = context(model, printed.elements)
    graphs = module.graphs(c.noise)
    given = Given(
        towers=_towers(c),
        models={"model": c.model_data},
        slots={"": {**page_slots(c), **printed.slots(c.tower)}},
        hints=hints(c),
        ends=tower_ends(c.noise),
        steps={"kernels": kernel_steps(c, graphs)},
    )
    page = written(NAME, given, folder)
    steps = tuple(map(printed.beside, page.steps))
    latex = {
        **{
            name: shown for name, shown in {**page.latex, **LATEX}.items() if _occurs(c.tower, name)
        },
        **{quantity.name: quantity.latex for quantity in model.quantities},
    }
    return Subject(
        name=model.name,
        title=model.title,
        model=c.model,
        derivation=Derivation(page.opening, steps, sources, latex),
        towers=page.towers,
        programs={
            name: Program({entry: entry for entry in symbols_of(graph)}, graph)
            for name, graph in graphs.items()
        },
        module=module.kernel_module(c, graphs),
        textbook=lambda: textbook_forms(c),
    )


def _occurs(tower: Tower, name: str) -> bool:
    """Whether a name is that of something here: a source's symbols are on its own page alone."""
    return not name.startswith("source_") or name in tower.expressions


def _towers(c: Context) -> tuple[Tower, ...]:
    """All towers of a family."""
    noise = c.noise
    towers = (
        c.tower,
        _bending_tower(c.tower),
        ends_tower(noise),
        fixed_index_tower(noise),
        narrow_tower(noise),
        *pole_towers.pole_towers(noise),
    )
    return (*towers, index_tower(noise), outer_tower()) if noise.determinant else towers


def _bending_tower(main: Tower) -> Tower:
    """The main tower with D, the derivative of the updated covariance by Lambda^2, by name."""
    changes = {
        entry.replace("updated", "change"): derivative(main, real(entry), "tracking_index")
        for entry in UPDATED
    }
    named = {name: main.expression(value) / (2 * INDEX) for name, value in changes.items()}
    return Tower("bending", main.parameters, main.generators, {**main.expressions, **named})


A = real("pole_mean")


def kernel_steps(c: Context, graphs: Mapping[str, Graph]) -> list[Step]:
    """One step for each kernel; the position's limits live in the tower over the index alone."""
    known = "without_ratio" if c.noise.determinant else "ends"
    roots = {**graph_roots(c.noise), "far": FAR}
    steps = [
        kernel_step(
            name, graph, _meant(c, name, graph), known if name == KNOWN else "main", roots=roots
        )
        for name, graph in graphs.items()
        if name not in (pole_kernels.POLES, pole_kernels.REAL)
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
        kernel_step(pole_kernels.POLES, graph, outputs, pole_towers.POLES, roots=roots | places),
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
        kernel_step(
            pole_kernels.POLES,
            graph,
            {MEAN + SCALE: scale},
            tower,
            f"{pole_kernels.POLES}_{tower.removeprefix('poles_')}",
            roots=roots,
            branches={"second_size": branch},
            gaps={"second_size": size * distance * (RATIO + place)},
        )
        for tower, scale, branch, distance in sides
    ]


def _turning(c: Context, graph: Graph) -> Step:
    outputs = {output: real(output) for output in graph["outputs"]}
    roots = {"spread_root": pole_towers.spread_root(c.noise)}
    return kernel_step(pole_kernels.REAL, graph, outputs, pole_towers.TURNING, roots=roots)
