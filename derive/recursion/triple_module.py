"""The printed module of three states: what each kernel is called and says of itself."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed
from gainproof.derive.recursion.triple_names import PARAMETERS
from gainproof.derive.recursion.triple_noise import TripleNoise

VARIANCE = ("1e-30", "1e30", ("1e-4", "1e5"))
SHEAR = ("1e-15", "1e15", ("1e-3", "1e3"))
TIME = ("1e-10", "1e10", ("1e-2", "1e2"))
STRENGTH = ("1e-30", "1e30", ("1e-4", "1e4"))

MEANINGS = {
    "diagonal_1": "d1, variance of the position, velocity and acceleration known, m^2",
    "diagonal_2": "d2, variance of the velocity, acceleration known, m^2/s^2",
    "diagonal_3": "d3, variance of the acceleration, m^2/s^4",
    "first_shear": "a, s",
    "second_shear": "b, s",
    "third_shear": "c, s",
    "position_gain": "gain of the position, dimensionless",
    "velocity_gain": "gain of the velocity, 1/s",
    "acceleration_gain": "gain of the acceleration, 1/s^2",
    "innovation_variance": "variance of the innovation, m^2",
    "covariance_11": "variance of the position, m^2",
    "covariance_12": "covariance of position and velocity, m^2/s",
    "covariance_13": "covariance of position and acceleration, m^2/s^2",
    "covariance_22": "variance of the velocity, m^2/s^2",
    "covariance_23": "covariance of velocity and acceleration, m^2/s^3",
    "covariance_33": "variance of the acceleration, m^2/s^4",
}
SUMMARIES = {
    "covariance": "Covariance of position, velocity and acceleration from its factors.",
    "gains": "Kalman gain and variance of the innovation, before the position is measured.",
    "update": "Factors of the covariance after the position is measured.",
}
PLAIN = (
    "P = U diag(d1, d2, d3) U', U = [1, a + c, a b; 0, 1, b; 0, 0, 1]",
    "  = [1, a, 0; 0, 1, 0; 0, 0, 1] [1, 0, 0; 0, 1, b; 0, 0, 1] [1, c, 0; 0, 1, 0; 0, 0, 1]",
)
EQUATIONS = {
    "covariance": PLAIN,
    "gains": ("P H'/S, S = innovation_variance = H P H' + r, H = [1, 0, 0],", *PLAIN),
    "update": (
        "P - P H' H P/(H P H' + r) = U D U' with the factors that come, H = [1, 0, 0],",
        *PLAIN,
    ),
}
PREDICTION = (
    "F P F' + Q = U D U' with the factors that come, F = [1, t, t^2/2; 0, 1, t; 0, 0, 1],",
)
START = (
    "r W W' + A Q(t) A' + B Q(s) B' = U D U' with the factors that come; the state is",
    "W (z2, z1, z0)', the parabola through three positions, the newest first,",
    "W = [1, 0, 0; 1, -t, t^2/2; 1, -(s + t), (s + t)^2/2]^-1,",
    "A = W [0, 0, 0; 1, -t, t^2/2; 1, -(s + t), (s + t)^2/2],",
    "B = W [0, 0, 0; 0, 0, 0; 1, -s, s^2/2],",
)


def kernel_module(
    name: str, title: str, noises: tuple[TripleNoise, ...], graphs: Mapping[str, Graph]
) -> Module:
    """The module of the recursion."""
    kernels = (_kernel(name, kernel, graph, noises) for kernel, graph in graphs.items())
    return catalogue_module(name, title, kernels)


def _kernel(name: str, kernel: str, graph: Graph, noises: tuple[TripleNoise, ...]) -> Kernel:
    noise = next((each for each in noises if kernel.endswith(each.name)), None)
    symbols = symbols_of(graph)
    if noise is None:
        summary, equations = SUMMARIES[kernel], EQUATIONS[kernel]
    else:
        summary, equations = _of_noise(kernel, noise)
    results = {"covariance": "Covariance", "gains": "Gains", "update": "Update"}
    return Kernel(
        name=kernel,
        result=results.get(kernel, "".join(word.capitalize() for word in kernel.split("_"))),
        summary=summary,
        equations=equations,
        inputs=tuple(_input(kernel, entry, noise) for entry in PARAMETERS if entry in symbols),
        outputs=tuple(Output(entry, MEANINGS[entry]) for entry in graph["outputs"]),
        graph=graph,
        source=f"derivation {name}",
    )


def _of_noise(kernel: str, noise: TripleNoise) -> tuple[str, tuple[str, ...]]:
    """Summary and equations of a kernel with process noise."""
    title = noise.name.replace("_", " ")
    covariance = _covariance(noise)
    if kernel.startswith("start"):
        summary = f"Factors of the covariance after the first three positions, {title}."
        return summary, (*START, *(line.replace("Q =", "Q(t) =") for line in covariance), *PLAIN)
    summary = f"Factors of the covariance after an interval, {title}."
    return summary, (*PREDICTION, *covariance, *PLAIN)


def _covariance(noise: TripleNoise) -> tuple[str, ...]:
    """Q as its docstring says it."""
    rows = [
        ", ".join(str(entry).replace("**", "^").replace("*", " ") for entry in row)
        for row in noise.covariance.tolist()
    ]
    return (f"Q = [{'; '.join(rows)}],",)


def _input(kernel: str, entry: str, noise: TripleNoise | None) -> Input:
    if entry.endswith("shear"):
        return closed(entry, MEANINGS[entry], *SHEAR, zero=True)
    if entry == "first_interval":
        return closed(entry, "s, time between the first two positions, s", *TIME)
    if entry == "interval" and kernel.startswith("start"):
        return closed(entry, "t, time between the last two positions, s", *TIME)
    if entry == "interval":
        return closed(entry, "t, time since the covariance given, s", *TIME)
    if entry == "strength":
        assert noise is not None
        return closed(entry, f"q, {noise.meaning}", *STRENGTH, zero=True)
    if entry == "measurement_variance":
        return closed(entry, "r, variance of the measured position, m^2", *VARIANCE)
    return closed(entry, MEANINGS[entry], *VARIANCE)
