"""The programs of the kernels of alpha-beta filters: what each computes, in which tower."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.derivation import Step, kernel_step
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain import two_kernels as region
from gainproof.derive.fixed_gain import two_named_kernels as named
from gainproof.derive.fixed_gain.loop import Loop
from gainproof.derive.fixed_gain.two_kernels import DISCRIMINANT, HALF_SUM, SCALE
from gainproof.derive.fixed_gain.two_noise_kernels import (
    noise_meanings,
    noise_variances,
    noise_variances_of_coordinates,
)
from gainproof.derive.printer.graph import Graph

LOOP, E = Loop(2), real("e")
ALPHA, BETA = LOOP.gains
MARGIN = 4 - 2 * ALPHA - BETA
TOWERS = {
    "closed_loop_poles": "poles",
    "minimum_variance_by_lag": "minimum_variance",
    "random_acceleration_by_lag": "stable_acceleration",
    "random_velocity_by_lag": "stable_velocity",
    "minimum_variance_by_gain": "two_minima",
    "minimum_smoothed_variance_by_lag": "smoothed_slow",
    "minimum_smoothed_variance_by_gain": "smoothed_slow",
    "random_acceleration_by_gain": "stable_acceleration",
    "random_velocity_by_gain": "stable_velocity",
}
SYMBOLS = {"linear_coefficient": "x", "quadratic_coefficient": "y"}


def graphs() -> dict[str, Graph]:
    """The graph of each kernel."""
    return {
        "coordinates": region.coordinates(),
        "gains_of_coordinates": region.gains(),
        "variances": region.variances(),
        "variances_of_coordinates": region.region_variances(),
        "process_noise_variances": noise_variances(),
        "process_noise_variances_of_coordinates": noise_variances_of_coordinates(),
        "lags": region.lags(),
        "closed_loop_poles": region.poles(),
        "minimum_variance_by_lag": named.minimum_variance_by_lag(),
        "minimum_smoothed_variance_by_lag": named.minimum_smoothed_variance_by_lag(),
        "random_acceleration_by_lag": named.random_acceleration_by_lag(),
        "random_velocity_by_lag": named.random_velocity_by_lag(),
        "minimum_variance_by_gain": named.minimum_variance_by_gain(),
        "minimum_smoothed_variance_by_gain": named.minimum_smoothed_variance_by_gain(),
        "random_acceleration_by_gain": named.random_acceleration_by_gain(),
        "random_velocity_by_gain": named.random_velocity_by_gain(),
    }


def kernel_steps(made: Mapping[str, Graph]) -> list[Step]:
    """The kernels compute what they say."""
    noises = noise_meanings(LOOP)
    return [
        kernel_step(
            name, graph, _meant(graph, noises), TOWERS.get(name, "main"), roots=_roots(name)
        )
        for name, graph in made.items()
    ]


def _roots(name: str) -> dict[str, sp.Expr]:
    x, g = real("x"), real("g")
    return {
        "closed_loop_poles": {"modulus": real("modulus")},
        "minimum_variance_by_lag": {"root": (1 + x) / 2},
        "random_acceleration_by_lag": {"root": 2 + E},
        "random_velocity_by_lag": {"root": g + 1, "two": real("root_two")},
        "minimum_variance_by_gain": {"root": E / (2 + E)},
        "minimum_smoothed_variance_by_lag": {"root": real("n") / 2},
        "minimum_smoothed_variance_by_gain": {"root": real("rest")},
        "random_acceleration_by_gain": {"root": E / (2 + E)},
    }.get(name, {})


def _meant(graph: Graph, noises: Mapping[str, sp.Expr]) -> dict[str, sp.Expr]:
    """What each output stands for, over the names of its tower."""
    half = (ALPHA + BETA) / 2
    known: dict[str, sp.Expr] = {
        **noises,
        "margin": MARGIN,
        "linear_coefficient": real("x"),
        "quadratic_coefficient": real("y"),
        "predicted_position_lag": 1 / BETA,
        "predicted_velocity_lag": (2 * ALPHA + BETA) / (2 * BETA),
        "updated_position_lag": (1 - ALPHA) / BETA,
        "updated_velocity_lag": (2 * ALPHA - BETA) / (2 * BETA),
        HALF_SUM: 1 - half,
        HALF_SUM + SCALE: 1 + half,
        DISCRIMINANT: half**2 - BETA,
        DISCRIMINANT + SCALE: half**2 + BETA,
        "slow_minimum_variance_beta": real("slow_beta"),
        "slow_minimum_variance_predicted_11": real("slow_variance"),
        "fast_minimum_variance_beta": real("fast_beta"),
        "fast_minimum_variance_predicted_11": real("fast_variance"),
    }

    def meaning(output: str) -> sp.Expr:
        for prefix in (
            "minimum_variance_",
            "minimum_smoothed_variance_",
            "random_acceleration_",
            "random_velocity_",
        ):
            if output.startswith(prefix):
                return real(output.removeprefix(prefix))
        return known.get(output, real(output))

    return {output: meaning(output) for output in graph["outputs"]}
