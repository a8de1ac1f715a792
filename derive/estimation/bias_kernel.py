"""The kernel of the deviation of an estimated bias, and steps on it: (138) for one station."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.algebra.variables import Generator
from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output
from gainproof.derive.relation import Relation, monotone, positive

TOWER, KERNEL, INPUT = "one_station", "bias_deviation", "variance_ratio"
RATIO, DEVIATION = real(INPUT), real("deviation")
LATEX = {INPUT: r"\rho", "deviation": r"\sigma_b/\sigma"}
LARGEST = "1e300"


def tower() -> Tower:
    """The ratio of the two variances, and the root of their sum."""
    root = Generator("deviation", 1 + RATIO)
    return Tower(TOWER, (Parameter(INPUT),), (root,), {})


def graph() -> Graph:
    """Deviation of the bias over that of its range, and the share of the range's own noise."""
    builder = GraphBuilder()
    whole = 1 + builder.symbol(INPUT)
    root = builder.sqrt(whole)
    return builder.graph({"deviation": root, "share": 1 / whole}, {"root": root})


def kernel_steps(made: Mapping[str, Graph]) -> list[Step]:
    """What (55) divides by."""
    outputs = {"deviation": DEVIATION, "share": 1 / (1 + RATIO)}
    return [
        Step(
            "bias-deviation",
            "What (55) divides by, for one station: with the ratio `rho` of the variance of the "
            "range to the estimated position to that of the measured range, the deviation of the "
            "bias is `sqrt(1 + rho)` deviations of the range, (138). It is never below these, and "
            "only rises with `rho`: the less is known of the course, the larger a bias must be to "
            "be seen.",
            positive(DEVIATION - 1),
            "`rho > 0`; differentiate.",
            TOWER,
            heading="The test of a bias",
        ),
        joined("bias-deviation-rises", monotone(DEVIATION, "increasing", INPUT), TOWER),
        Step(
            "kernel-bias-deviation",
            "",
            Relation("program", {"program": KERNEL, "outputs": outputs}),
            "",
            TOWER,
            {"graph": made[KERNEL], "roots": {"root": DEVIATION}},
            shown=False,
        ),
    ]


def kernel_module(name: str, title: str, made: Mapping[str, Graph]) -> Module:
    """The module with its one kernel."""
    return catalogue_module(
        name,
        f"{title}: the deviation of an estimated bias",
        (
            Kernel(
                name=KERNEL,
                result="BiasDeviation",
                summary="Deviation of an estimated bias over that of its range.",
                equations=("deviation = sqrt(1 + r)", "share = 1/(1 + r)"),
                inputs=(
                    Input(
                        INPUT,
                        "variance of the range to the estimated position over that of the range's "
                        "noise, r",
                        "1e-300",
                        LARGEST,
                        lower_open=False,
                        upper_open=False,
                        single=("1e-30", "1e30"),
                    ),
                ),
                outputs=(
                    Output("deviation", "standard deviation of the bias over that of the range"),
                    Output("share", "share of the range's own noise in the variance of the bias"),
                ),
                graph=made[KERNEL],
                source=f"derivation {name}",
            ),
        ),
    )
