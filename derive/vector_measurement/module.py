"""The printed module of a family: what each kernel is called and says of itself."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed
from gainproof.derive.vector_measurement import forms
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.derivative_kernels import DERIVATIVES, derivative_graph
from gainproof.derive.vector_measurement.derivative_module import derivative_kernel, is_derivative
from gainproof.derive.vector_measurement.kernels import FormsOf, known_graph, steady_graph
from gainproof.derive.vector_measurement.names import in_words
from gainproof.derive.vector_measurement.pole_kernels import pole_graphs
from gainproof.derive.vector_measurement.pole_module import is_of_poles, pole_kernel
from gainproof.derive.vector_measurement.process_noise import Noise

STEADY_KERNELS: Mapping[str, tuple[FormsOf, ...]] = {
    "gains": (forms.gains,),
    "predicted_covariance": (forms.predicted_covariance,),
    "updated_covariance": (forms.updated_covariance,),
}

SUMMARIES = {
    "gains": "Steady-state filter gain, position and velocity measured.",
    "predicted_covariance": "Predicted covariance in units of sigma_o^2 and T.",
    "updated_covariance": "Updated covariance in units of sigma_o^2 and T.",
    "known_velocity": "The position's variances where the velocity is known exactly, S = 0.",
}

MEANINGS = {
    "gain_11": "position's gain on the measured position",
    "gain_12": "position's gain on the measured velocity over T",
    "gain_21": "velocity's gain on the measured position times T",
    "gain_22": "velocity's gain on the measured velocity",
    "predicted_11": "variance of the predicted position over sigma_o^2",
    "predicted_12": "covariance of predicted position and velocity times T/sigma_o^2",
    "predicted_22": "variance of the predicted velocity times T^2/sigma_o^2",
    "updated_11": "variance of the updated position over sigma_o^2",
    "updated_12": "covariance of updated position and velocity times T/sigma_o^2",
    "updated_22": "variance of the updated velocity times T^2/sigma_o^2",
}


VALUES = {True: (("1e-8", "1e8"), ("1e-8", "1e8")), False: (("1e-8", "4e6"), ("1e-6", "1e8"))}
"""Domains in float32 of Lambda and S by whether the noise acts all through the interval.

Without noise in the position the updated cross covariance falls like S^4/Lambda^2, and is no normal
number of float32 beyond.
"""
KNOWN = "known_velocity"
SEARCH = 4
"""How many times the boxes of other kernels those of the gains may be: 0.1 s a format.

With the usual number the gain of the position has bounds of 28.34, 12.33 and 10.30 * 2^-52 where
noise is continuous, constant over each interval and in the velocity, with this 9.32, 8.03, 10.11.
"""


def graphs(noise: Noise) -> dict[str, Graph]:
    """The graphs of all kernels of a family by name."""
    found = {name: steady_graph(noise, *parts) for name, parts in STEADY_KERNELS.items()}
    found |= {name: derivative_graph(noise, name) for name in DERIVATIVES}
    if noise.first:
        found[KNOWN] = known_graph(noise)
    return {**found, **pole_graphs(noise)}


def kernel_module(c: Context, graphs: Mapping[str, Graph]) -> Module:
    """The module of a family."""
    kernels = (_kernel(c, name, graph) for name, graph in graphs.items())
    return catalogue_module(c.model.name, c.model.title, kernels)


def _kernel(c: Context, name: str, graph: Graph) -> Kernel:
    if is_of_poles(name):
        return pole_kernel(c, name, graph)
    if is_derivative(name):
        base, _, _ = name.partition("_by_")
        return derivative_kernel(c, name, graph, _equations(c, base), MEANINGS)
    return Kernel(
        name=name,
        result="".join(word.capitalize() for word in name.split("_")),
        summary=SUMMARIES[name],
        equations=_equations(c, name) if name != KNOWN else _known_equations(c),
        inputs=_inputs(c, name),
        outputs=tuple(Output(output, MEANINGS[output]) for output in graph["outputs"]),
        graph=graph,
        source=f"derivation {c.model.name}",
        search=SEARCH if name == "gains" else 1,
    )


def _inputs(c: Context, name: str) -> tuple[Input, ...]:
    """The dimensionless parameters, as they follow from the model's quantities."""
    (ratio,) = c.model.ratios.values()
    index = f"Lambda, with Lambda^2 = {in_words(c.model.noise_ratio)}"
    if name == KNOWN:
        return (closed("tracking_index", index, "1e-12", "1e12", ("1e-8", "1e8")),)
    single = VALUES[c.noise.interval]
    return (
        closed("tracking_index", index, "1e-12", "1e12", single[0]),
        closed("velocity_ratio", f"S = {in_words(ratio)}", "1e-12", "1e12", single[1]),
    )


def _equations(c: Context, name: str) -> tuple[str, ...]:
    e, d, n = c.noise.e, c.noise.determinant, c.noise.n
    own = {
        "gains": ("gain_11 = U11, gain_12 = U12/S^2, gain_21 = U12, gain_22 = U22/S^2,",),
        "predicted_covariance": (
            "predicted_11 = (g + sigma s)/delta, predicted_12 = h sigma,",
            f"predicted_22 = delta h + {_product(1 - n)},",
        ),
        "updated_covariance": ("updated_11 = U11, updated_12 = U12, updated_22 = U22,",),
    }
    first = f" + {_product(c.noise.first)}" if c.noise.first else ""
    rate = "U22 = (S^2 g + Lambda^2/sigma)/delta" if n else "U22 = delta h"
    position = (
        ("U11 = (g/sigma + U12 U12/S^2)/(U22/S^2),", f"U12 = h/sigma, {rate},")
        if name == "gains"
        else (
            f"U11 = (g + s/sigma)/delta, U12 = h/sigma, {rate},",
            f"s = 2 U12 + U22{first},",
        )
    )
    level = f"w^2 = 1 + {d} t^2" if d else "w = 1"
    if c.noise.interval:
        near = f"(16 + {_product(e)})" if e else "16"
        eta, share = f"{near} (1 + t^2/4)", "eta/(4 + t^2)"
    else:
        eta, share = "16 + Lambda^2 + 4 t^2", "sigma"
    return (
        *own[name],
        *position,
        f"h = Lambda/(w + kappa), g = Lambda w - h, kappa = t {share}/S, t = Lambda/S,",
        "sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,",
        f"{level}, eta^2 = {eta};",
        "all computed without a subtraction",
    )


def _known_equations(c: Context) -> tuple[str, ...]:
    if not c.noise.determinant:
        own = _product(c.noise.first)
        return (f"predicted_11 = {own}, the limit for S -> 0; that of the updated variance is 0",)
    far = 16 / c.noise.e
    return (
        f"updated_11 = 2 Lambda/(Lambda + sqrt(Lambda^2 + {far})),",
        f"predicted_11 = updated_11 + {_product(c.noise.first)}: the limits for S -> 0",
    )


def _product(number: Fraction) -> str:
    """A number times Lambda^2."""
    return "Lambda^2" if number == 1 else f"Lambda^2/{1 / number}"
