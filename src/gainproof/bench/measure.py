"""One kernel's figures: time over that of C, of lambdify and of SciPy, and its worst error."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from gainproof.bench.accuracy import ball_outputs, error, log_uniform
from gainproof.bench.compiler import compiled, compiler
from gainproof.bench.subjects import Measured
from gainproof.bench.timing import best_times
from gainproof.derive.printer.c_source import c_source

SIZE = 1_000_000
SOLVER_POINTS = 40
ERROR_POINTS = 400
EPSILON = 2.0**-52
BLOCK = 16384


@dataclass(frozen=True)
class Figures:
    """Ratios of one kernel; None where there is nothing to compare with.

    over_c: kernel time over C time. passes_over_c: the same for the bare NumPy calls on one block
    that stays in the cache, without guards and memory traffic: what no NumPy kernel of this graph
    can beat. under_lambdify, under_solver: the other's time over the
    kernel's. worst: the greatest measured error of any output in units of 2^-52, with `proved`
    the proved bound of that output.
    """

    over_c: float | None
    passes_over_c: float | None
    under_lambdify: float | None
    under_solver: float | None
    worst: float
    proved: float


def figures(item: Measured, folder: Path) -> Figures:
    """Measure one kernel."""
    given = sample(item)
    outputs = [np.empty_like(given) for _ in item.kernel.outputs]
    calls: dict[str, Callable[[], object]] = {
        "kernel": lambda: item.function(given, out=tuple(outputs)),
        "passes": bare_passes(item, given),
    }
    if compiler() is not None:
        # a library of its own for each kernel: the loader knows libraries by their path
        place = folder / item.subject
        place.mkdir(exist_ok=True)
        loop = compiled(c_source(item.kernel), item.kernel.name, place)
        targets = [np.empty_like(given) for _ in item.kernel.outputs]
        calls["C"] = lambda: loop(given, targets)
    if item.textbook is not None:
        plain = lambdified(item)
        calls["lambdify"] = lambda: plain(given)
    with np.errstate(all="ignore"):  # textbook forms cancel, divide by zero and overflow
        best = best_times(calls)
    solver = solver_seconds(item)
    worst, proved = worst_error(item)
    return Figures(
        best["kernel"] / best["C"] if "C" in best else None,
        best["passes"] / best["C"] if "C" in best else None,
        best["lambdify"] / best["kernel"] if "lambdify" in best else None,
        None if solver is None else solver * SIZE / best["kernel"],
        worst,
        proved,
    )


def sample(item: Measured) -> NDArray[np.float64]:
    """A million arguments inside the domain: indices from 1e-6 to 1e6, gains, sample numbers."""
    generator = np.random.default_rng(20)
    low, high = item.bound.lowest, item.bound.highest
    if item.kernel.inputs[0].integer:
        return np.asarray(generator.integers(int(max(low, 3)), 10**6, SIZE), np.float64)
    if high > 10:
        return 10.0 ** generator.uniform(-6, 6, SIZE)
    return generator.uniform(0.001 * high, 0.999 * high, SIZE)


def bare_passes(item: Measured, given: NDArray[np.float64]) -> Callable[[], object]:
    """The block function of a kernel, run on one block as often as a million points need."""
    part = given[:BLOCK]
    outputs = [np.empty_like(part) for _ in item.kernel.outputs]
    work = [np.empty_like(part) for _ in range(item.signature.work)]

    def call() -> None:
        for _ in range(SIZE // BLOCK):
            item.signature.block([part], outputs, work, False)

    return call


def lambdified(item: Measured) -> Callable[[NDArray[np.float64]], Any]:
    """SymPy's own printer on the textbook form, with common subexpressions shared."""
    assert item.textbook is not None
    (argument,) = {symbol for value in item.textbook.values() for symbol in value.free_symbols}
    function: Callable[[NDArray[np.float64]], Any] = sp.lambdify(
        argument, list(item.textbook.values()), modules="numpy", cse=True
    )
    return function


def solver_seconds(item: Measured) -> float | None:
    """SciPy's Riccati solver, seconds a point; None without SciPy or without a model."""
    if item.model is None or item.kernel.inputs[0].name != "tracking_index":
        return None
    try:
        from scipy.linalg import solve_discrete_are
    except ImportError:
        return None
    matrices = {
        key: np.array([[float(sp.Rational(entry)) for entry in row] for row in item.model[key]])
        for key in ("transition", "process_noise", "measurement", "measurement_noise")
    }
    start = perf_counter()
    for index in np.geomspace(0.01, 100, SOLVER_POINTS):
        solve_discrete_are(
            matrices["transition"].T,
            matrices["measurement"].T,
            index**2 * matrices["process_noise"],
            matrices["measurement_noise"],
        )
    return (perf_counter() - start) / SOLVER_POINTS


def worst_error(item: Measured) -> tuple[float, float]:
    """The greatest error met, and the proved bound of the output where it was met."""
    generator = np.random.default_rng(21)
    worst, proved = 0.0, 0.0
    for number, output in enumerate(item.kernel.outputs):
        bound = item.bound.outputs[number]
        whole = item.kernel.inputs[0].integer
        lowest = max(bound.lowest, 1.0) if whole else bound.lowest
        points = log_uniform(lowest, bound.highest, ERROR_POINTS, generator)
        if whole:
            points = [float(round(point)) for point in points]
        values = item.function(np.array(points))[number]
        for point, value in zip(points, values, strict=True):
            exact = ball_outputs(item.kernel.graph, point)
            scale = exact[output.relative_to or output.name]
            found = error(float(value), exact[output.name], scale, EPSILON)
            if found > worst:
                worst, proved = found, float(bound.bound)
    return worst, proved
