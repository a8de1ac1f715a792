"""The gains in double-words: the root refined from the gains of float64, then the forms themselves.

xi = f(xi) with f(xi) = sqrt(a1 + 2 sqrt(a2 + 2 delta xi)). From xi0 = 2 beta/gamma, which the plain
kernel gives, one step with f(xi0) in double-words goes to a root of twice as many digits
(`gainproof.derive.printer.double_word.refinement`). The index keeps between 2^-400 and 2^400, so
that nothing needs a scale. With a1 from 1 to 4, a2 and e at most 4 the root is at least 1 and at
most 2^140: delta is at most 2^404, and f(2^140) <= sqrt(4 + 2 sqrt(4 + 2^545)) < 2^140.
"""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.printer.kernel import Input, Refinement, closed
from gainproof.derive.three_state.names import DELTA, ETA, XI
from gainproof.derive.three_state.spectrum import Spectrum

FARTHEST = 400
"""Of the exponent of the index."""
REFINEMENT = Refinement(
    near="near_xi", root="xi", image="image", slope="slope", over="beta", under="gamma", factor=2
)


def accurate_input(given: Input) -> Input:
    """The index where double-words keep their digits."""
    return closed(given.name, given.meaning, Fraction(1, 2**FARTHEST), 2**FARTHEST)


def within_reach(spectrum: Spectrum) -> bool:
    """Whether the limits of the root hold; own models may have other numbers."""
    return 1 <= spectrum.a1 <= 4 and 0 <= spectrum.a2 <= 4 and 0 <= spectrum.e <= 4


def accurate_graph(spectrum: Spectrum) -> Graph:
    """f and its logarithmic slope near the root, and the gains from the root."""
    builder = GraphBuilder()
    index = builder.symbol("tracking_index")
    delta = builder.sqrt(64 / (index * index) + spectrum.e) if spectrum.e else 8 / index
    names = {"delta": delta}

    def eta_of(xi: Node) -> Node:
        square = (delta * xi) * 2
        return builder.sqrt(square + spectrum.a2 if spectrum.a2 else square)

    near = builder.symbol(REFINEMENT.near)
    near_eta = names["near_eta"] = eta_of(near)
    image = names["image"] = builder.sqrt(near_eta * 2 + spectrum.a1)
    slope = delta / (near * near_eta)
    xi = builder.symbol(REFINEMENT.root)
    eta = names["eta"] = eta_of(xi)
    nu = names["nu"] = delta + ((xi + eta) + 1)
    outputs = {
        "alpha": ((eta + 1) * 2) / nu,
        "beta": (xi * 4) / nu,
        "gamma": 8 / nu,
        REFINEMENT.image: image,
        REFINEMENT.slope: slope,
    }
    return builder.graph(outputs, names)


def accurate_inputs() -> dict[str, str]:
    """What the graph's symbols stand for: the start is the root where f is shown to keep it."""
    return {"tracking_index": "tracking_index", REFINEMENT.near: "xi", REFINEMENT.root: "xi"}


def accurate_roots() -> dict[str, sp.Expr]:
    """Tower values of the square roots."""
    return {"delta": DELTA, "near_eta": ETA, "eta": ETA, "image": XI}


def accurate_meaning(output: str) -> sp.Expr | None:
    """What outputs beside the gains stand for."""
    return {REFINEMENT.image: XI, REFINEMENT.slope: DELTA / (XI * ETA)}.get(output)
