"""The printed module of a family: what each kernel is called and says of itself."""

from __future__ import annotations

from collections.abc import Mapping

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
    """Both dimensionless parameters, as they follow from the model's quantities."""
    (ratio,) = c.model.ratios.values()
    return (
        Input("tracking_index", f"Lambda, with Lambda^2 = {c.model.noise_ratio}"),
        Input("velocity_ratio", f"S = {ratio}"),
    )


def _equations(c: Context, name: str) -> tuple[str, ...]:
    d, e, n = c.noise.determinant, c.noise.e, c.noise.n
    first = f"{c.noise.first} Lambda^2" if c.noise.first else "0"
    own = {
        "gains": ("gain_11 = U11, gain_12 = U12/S^2, gain_21 = U12, gain_22 = U22/S^2,",),
        "predicted_covariance": (
            "predicted_11 = P11 = (g + sigma s)/delta, predicted_12 = h sigma,",
            f"predicted_22 = delta h + {1 - n} Lambda^2,",
        ),
        "updated_covariance": (),
    }
    level = f"w^2 = 1 + {d} t^2, " if d else "w = 1, "
    if c.noise.interval:
        near = f"16 + {e} Lambda^2" if e else "16"
        eta, coupling = f"eta^2 = ({near}) (4 + t^2)/4", "kappa = t eta/((4 + t^2) S)"
    else:
        eta, coupling = "eta^2 = 16 + Lambda^2 + 4 t^2", "kappa = t sigma/S"
    return (
        *own[name],
        f"U11 = (g + s/sigma)/delta, U12 = h/sigma, U22 = delta h - {n} Lambda^2,",
        f"s = 2 U12 + U22 + {first}, t = Lambda/S, {level}{eta},",
        "m = (Lambda w + eta)/2 = sigma + 1/sigma, delta = sqrt(m^2 - 4) = sigma - 1/sigma,",
        f"{coupling}, h = Lambda/(w + kappa), g = Lambda w - h",
        "(each computed without a subtraction)",
    )
