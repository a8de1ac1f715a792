"""Steps on what the kernels compute."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import Relation, equal
from gainproof.derive.updated_gains.forms import drifts, excesses
from gainproof.derive.updated_gains.kernels import OVER
from gainproof.derive.updated_gains.names import (
    INDEX,
    NEXT_ALPHA_SLOPE,
    NEXT_BETA_SLOPE,
    E,
    N,
)
from gainproof.derive.updated_gains.steps_path import DRIFT_ALPHA, DRIFT_BETA
from gainproof.derive.updated_gains.towers import AXIS, BOUNDS, SIGHT, S, U, V

TOWERS = {"tracking_index": AXIS, "update_limits": BOUNDS, "line_of_sight_gains": SIGHT}
INPUTS = {
    "recursive_gains": {
        "alpha": "nominal_alpha",
        "beta": "nominal_beta",
        "next_index": "following_index",
    }
}
"""The gains so far are any: those of a third index stand for them (see `_meant`)."""


def kernel_steps(made: Mapping[str, Graph]) -> list[Step]:
    """Each kernel computes what it says."""
    return [
        Step(
            "sight-signs",
            "Cosine and sine of either sign.",
            equal(
                sp.ImmutableDenseMatrix([[real("cosine"), real("sine")]]),
                sp.ImmutableDenseMatrix(
                    [[real(f"more_{name}") - real(f"less_{name}") for name in ("cosine", "sine")]]
                ),
            ),
            "What the names mean.",
            tower=SIGHT,
            shown=False,
        ),
        *(_kernel(name, graph) for name, graph in made.items()),
    ]


SQUARED: tuple[str, ...] = ("alpha_excess", "beta_excess", "alpha_drift", "beta_drift")


def _kernel(name: str, graph: Graph) -> Step:
    roots = {
        "nominal_root": 1 + 2 / N,
        "root": 1 + 2 / E,
        "deviation": real("d"),
        "s": S,
        "u": U,
        "v": V,
    }
    named = graph.get("names", {})
    return Step(
        f"kernel-{name.replace('_', '-')}",
        f"The kernel {name} computes what it says.",
        Relation(
            "program",
            {"program": name, "outputs": {each: _meant(name, each) for each in graph["outputs"]}},
        ),
        "Evaluate the kernel's graph in the tower.",
        tower=TOWERS.get(name, "main"),
        hint={"graph": graph, "roots": {key: x for key, x in roots.items() if key in named}},
        shown=False,
    )


def _meant(kernel: str, output: str) -> sp.Expr:
    """What an output stands for in its tower."""
    along, across, cosine, sine = map(real, ("along", "across", "cosine", "sine"))
    step = real("following_index") - INDEX
    bound = real("nominal_index")
    square = (E - N) ** 2 / ((1 + E) * (1 + N) / (2 * (E + N + E * N))) ** 2
    known: dict[str, sp.Expr] = {
        "next_alpha": real("nominal_alpha") + NEXT_ALPHA_SLOPE * step,
        "next_beta": real("nominal_beta") + NEXT_BETA_SLOPE * step,
        "alpha_one_ratio": sp.Rational(3, 2) + 1 / N,
        "unstable_ratio": 2 + 2 / N,
        "variance_ratio": real("variance_ratio"),
        "alpha_gain_ratio": real("alpha_bound") / bound,
        "beta_gain_ratio": real("beta_bound") / bound,
        "alpha_drift": DRIFT_ALPHA,
        "beta_drift": DRIFT_BETA,
        "gain_xx": along * cosine**2 + across * sine**2,
        "gain_xy": (along - across) * cosine * sine,
        "gain_yy": along * sine**2 + across * cosine**2,
    }
    if kernel == "tracking_index":
        return real("axis_index")
    if kernel == "first_order_gains":
        return real(f"first_order_{output}")
    if kernel == "mismatch_variances":
        name = output.removesuffix("_ratio")
        held = real(f"held_{name}")
        return held / real(name) if output != name else held
    if output.endswith(OVER):
        values = dict(zip(SQUARED, (*excesses(N, E), *drifts(N, E)), strict=True))
        return values[output.removesuffix(OVER)] / square
    return known.get(output, real(output))
