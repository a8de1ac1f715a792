"""The printed module of a three-state family: what its page of kernels leaves open."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from gainproof.derive.pages.kernel_page import page_module
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Kernel, Module
from gainproof.derive.subject import in_double_words
from gainproof.derive.three_state.accurate_gains import REFINEMENT, accurate_input
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.kernels import FORMULAS

ACCURATE_GAINS = in_double_words("gains")


def kernel_module(c: Context, graphs: Mapping[str, Graph]) -> Module:
    """The module of a family."""
    title = f"{c.model.title}: steady state with measured position"
    shown = {name: graph for name, graph in graphs.items() if name != ACCURATE_GAINS}
    found = page_module(FORMULAS, shown, c.model.name, title, _words(c))
    accurate = graphs.get(ACCURATE_GAINS)
    if accurate is None:
        return found
    kernels = (_in_double_words(x, accurate) if x.name == "gains" else x for x in found.kernels)
    return replace(found, kernels=tuple(kernels))


def _in_double_words(kernel: Kernel, graph: Graph) -> Kernel:
    given = accurate_input(kernel.inputs[0])
    return replace(kernel, accurate=given, accurate_graph=graph, refinement=REFINEMENT)


def _words(c: Context) -> dict[str, str]:
    a1, a2, e = c.numbers
    of_poles = "with d(s) = 1 + xi s + eta s^2 + delta s^3 and z = (1 + s)/(1 - s),"
    if c.spectrum.rational_in_root:
        of_poles = (
            "one pole is w = 1/sigma, the others solve z^2 - 2 m z + w = 0, "
            "m = (xi^2 - 8)/(xi^2 + 2 xi),"
        )
    return {
        "noise_ratio": str(c.model.noise_ratio),
        "delta": f"delta = {f'sqrt(64/Lambda^2 + {e})' if e else '8/Lambda'},",
        "a1": str(a1),
        "a2": str(a2),
        "of_poles": of_poles,
        "poles": "\n".join(_poles(c)),
    }


def _poles(c: Context) -> tuple[str, ...]:
    """The lines on what the poles are."""
    if c.spectrum.rational_in_root:
        return (
            "real_pole = w = 1/sigma, modulus = sqrt(w), half_sum = (xi^2 - 8)/(xi^2 + 2 xi),",
            "xi^3 - 4 xi = 64/Lambda",
        )
    m1, m2 = c.spectrum.m1, c.spectrum.m2
    linear = f" + {1 - m1} G" if m1 != 1 else ""
    rise = "" if m1 == 1 else f"{2 - m1} "
    cubic = f"G (G^2 + {rise}G + {1 - m1 + m2})"
    last = f"G^2{linear}{f' + {m2}' if m2 else ''}"
    return (
        f"{cubic} = 64/Lambda^2, t = sqrt(1 + G), g = sqrt({last}),",
        f"a = sqrt({m1} + 2 g - G), real_pole = (t - 1)/(t + 1), half_sum = (g - 1)/(1 + a + g)",
    )
