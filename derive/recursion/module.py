"""The printed module of two states: what each kernel is called and says of itself."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed
from gainproof.derive.recursion.noise import Noise

VARIANCE = ("1e-40", "1e40", ("1e-7", "1e9"))
TIME = ("1e-20", "1e20", ("1e-4", "1e4"))
STRENGTH = ("1e-40", "1e40", ("1e-7", "1e6"))

MEANINGS = {
    "diagonal_1": "d1, variance of the position where the velocity is known, m^2",
    "shear": "u, covariance of position and velocity over the velocity's variance, s",
    "diagonal_2": "d2, variance of the velocity, m^2/s^2",
    "position_gain": "gain of the position, dimensionless",
    "velocity_gain": "gain of the velocity, 1/s",
    "innovation_variance": "variance of the innovation, m^2",
    "covariance_11": "variance of the position, m^2",
    "covariance_12": "covariance of position and velocity, m^2/s",
    "covariance_22": "variance of the velocity, m^2/s^2",
    "last_sample": "real k; its whole part is the last sample of the fit",
}

SUMMARIES = {
    "covariance": "Covariance of position and velocity from its factors d1, u, d2.",
    "gains": "Kalman gain and variance of the innovation, before the position is measured.",
    "update": "Factors of the covariance after the position is measured.",
    "hand_over": "The last sample at which the gain of a line fitted by least squares is not below "
    "alpha.",
}
RESULTS = {"covariance": "Covariance", "gains": "Gains", "update": "Factors"}
PLAIN = "P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]"


def kernel_module(
    name: str, title: str, noises: tuple[Noise, ...], graphs: Mapping[str, Graph]
) -> Module:
    """The module of the recursion."""
    kernels = (_kernel(name, kernel, graph, noises) for kernel, graph in graphs.items())
    return catalogue_module(name, title, kernels)


def _kernel(name: str, kernel: str, graph: Graph, noises: tuple[Noise, ...]) -> Kernel:
    noise = next((each for each in noises if kernel.endswith(each.name)), None)
    symbols = symbols_of(graph)
    return Kernel(
        name=kernel,
        result=RESULTS.get(kernel, "".join(word.capitalize() for word in kernel.split("_"))),
        summary=_summary(kernel, noise),
        equations=_equations(kernel, noise),
        inputs=tuple(_input(kernel, entry, noise) for entry in INPUTS if entry in symbols),
        outputs=tuple(Output(entry, MEANINGS[entry]) for entry in graph["outputs"]),
        graph=graph,
        source=f"derivation {name}",
    )


INPUTS = (
    "diagonal_1",
    "shear",
    "diagonal_2",
    "interval",
    "strength",
    "measurement_variance",
    "alpha",
)
"""The order of arguments."""


def _input(kernel: str, entry: str, noise: Noise | None) -> Input:
    match entry:
        case "shear":
            return closed(entry, MEANINGS[entry], *TIME, zero=True)
        case "interval" if kernel.startswith("start"):
            return closed(entry, "t, time between the two positions, s", *TIME)
        case "interval":
            return closed(entry, "t, time since the covariance given, s", *TIME, zero=True)
        case "strength":
            assert noise is not None
            return closed(entry, f"q, {noise.meaning}", *STRENGTH, zero=True)
        case "measurement_variance":
            return closed(entry, "r, variance of the measured position, m^2", *VARIANCE)
        case "alpha":
            return Input(entry, "steady-state position gain", "0", "1")
    return closed(entry, MEANINGS[entry], *VARIANCE)


def _summary(kernel: str, noise: Noise | None) -> str:
    if noise is None:
        return SUMMARIES[kernel]
    title = noise.name.replace("_", " ")
    if kernel.startswith("start"):
        return f"Factors of the covariance after the first two positions, {title}."
    if kernel.startswith("predict"):
        return f"Factors of the covariance after an interval, {title}."
    return f"An interval, then a measured position: factors and gains, {title}."


def _equations(kernel: str, noise: Noise | None) -> tuple[str, ...]:
    update = (
        "diagonal_1 = d1 r/(d1 + r), shear = u r/(d1 + r), diagonal_2 = d2 (d1 + r)/S,",
        "position_gain = (d1 + u^2 d2)/S, velocity_gain = u d2/S,",
        "S = innovation_variance = d1 + u^2 d2 + r,",
    )
    match kernel:
        case "covariance":
            return (PLAIN,)
        case "gains":
            return (*update[1:], PLAIN)
        case "update":
            return (update[0], "S = d1 + u^2 d2 + r,", PLAIN)
        case "hand_over":
            return (
                "last_sample = (4 - 3 alpha + sqrt(16 - 16 alpha + alpha^2))/(2 alpha),",
                "where alpha = 2 (2 k + 1)/((k + 1) (k + 2))",
            )
    assert noise is not None
    if kernel.startswith("start"):
        return (
            "diagonal_1 = r (r/t^2 + c)/diagonal_2, shear = r/(t diagonal_2),",
            f"diagonal_2 = 2 r/t^2 + c, c = {_product(noise)},",
            PLAIN,
        )
    predict = (
        f"diagonal_1 = d1{_own(noise)} + (u + {'t/2' if noise.share else 't'})^2 d2 g/(d2 + g),",
        f"shear = ((u + t) d2{' + g t/2' if noise.share else ''})/(d2 + g), diagonal_2 = d2 + g,",
        f"g = {_gained(noise)},",
    )
    if kernel.startswith("predict"):
        return (*predict, PLAIN)
    return (*predict[:2], f"{predict[2]} then with these as d1, u, d2", *update, PLAIN)


def _own(noise: Noise) -> str:
    return f" + q t^3/{1 / noise.floor}" if noise.floor else ""


def _gained(noise: Noise) -> str:
    return ("q", "q t", "q t^2")[noise.power]


def _product(noise: Noise) -> str:
    return _gained(noise) if noise.chord == 1 else f"{_gained(noise)}/{1 / noise.chord}"
