"""The printed module of alpha-beta-gamma filters: kernels, what they say, what they compute."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.names import MEANINGS
from gainproof.derive.fixed_gain.three_kernels import graphs
from gainproof.derive.fixed_gain.three_steps_stability import (
    ALPHA,
    BETA,
    GAMMA,
    MARGIN,
)
from gainproof.derive.fixed_gain.two_kernels import SCALE, difference
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed
from gainproof.derive.relation import Relation

SCALES = {
    "updated_12": "updated_12" + SCALE,
    "updated_13": "updated_13" + SCALE,
    "updated_velocity_lag": "predicted_velocity_lag",
}
REASON = "changes its sign; error over the sum of its terms"
SUMMARIES = {
    "coordinates": "How far gains are inside the region of stability.",
    "gains_of_coordinates": "Gains of any stable alpha-beta-gamma filter from its coordinates.",
    "variances": "Covariances under measurement noise alone, from the gains.",
    "variances_of_coordinates": "Covariance of the prediction, any stable filter.",
    "lags": "Steady errors behind a constant jerk j, over j T^3 (positions), j T^2 and j T.",
    "minimum_variance_by_lag": "The stable filter of least position variance at a lag (MV).",
    "random_acceleration_by_gain": "The stable random acceleration filter (RA) of a position gain.",
}
SHARE = "gamma = 2 alpha beta share/(2 - alpha), margin = 4 - 2 alpha - beta,"
EQUATIONS: Mapping[str, tuple[str, ...]] = {
    "coordinates": (
        SHARE,
        "linear_coefficient = 2 beta/gamma, cubic_coefficient = 2 margin/gamma,",
        "hurwitz_determinant = 8 (alpha beta - gamma (1 - alpha/2))/gamma^2",
    ),
    "gains_of_coordinates": (
        "alpha = 2 (1 + y)/n, beta = 4 x/n, gamma = 8/n, n = 1 + x + y + d, y = (d + m)/x,",
        "all x > 0, d > 0 and m > 0 are stable",
    ),
    "variances": (
        SHARE,
        "g = 2 alpha beta - gamma (2 - alpha),",
        "predicted_11 = 8 beta^2/((2 - alpha) g margin) + alpha/(2 - alpha),",
        "predicted_12 = beta (2 alpha + beta) (2 beta + gamma)/(g margin),",
        "predicted_13 = gamma (2 g + beta (2 beta + gamma))/(g margin),",
        "predicted_22 = 2 (2 beta^2 (beta + gamma) + gamma^2 (2 - alpha))/(g margin),",
        "predicted_23 = 2 beta gamma (2 beta + gamma)/(g margin),",
        "predicted_33 = 4 beta gamma^2/(g margin), also after the update,",
        "updated_11 = (1 - alpha)^2 predicted_11 + alpha^2,",
        "updated_12 = beta (2 alpha - beta) (2 beta - gamma)/(g margin),",
        "updated_13 = gamma (2 g - beta (2 beta - gamma))/(g margin),",
        "updated_22 = (beta (2 beta - gamma)^2 + gamma^2 margin)/(g margin),",
        "updated_23 = 2 beta gamma (2 beta - gamma)/(g margin); updated_12_scale and",
        "updated_13_scale are updated_12 and updated_13 with plus between their terms",
    ),
    "variances_of_coordinates": (
        "predicted_11 = (1 + x + y + d) (x (1 + x) + m)/(d m) - 1, y = (d + m)/x,",
        "predicted_12 = 2 (1 + x) (x (1 + x) + d + m)/(d m),",
        "predicted_13 = 4 (x (1 + x) + m)/(d m),",
        "predicted_22 = 4 (d + x (1 + x)^2)/(d m), predicted_23 = 8 x (1 + x)/(d m),",
        "predicted_33 = 16 x/(d m)",
    ),
    "lags": (
        SHARE,
        "predicted_position_lag = 1/gamma, predicted_acceleration_lag = beta/gamma + 1/2,",
        "predicted_velocity_lag = (12 alpha + 6 beta + gamma)/(12 gamma),",
        "updated_position_lag = (1 - alpha)/gamma, updated_acceleration_lag = beta/gamma - 1/2,",
        "updated_velocity_lag = (12 alpha - 6 beta + gamma)/(12 gamma);",
        "none behind rest, constant velocity and constant acceleration",
    ),
    "minimum_variance_by_lag": (
        "with x = 2 lag^(1/3) - 1: alpha = 2 (2 x^2 + 2 x + 1)/(1 + x)^3, beta = 4 x/(1 + x)^3,",
        "gamma = 8/(1 + x)^3, minimum_variance_predicted_11 = (1 + 1/x)^3 - 1",
    ),
    "random_acceleration_by_gain": (
        "beta = 2 (1 - w)^2, gamma = beta^2/(2 alpha), w = sqrt(1 - alpha),",
        "random_acceleration_predicted_11 = alpha (4 + w)/(w (1 + 4 w + w^2))",
    ),
}
TOWERS = {
    "minimum_variance_by_lag": "minimum_variance",
    "random_acceleration_by_gain": "stable_acceleration",
}
SYMBOLS = {"linear_coefficient": "x", "cubic_coefficient": "d", "hurwitz_determinant": "m"}
OWN_MEANINGS = {
    "lag": "1/gamma, lag of the predicted position behind a constant jerk j over j T^3",
    "share": "gamma over its largest stable value 2 alpha beta/(2 - alpha)",
    "cubic_coefficient": "d, that of s^3",
    "hurwitz_determinant": "m = x y - d with y the coefficient of s^2",
}


def kernel_module(name: str, title: str, made: Mapping[str, Graph]) -> Module:
    """The module of alpha-beta-gamma filters."""
    return Module(
        name=name.replace("-", "_"),
        title=f"{title}.",
        command=f"gainproof generate {name}",
        derivation=f"gainproof derive {name}, SymPy {sp.__version__}",
        kernels=tuple(_kernel(name, kernel, graph) for kernel, graph in made.items()),
    )


def _kernel(name: str, kernel: str, graph: Graph) -> Kernel:
    symbols = [str(node[1]) for node in graph["nodes"] if node[0] == "symbol"]
    named = graph.get("names", {})
    meanings = {**MEANINGS, **OWN_MEANINGS}
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=SUMMARIES[kernel],
        equations=EQUATIONS[kernel],
        inputs=tuple(_input(kernel, symbol, meanings[symbol]) for symbol in symbols),
        outputs=tuple(
            Output(entry, meanings[entry], SCALES.get(entry))
            for entry in graph["outputs"]
            if not entry.endswith(SCALE)
        ),
        graph=graph,
        source=f"derivation {name}",
        cancellations={difference(x): REASON for x in SCALES if difference(x) in named},
    )


def _input(kernel: str, entry: str, meaning: str) -> Input:
    if entry == "lag":
        return Input(entry, meaning, "1/8", "1e30", True, False, single=("1/8", "1e9"))
    if kernel.endswith("_by_gain"):
        return Input(entry, meaning, "1e-15", "1", False, True, single=("1e-6", "1"))
    if entry in ("alpha", "share"):
        return closed(entry, meaning, "1e-20", "0.999999", ("1e-5", "0.99999"))
    if entry == "beta":
        return closed(entry, meaning, "1e-20", "1.9999999", ("1e-5", "1.99999"))
    return closed(entry, meaning, "1e-20", "1e20", ("1e-4", "1e4"))


def kernel_steps(made: Mapping[str, Graph]) -> list[Step]:
    """The kernels compute what they say."""
    e, cube = real("e"), real("cube")
    roots = {
        "minimum_variance_by_lag": {"root": cube, "root_of_map": cube**2},
        "random_acceleration_by_gain": {"root": e / (4 + e)},
    }
    return [
        Step(
            f"kernel-{name.replace('_', '-')}",
            f"The kernel {name} computes what it says.",
            Relation("program", {"program": name, "outputs": _meant(graph)}),
            "Evaluate the kernel's graph as a rational function.",
            tower=TOWERS.get(name, "main"),
            hint={"graph": graph, "roots": roots.get(name, {})},
            shown=False,
        )
        for name, graph in made.items()
    ]


def _meant(graph: Graph) -> dict[str, sp.Expr]:
    """What each output stands for, over the names of its tower."""
    g = 2 * ALPHA * BETA - GAMMA * (2 - ALPHA)
    gap, below = 2 * BETA - GAMMA, g * MARGIN
    known: dict[str, sp.Expr] = {
        "margin": MARGIN,
        **{name: real(symbol) for name, symbol in SYMBOLS.items()},
        "predicted_position_lag": 1 / GAMMA,
        "predicted_velocity_lag": (12 * ALPHA + 6 * BETA + GAMMA) / (12 * GAMMA),
        "predicted_acceleration_lag": (2 * BETA + GAMMA) / (2 * GAMMA),
        "updated_position_lag": (1 - ALPHA) / GAMMA,
        "updated_velocity_lag": (12 * ALPHA - 6 * BETA + GAMMA) / (12 * GAMMA),
        "updated_acceleration_lag": gap / (2 * GAMMA),
        "updated_12" + SCALE: BETA * (2 * ALPHA + BETA) * gap / below,
        "updated_13" + SCALE: GAMMA * (2 * g + BETA * gap) / below,
    }

    def meaning(output: str) -> sp.Expr:
        for prefix in ("minimum_variance_", "random_acceleration_"):
            if output.startswith(prefix):
                return real(output.removeprefix(prefix))
        return known.get(output, real(output))

    return {output: meaning(output) for output in graph["outputs"]}


__all__ = ["graphs", "kernel_module", "kernel_steps"]
