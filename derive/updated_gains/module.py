"""The printed module of gains that follow the index: domains, and what its kernels say."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed, signed
from gainproof.derive.updated_gains.words import EQUATIONS, MEANINGS, SUMMARIES

INDEX = ("1e-12", "1e12", ("1e-5", "1e5"))
GAIN = ("1e-30", "1e30", ("1e-9", "1e9"))
BY_TERMS = {"next_alpha", "next_beta"}
"""Sums of a gain and a step of either sign."""
DOMAINS: dict[str, Input] = {
    name: closed(name, MEANINGS[name], *domain)
    for name, domain in {
        "nominal_index": INDEX,
        "tracking_index": INDEX,
        "next_index": INDEX,
        "acceleration_deviation": ("1e-30", "1e30", ("1e-6", "1e6")),
        "interval": ("1e-15", "1e15", ("1e-6", "1e6")),
        "variance": ("1e-60", "1e60", ("1e-12", "1e12")),
        "along": GAIN,
        "across": GAIN,
    }.items()
} | {
    name: signed(name, MEANINGS[name], *domain)
    for name, domain in {
        "alpha": GAIN,
        "beta": GAIN,
        "cosine": ("0", "2", ("0", "2")),
        "sine": ("0", "2", ("0", "2")),
    }.items()
}


def kernel_module(name: str, title: str, made: Mapping[str, Graph]) -> Module:
    """The module of gains that follow the index."""
    kernels = (_kernel(name, kernel, graph) for kernel, graph in made.items())
    return catalogue_module(name, title, kernels)


def _kernel(name: str, kernel: str, graph: Graph) -> Kernel:
    symbols = symbols_of(graph)
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=SUMMARIES[kernel],
        equations=EQUATIONS[kernel],
        inputs=tuple(DOMAINS[symbol] for symbol in symbols),
        outputs=tuple(
            Output(entry, MEANINGS[entry], by_terms=entry in BY_TERMS) for entry in graph["outputs"]
        ),
        graph=graph,
        source=f"derivation {name}",
    )
