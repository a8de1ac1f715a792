"""The printed module of filters with matrix gains: the gain of one coordinate."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output

KERNEL = "position_gain"
LARGEST = "1e300"


def graph() -> Graph:
    """The gain and the share that is left of the prediction's variance, from P/B."""
    builder = GraphBuilder()
    ratio = builder.symbol("variance_ratio")
    whole = 1 + ratio
    return builder.graph({"gain": ratio / whole, "rest": 1 / whole})


def kernel_module(name: str, title: str, made: Mapping[str, Graph]) -> Module:
    """The module with its one kernel."""
    kernels = (_kernel(name, kernel, graph) for kernel, graph in made.items())
    return catalogue_module(name, f"{title}: the gain of one coordinate", kernels)


def _kernel(name: str, kernel: str, graph: Graph) -> Kernel:
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary="Kalman's gain of the position from the variances of prediction and measurement.",
        equations=("gain = P/(P + B)", "rest = B/(P + B), the share left of P after the update"),
        inputs=(
            Input(
                "variance_ratio",
                "variance P of the predicted position over that of its measurement, B",
                "1e-300",
                LARGEST,
                lower_open=False,
                upper_open=False,
                single=("1e-30", "1e30"),
            ),
        ),
        outputs=(
            Output("gain", "gain of the position"),
            Output("rest", "the updated variance over the predicted one, 1 - gain"),
        ),
        graph=graph,
        source=f"derivation {name}",
    )
