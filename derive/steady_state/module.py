"""The printed module of a two-state family: what its page of kernels leaves open."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from gainproof.derive.pages.kernel_page import page_module
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Kernel, Module, closed
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.kernels import FORMULAS, largest_beta
from gainproof.derive.subject import in_double_words

ACCURATE_GAINS = in_double_words("gains")


def kernel_module(c: Context, graphs: Mapping[str, Graph]) -> Module:
    """The module of a family."""
    title = f"{c.model.title}: steady state with measured position"
    shown = {name: graph for name, graph in graphs.items() if name != ACCURATE_GAINS}
    found = page_module(FORMULAS, shown, c.model.name, title, _words(c))
    kernels = tuple(_with_more(c, kernel, graphs[ACCURATE_GAINS]) for kernel in found.kernels)
    return replace(found, kernels=kernels, results="_two_state_results")


def _with_more(c: Context, kernel: Kernel, accurate: Graph) -> Kernel:
    """With the graph in double-words, and the end of a domain that is no rational number."""
    (given,) = kernel.inputs
    if kernel.name == "gains":
        wide = closed(given.name, given.meaning, Fraction(1, 2**400), 2**400)
        return replace(kernel, accurate=wide, accurate_graph=accurate)
    if given.name == "beta":
        return replace(kernel, inputs=(replace(given, upper=largest_beta(c.e)),))
    return kernel


def _words(c: Context) -> dict[str, str]:
    e, n = c.e, c.n
    return {
        "noise_ratio": str(c.model.noise_ratio),
        "largest_beta": "2",
        "kappa": "2/Lambda" if e == 0 else f"sqrt(4/Lambda^2 + {e / 4})",
        "beside": str((1 + e) / 4),
        "raised": f"(1 + {e / 2}/kappa)" if e else "1",
        "h": f"sqrt(16/Lambda + {'' if e == 1 else f'{e} '}Lambda)" if e else "4/p",
        "less": str(1 - n),
        "rate": f"(rho - {n})" if n else "rho",
        "e": str(e),
        "product": ""
        if e
        else "\nIt is a product with Lambda - 4/(3 + 2 sqrt(3)), which keeps its digits.",
        "relation": str(c.spectrum.relation),
    }
