"""The printed module of alpha-beta filters: kernels, what they are called and say."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.fixed_gain.names import MEANINGS
from gainproof.derive.fixed_gain.two_kernels import (
    DISCRIMINANT,
    HALF_SUM,
    SCALE,
    difference,
)
from gainproof.derive.fixed_gain.two_noise_kernels import AFTER as NOISE_AFTER
from gainproof.derive.fixed_gain.two_noise_kernels import AHEAD as NOISE_AHEAD
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
SUMMARIES = {
    "coordinates": "How far gains are inside the region of stability.",
    "gains_of_coordinates": "Gains of any stable alpha-beta filter from its coordinates.",
    "variances": "Covariances under measurement noise alone, from the gains.",
    "variances_of_coordinates": "Covariances under measurement noise alone, any stable filter.",
    "process_noise_variances": "What each entry of a process noise adds to covariances.",
    "process_noise_variances_of_coordinates": "The same of the prediction, any stable filter.",
    "lags": "Steady errors behind a constant acceleration a, over a T^2 (positions) and a T.",
    "closed_loop_poles": "Closed-loop poles, half_sum +- sqrt(quarter_discriminant).",
    "minimum_variance_by_lag": "The stable filter of least position variance at a lag (MV).",
    "minimum_smoothed_variance_by_lag": "The stable filter of least smoothed variance (NP-S).",
    "random_acceleration_by_lag": "The random acceleration filter (RA) of a lag.",
    "random_velocity_by_lag": "The random velocity filter (RV) of a lag, where it is stable.",
    "minimum_variance_by_gain": "Both minimum variance filters (MV) of one position gain.",
    "minimum_smoothed_variance_by_gain": "The filter of least smoothed variance (NP-S) of a "
    "position gain.",
    "random_acceleration_by_gain": "The stable random acceleration filter (RA) of a position gain.",
    "random_velocity_by_gain": "The random velocity filter (RV) of a position gain.",
}
MARGIN_TEXT = "margin = 4 - 2 alpha - beta, stable where alpha, beta and margin are positive"
EQUATIONS: Mapping[str, tuple[str, ...]] = {
    "coordinates": (
        MARGIN_TEXT,
        "linear_coefficient = 2 alpha/beta, quadratic_coefficient = margin/beta",
    ),
    "gains_of_coordinates": (
        "alpha = 2 x/(1 + x + y), beta = 4/(1 + x + y), all x > 0 and y > 0 are stable",
    ),
    "variances": (
        "predicted_11 = (2 alpha^2 + 2 beta + alpha beta)/(alpha margin),",
        "predicted_12 = beta (2 alpha + beta)/(alpha margin),",
        "predicted_22 = updated_22 = 2 beta^2/(alpha margin),",
        "updated_11 = (2 alpha^2 - 3 alpha beta + 2 beta)/(alpha margin),",
        "updated_12 = beta (2 alpha - beta)/(alpha margin), margin = 4 - 2 alpha - beta",
    ),
    "variances_of_coordinates": (
        "predicted_11 = ((1 + x)^2 + y)/(x y), predicted_12 = 2 (1 + x)/(x y),",
        "predicted_22 = updated_22 = 4/(x y),",
        "updated_11 = ((x - 1)^2 + y)/(x y), updated_12 = 2 (x - 1)/(x y)",
    ),
    "process_noise_variances": NOISE_AFTER,
    "process_noise_variances_of_coordinates": NOISE_AHEAD,
    "lags": (
        "predicted_position_lag = 1/beta, predicted_velocity_lag = alpha/beta + 1/2,",
        "updated_position_lag = (1 - alpha)/beta, updated_velocity_lag = alpha/beta - 1/2;",
        "none behind rest and constant velocity; behind a jerk j the position error grows by",
        "j T^3/beta a sample",
    ),
    "closed_loop_poles": (
        "half_sum = 1 - (alpha + beta)/2, modulus = sqrt(1 - alpha) (of a complex pair),",
        "quarter_discriminant = (alpha + beta)^2/4 - beta",
    ),
    "minimum_variance_by_lag": (
        "alpha + beta/2 = sqrt(beta), beta = 1/lag; with x = 2 sqrt(lag) - 1:",
        "minimum_variance_predicted_11 = (1 + 1/x)^2 - 1",
    ),
    "minimum_smoothed_variance_by_lag": (
        "2 sqrt(beta) (1 - alpha) = 2 alpha - beta, beta = 1/lag; with n = 2 sqrt(lag):",
        "minimum_smoothed_variance_updated_11 = (2 n + 3)/(n + 1)^2,",
        "minimum_smoothed_variance_predicted_11 = (2 n^3 + 7 n^2 + 8 n + 2)/((n + 1)^2 (n^2 - 2));",
        "at a lag of 1/2 and below none smooths better than a single measurement",
    ),
    "random_acceleration_by_lag": (
        "(alpha + beta/2)^2 = 2 beta, beta = 1/lag; with x = sqrt(8 lag) - 1:",
        "random_acceleration_predicted_11 = (3 x + 1)/(x (x - 1))",
    ),
    "random_velocity_by_lag": (
        "alpha (alpha + beta) = 2 beta, beta = 1/lag; with x = sqrt(8 lag + 1) - 1:",
        "random_velocity_predicted_11 = ((1 + x)^2 + y)/(x y), y = (x^2 - 2)/2",
    ),
    "minimum_variance_by_gain": (
        "(alpha + beta/2)^2 = beta: beta = (1 - m)^2 (slow), (1 + m)^2 (fast),",
        "m = sqrt(1 - 2 alpha)",
    ),
    "minimum_smoothed_variance_by_gain": (
        "beta = (2 alpha/(1 - alpha + v))^2, v = sqrt(1 + alpha^2), and with u = alpha/(1 + v):",
        "minimum_smoothed_variance_updated_11 = u (2 + u)",
    ),
    "random_acceleration_by_gain": (
        "(alpha + beta/2)^2 = 2 beta: beta = 2 (1 - w)^2, w = sqrt(1 - alpha)",
    ),
    "random_velocity_by_gain": ("alpha (alpha + beta) = 2 beta: beta = alpha^2/(2 - alpha)",),
}


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
