"""The kernel of the deviation of an estimated bias: (138) for one station."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output

KERNEL, INPUT = "bias_deviation", "variance_ratio"
LARGEST = "1e300"


def graph() -> Graph:
    """Deviation of the bias over that of its range, and the share of the range's own noise."""
    builder = GraphBuilder()
    whole = 1 + builder.symbol(INPUT)
    root = builder.sqrt(whole)
    return builder.graph({"deviation": root, "share": 1 / whole}, {"root": root})


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
