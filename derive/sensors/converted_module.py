"""The printed module of converted measurements: domains of its kernels, and what they say."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed, signed
from gainproof.derive.sensors.kernel_page import PLANE, kernel_words, page_graphs

FORMULAS = Path(__file__).with_name("converted_kernels.md")
MEANINGS = {
    "x": "converted x, m",
    "y": "converted y, m",
    "z": "converted z, m",
    **{f"covariance_{a}{a}": f"stated variance of {a}, m^2" for a in "xyz"},
    **{
        f"covariance_{a}{b}": f"stated covariance of {a} and {b}, m^2"
        for a, b in ("xy", "xz", "yz")
    },
}

MEANINGS |= {
    "radial_variance": "stated variance along the measured line of sight, m^2",
    "cross_variance": "stated variance across the measured line of sight, m^2",
}

RANGE = ("1e-20", "1e60", ("1e-3", "1e12"))
DEVIATION = ("1e-15", "2", ("1e-6", "2"))
TURN = ("1e-20", "6.2832", ("1e-12", "6.2832"))
DOMAINS: dict[str, Input] = {
    "slant_range": closed("slant_range", "measured range, m", *RANGE),
    "elevation": signed(
        "elevation",
        "measured elevation above the plane of x and y, rad",
        "1e-20",
        "1.5707963267948966",
        ("1e-12", "1.5707962"),
    ),
    "azimuth": signed("azimuth", "measured azimuth from x towards y, rad", *TURN),
    "range_deviation": closed("range_deviation", "standard deviation of the range, m", *RANGE),
    **{
        f"{angle}_deviation": closed(
            f"{angle}_deviation", f"standard deviation of the {angle}, rad", *DEVIATION
        )
        for angle in ("elevation", "azimuth")
    },
    "correlation": signed(
        "correlation", "correlation of the noises of range and azimuth", "1e-20", "1", ("1e-6", "1")
    ),
}
"""The arguments in their order."""


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    found = page_graphs(FORMULAS, lambda _: {name: name for name in DOMAINS})
    return {name: found[name] for name in sorted(found, key=_place)}


def _place(kernel: str) -> tuple[bool, bool]:
    return kernel.startswith("correlated"), not kernel.endswith(PLANE)


def kernel_module(name: str, title: str, graphs: Mapping[str, Graph]) -> Module:
    """The module of converted measurements."""
    words = kernel_words(FORMULAS, graphs)
    kernels = (_kernel(name, kernel, graph, *words[kernel]) for kernel, graph in graphs.items())
    return catalogue_module(name, title, kernels)


def _kernel(
    name: str, kernel: str, graph: Graph, summary: str, equations: tuple[str, ...]
) -> Kernel:
    used = set(symbols_of(graph))
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=summary,
        equations=equations,
        inputs=tuple(DOMAINS[entry] for entry in DOMAINS if entry in used),
        outputs=tuple(
            Output(entry, MEANINGS[entry], by_terms=_cancels(kernel, entry))
            for entry in graph["outputs"]
        ),
        graph=graph,
        source=f"derivation {name}",
    )


CANCELS = ("covariance_xy", "covariance_xz", "covariance_yz")
"""Outputs that change their sign: differences of the variances along the axes."""


def _cancels(kernel: str, entry: str) -> bool:
    return entry in CANCELS or kernel.startswith("correlated")
