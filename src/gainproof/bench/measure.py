"""One kernel's figures: time over that of C, of lambdify and of SciPy, and its worst error."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp

from gainproof.bench.accuracy import ball_outputs, error, log_uniform, signed_points, terms
from gainproof.bench.arguments import Arguments, fitting, sample, with_constants
from gainproof.bench.compiler import compiled, compiler
from gainproof.bench.solver import solver_seconds
from gainproof.bench.subjects import Measured
from gainproof.bench.timing import best_times
from gainproof.derive.printer.c_language.loop import c_loop

SIZE = 1_000_000
ERROR_POINTS = 400
EPSILON = 2.0**-52
BLOCK = 16384


@dataclass(frozen=True)
class Figures:
    """Ratios of one kernel; None where there is nothing to compare with.

    over_c: kernel time over C time; shared_over_c: the same where threads share the blocks.
    passes_over_c: the same for the bare NumPy calls on one block that stays in the cache, without
    guards and memory traffic: what no NumPy kernel of this graph can beat in one thread.
    under_lambdify, under_solver: the other's time over the kernel's; fresh_under_lambdify: where
    the kernel too makes the arrays of its outputs. worst: the greatest measured error of any
    output in units of 2^-52, with `proved` the proved bound of that output.
    """

    over_c: float | None
    shared_over_c: float | None
    passes_over_c: float | None
    under_lambdify: float | None
    fresh_under_lambdify: float | None
    under_solver: float | None
    worst: float
    proved: float


def figures(item: Measured, folder: Path, workers: int = 2, constant: str | None = None) -> Figures:
    """Measure one kernel; inputs whose names begin with `constant` are one number each."""
    columns = sample(item.signature, SIZE)
    given = with_constants(item.signature, columns, constant)
    outputs = tuple(np.empty(SIZE) for _ in item.kernel.outputs)
    calls: dict[str, Callable[[], object]] = {
        "kernel": lambda: item.function(*given, out=outputs),
        "shared": lambda: item.function(*given, out=outputs, workers=workers),
        "fresh": lambda: item.function(*given),
        "passes": bare_passes(item, given),
    }
    # C reads arrays only: beside numbers it would be told too slow
    if compiler() is not None and constant is None:
        # a library of its own for each kernel: the loader knows libraries by their path
        place = folder / item.subject
        place.mkdir(exist_ok=True)
        loop = compiled(c_loop(item.kernel), item.kernel.name, place)
        targets = [np.empty(SIZE) for _ in item.kernel.outputs]
        calls["C"] = lambda: loop(columns, targets)
    if item.textbook is not None:
        plain = lambdified(item)
        calls["lambdify"] = lambda: plain(*given)
    with np.errstate(all="ignore"):  # textbook forms cancel, divide by zero and overflow
        best = best_times(calls)
    solver = None
    if item.model is not None:
        solver = solver_seconds(item.model, [each.name for each in item.kernel.inputs])
    worst, proved = worst_error(item)
    over_c = {name: taken / best["C"] for name, taken in best.items()} if "C" in best else {}
    plain_time = best.get("lambdify")
    return Figures(
        over_c.get("kernel"),
        over_c.get("shared"),
        over_c.get("passes"),
        None if plain_time is None else plain_time / best["kernel"],
        None if plain_time is None else plain_time / best["fresh"],
        None if solver is None else solver * SIZE / best["kernel"],
        worst,
        proved,
    )


def bare_passes(item: Measured, given: Arguments) -> Callable[[], object]:
    """The block function of a kernel, run on one block as often as a million points need."""
    parts = [np.atleast_1d(each)[:BLOCK] for each in given]
    outputs = [np.empty(BLOCK) for _ in item.kernel.outputs]
    work = [np.empty(BLOCK) for _ in range(item.signature.work)]

    def call() -> None:
        for _ in range(SIZE // BLOCK):
            item.signature.block(parts, outputs, work, False)

    return call


def lambdified(item: Measured) -> Callable[..., Any]:
    """SymPy's own printer on the textbook form, with common subexpressions shared."""
    assert item.textbook is not None
    free = {symbol for value in item.textbook.values() for symbol in value.free_symbols}
    if len(item.kernel.inputs) > 1:
        named = {str(symbol): symbol for symbol in free}
        arguments = [named[given.name] for given in item.kernel.inputs]
    else:
        arguments = list(free)
    function: Callable[..., Any] = sp.lambdify(
        arguments, list(item.textbook.values()), modules="numpy", cse=True
    )
    return function


def worst_error(item: Measured) -> tuple[float, float]:
    """The greatest error met, and the proved bound of the output where it was met."""
    generator = np.random.default_rng(21)
    worst, proved = 0.0, 0.0
    names = [given.name for given in item.kernel.inputs]
    for number, output in enumerate(item.kernel.outputs):
        bound = item.bound.outputs[number]
        columns = []
        for given, (low, high) in zip(item.kernel.inputs, bound.domain, strict=True):
            if given.signed:
                columns.append(signed_points(high, ERROR_POINTS, generator))
                continue
            lowest = max(low, 1.0) if given.integer else low
            points = log_uniform(lowest, high, ERROR_POINTS, generator)
            columns.append([float(round(x)) for x in points] if given.integer else points)
        columns = [x.tolist() for x in fitting(item.signature, list(map(np.array, columns)))]
        values = item.function(*(np.array(column) for column in columns))[number]
        for place, value in zip(zip(*columns, strict=True), values, strict=True):
            point = dict(zip(names, place, strict=True))
            exact = ball_outputs(item.kernel.graph, point)
            scale = exact[output.relative_to or output.name]
            if output.by_terms:
                scale = terms(item.kernel.graph, point)[output.name]
            found = error(float(value), exact[output.name], scale, EPSILON)
            if found > worst:
                worst, proved = found, float(bound.bound)
    return worst, proved
