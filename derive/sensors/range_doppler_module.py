"""The printed module of range and Doppler: which domains its kernels have, and what they are."""

from __future__ import annotations

from collections.abc import Mapping

import sympy

from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, Requirement, signed
from gainproof.derive.sensors.range_doppler_graphs import RANGE
from gainproof.derive.sensors.range_doppler_names import PLANE
from gainproof.derive.sensors.range_doppler_words import EQUATIONS, SUMMARIES, meaning, of_input

LENGTH = ("0", "1e60", ("0", "1e12"))
SPEED = ("0", "1e60", ("0", "1e9"))
APART = Requirement(RANGE, "distance of the target from the station", "1e-20", "1e-6")


def kernel_module(name: str, title: str, made: Mapping[str, Graph]) -> Module:
    """The module of range and Doppler."""
    return Module(
        name=name.replace("-", "_"),
        title=f"{title}.",
        command=f"gainproof generate {name}",
        derivation=f"gainproof derive {name}, SymPy {sympy.__version__}",
        kernels=tuple(_kernel(name, kernel, graph) for kernel, graph in made.items()),
    )


def _kernel(name: str, kernel: str, graph: Graph) -> Kernel:
    shown = [entry for entry in graph["outputs"] if entry != RANGE or with_range(kernel)]
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=SUMMARIES[kernel],
        equations=EQUATIONS[kernel],
        inputs=tuple(_input(str(node[1])) for node in graph["nodes"] if node[0] == "symbol"),
        outputs=tuple(Output(entry, meaning(entry), by_terms=cancels(entry)) for entry in shown),
        graph=graph,
        source=f"derivation {name}",
        requirements=(APART,),
    )


def with_range(kernel: str) -> bool:
    """Whether the range is a result, and not only what must not be 0."""
    return kernel.removesuffix(PLANE) in ("slant_range", "range_doppler")


def cancels(entry: str) -> bool:
    """Whether an output is a sum whose terms may have different signs."""
    return entry.startswith("range_rate") and not entry.startswith("range_rate_D_velocity_")


def _input(entry: str) -> Input:
    return signed(entry, of_input(entry), *(SPEED if "_velocity_" in entry else LENGTH))
