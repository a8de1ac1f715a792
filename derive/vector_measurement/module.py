"""The printed module of a family: what each kernel is called and says of itself."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

import sympy

from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output
from gainproof.derive.vector_measurement import forms
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.kernels import FormsOf

STEADY_KERNELS: Mapping[str, tuple[FormsOf, ...]] = {
    "gains": (forms.gains,),
    "predicted_covariance": (forms.predicted_covariance,),
    "updated_covariance": (forms.updated_covariance,),
}

SUMMARIES = {
    "gains": "Steady-state filter gain, position and velocity measured.",
    "predicted_covariance": "Predicted covariance in units of sigma_o^2 and T.",
    "updated_covariance": "Updated covariance in units of sigma_o^2 and T.",
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


def kernel_module(c: Context, graphs: Mapping[str, Graph]) -> Module:
    """The module of a family."""
    return Module(
        name=c.model.name.replace("-", "_"),
        title=f"{c.model.title}: steady state.",
        command=f"gainproof generate {c.model.name}",
        derivation=f"gainproof derive {c.model.name}, SymPy {sympy.__version__}",
        kernels=tuple(_kernel(c, name, graph) for name, graph in graphs.items()),
        results="_position_velocity_results",
    )


def _kernel(c: Context, name: str, graph: Graph) -> Kernel:
    return Kernel(
        name=name,
        result="".join(word.capitalize() for word in name.split("_")),
        summary=SUMMARIES[name],
        equations=_equations(c, name),
        inputs=inputs(c),
        outputs=tuple(Output(output, MEANINGS[output]) for output in graph["outputs"]),
        graph=graph,
        source=f"derivation {c.model.name}",
    )


def inputs(c: Context) -> tuple[Input, Input]:
    """Both dimensionless parameters, as they follow from the model's quantities.

    Everything is normal in float32 too on this domain. Without noise in the position the updated
    cross covariance falls like S^4/Lambda^2, which ends the domain earlier.
    """
    (ratio,) = c.model.ratios.values()
    largest, least = (10**8, 8) if c.noise.interval else (4 * 10**6, 6)
    return (
        _closed("tracking_index", f"Lambda, with Lambda^2 = {c.model.noise_ratio}", 8, largest),
        _closed("velocity_ratio", f"S = {ratio}", least, 10**8),
    )


def _closed(name: str, meaning: str, decades: int, largest: int) -> Input:
    """From 10^-decades to the largest, both admitted."""
    lower = Fraction(1, 10**decades)
    return Input(name, meaning, lower, largest, lower_open=False, upper_open=False)


def _equations(c: Context, name: str) -> tuple[str, ...]:
    e, d, n = c.noise.e, c.noise.determinant, c.noise.n
    own = {
        "gains": "gain_11 = U11, gain_12 = U12/S^2, gain_21 = U12, gain_22 = U22/S^2,",
        "predicted_covariance": (
            "predicted_11 = (g + sigma s)/delta, predicted_12 = h sigma, "
            f"predicted_22 = delta h + {_product(1 - n)},"
        ),
        "updated_covariance": "updated_11 = U11, updated_12 = U12, updated_22 = U22,",
    }
    first = f" + {_product(c.noise.first)}" if c.noise.first else ""
    level = f"w^2 = 1 + {d} t^2" if d else "w = 1"
    if c.noise.interval:
        near = f"(16 + {_product(e)})" if e else "16"
        eta, share = f"{near} (1 + t^2/4)", "eta/(4 + t^2)"
    else:
        eta, share = "16 + Lambda^2 + 4 t^2", "sigma"
    rate = "U22 = (S^2 g + Lambda^2/sigma)/delta" if n else "U22 = delta h"
    return (
        own[name],
        f"U11 = (g + s/sigma)/delta, U12 = h/sigma, {rate}, s = 2 U12 + U22{first},",
        f"h = Lambda/(w + kappa), g = Lambda w - h, kappa = t {share}/S, t = Lambda/S,",
        "sigma = (m + delta)/2, m = sigma + 1/sigma = (Lambda w + eta)/2, delta = sigma - 1/sigma,",
        f"{level}, eta^2 = {eta}; all computed without a subtraction",
    )


def _product(number: Fraction) -> str:
    """A number times Lambda^2."""
    return "Lambda^2" if number == 1 else f"Lambda^2/{1 / number}"
