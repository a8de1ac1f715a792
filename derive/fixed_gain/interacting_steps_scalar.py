"""Steps on one coordinate: the gain P/(P + B) of the lecture, its limits, and its kernel."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.relation import INFINITY, Relation, equal, limit, monotone, positive

SCALAR, RATIO = "scalar", "ratio"
KERNEL = "position_gain"
PREDICTED, MEASURED, GAIN = real("prior"), real("noise_variance"), real("scalar_gain")
ENDS = {"ends": {"0": End(), "infinity": End()}}
LATEX = {"prior": "P", "noise_variance": "B", "scalar_gain": "K_o", "variance_ratio": r"\rho"}


def towers() -> list[Tower]:
    """Both variances above zero; the kernel has their ratio alone."""
    gain = PREDICTED / (PREDICTED + MEASURED)
    ratio = real("variance_ratio")
    return [
        Tower(SCALAR, (Parameter("prior"), Parameter("noise_variance")), (), {"scalar_gain": gain}),
        Tower(RATIO, (Parameter("variance_ratio"),), (), {"scalar_gain": ratio / (1 + ratio)}),
    ]


def graph() -> Graph:
    """The gain and the share that is left of the prediction's variance, from P/B."""
    builder = GraphBuilder()
    ratio = builder.symbol("variance_ratio")
    whole = 1 + ratio
    return builder.graph({"gain": ratio / whole, "rest": 1 / whole})


def _limit(name: str, variable: str, point: str, value: int, joins: bool = True) -> Step:
    relation = limit(GAIN, point, sp.Integer(value), variable)
    if joins:
        return joined(name, relation, SCALAR, ENDS)
    return Step(
        name,
        "Its four limits: it tends to 1, and the update to the measurement, as the prediction "
        "gets poor or the measurement perfect; it tends to 0, and the update to the prediction, "
        "as the prediction gets perfect or the measurement poor.",
        relation,
        "Read off, the other variance being held.",
        SCALAR,
        ENDS,
    )


def scalar_steps(made: Mapping[str, Graph]) -> list[Step]:
    """The scalar gain and what the lecture says of it, and the kernel."""
    outputs = {"gain": GAIN, "rest": 1 - GAIN}
    return [
        Step(
            "scalar-gain",
            "In one dimension Kalman's gain of the position is the share of the prediction's "
            "variance `P` in the innovation's, whatever the model and the other states (step "
            "@own-gain), for a single measured position:",
            equal(GAIN, PREDICTED / (PREDICTED + MEASURED)),
            "Step @own-gain with matrices of size 1.",
            SCALAR,
            heading="One dimension",
        ),
        joined("scalar-positive", positive(GAIN), SCALAR),
        joined("scalar-below-one", positive(1 - GAIN), SCALAR),
        _limit("poor-prediction", "prior", INFINITY, 1, joins=False),
        _limit("perfect-prediction", "prior", "0", 0),
        _limit("poor-measurement", "noise_variance", INFINITY, 0),
        _limit("perfect-measurement", "noise_variance", "0", 1),
        Step(
            "scalar-rises",
            "In between it only rises with the one and falls with the other.",
            monotone(GAIN, "increasing", "prior"),
            "Differentiate.",
            SCALAR,
        ),
        joined("scalar-falls", monotone(GAIN, "decreasing", "noise_variance"), SCALAR),
        Step(
            "kernel-position-gain",
            "",
            Relation("program", {"program": KERNEL, "outputs": outputs}),
            "",
            RATIO,
            {"graph": made[KERNEL]},
            shown=False,
        ),
    ]
