"""The printed module of alpha-beta filters: kernels, what they are called and say."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.fixed_gain.names import MEANINGS
from gainproof.derive.fixed_gain.two_kernel_words import EQUATIONS, SUMMARIES
from gainproof.derive.fixed_gain.two_kernels import (
    DISCRIMINANT,
    HALF_SUM,
    SCALE,
    difference,
)
from gainproof.derive.fixed_gain.two_noise_kernels import TURNING
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed

SCALES = {
    "updated_12": "predicted_12",
    "updated_velocity_lag": "predicted_velocity_lag",
    TURNING: TURNING + SCALE,
    HALF_SUM: HALF_SUM + SCALE,
    DISCRIMINANT: DISCRIMINANT + SCALE,
}
"""What the errors of outputs that change their sign are relative to."""
REASONS = {
    "updated_12": "changes its sign at beta = 2 alpha",
    "updated_velocity_lag": "changes its sign at beta = 2 alpha",
    TURNING: "changes its sign at beta = alpha (2 - alpha)",
    HALF_SUM: "changes its sign",
    DISCRIMINANT: "changes its sign where poles turn real",
}
LEAST_LAGS = {
    "minimum_variance": "1/4",
    "minimum_smoothed_variance": "1/2",
    "random_acceleration": "1/2",
    "random_velocity": "0.6036",  # stable from (1 + sqrt 2)/4 on, just below
}
LARGEST_LAG, SINGLE_LAG = "1e30", "1e9"


def kernel_module(name: str, title: str, made: Mapping[str, Graph]) -> Module:
    """The module of alpha-beta filters."""
    kernels = (_kernel(name, kernel, graph) for kernel, graph in made.items())
    return catalogue_module(name, title, kernels)


def _kernel(name: str, kernel: str, graph: Graph) -> Kernel:
    symbols = symbols_of(graph)
    named = graph.get("names", {})
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=SUMMARIES[kernel],
        equations=EQUATIONS[kernel],
        inputs=tuple(_input(kernel, symbol) for symbol in symbols),
        outputs=tuple(
            Output(entry, MEANINGS[entry], SCALES.get(entry))
            for entry in graph["outputs"]
            if not entry.endswith(SCALE)
        ),
        graph=graph,
        source=f"derivation {name}",
        cancellations={
            difference(entry): reason
            for entry, reason in REASONS.items()
            if difference(entry) in named
        },
    )


def _input(kernel: str, entry: str) -> Input:
    meaning = MEANINGS[entry]
    if kernel.endswith("_by_lag"):
        low = LEAST_LAGS[kernel.removesuffix("_by_lag")]
        return Input(entry, meaning, low, LARGEST_LAG, True, False, single=(low, SINGLE_LAG))
    if kernel.endswith("_by_gain"):
        most = "1/2" if kernel.startswith("minimum_variance") else "1"
        return Input(entry, meaning, "1e-15", most, False, True, single=("1e-9", most))
    if entry == "alpha":
        return closed(entry, meaning, "1e-30", "0.9999999", ("1e-12", "0.999999"))
    if entry == "beta":
        return closed(entry, meaning, "1e-30", "1.9999999", ("1e-12", "1.999999"))
    return closed(entry, meaning, "1e-60", "1e60", ("1e-9", "1e9"))
