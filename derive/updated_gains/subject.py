"""Gains that follow the tracking index to first order: errors, limits, drift, variances.

The derivation is the page `updated-gains` of `derive/pages`; here is what it does not say.
"""

from __future__ import annotations

from pathlib import Path

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Derivation
from gainproof.derive.expression import real
from gainproof.derive.families.random_acceleration import model
from gainproof.derive.model import scale
from gainproof.derive.pages.derivation import FOLDER, Given, written
from gainproof.derive.pages.kernel_page import page_graphs, page_module
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.source import KALATA, MATRICES, UPDATED
from gainproof.derive.steady_state.names import LATEX
from gainproof.derive.subject import Program, Subject

NAME = "updated-gains"
FORMULAS = Path(__file__).with_name("kernels.md")
INPUTS = {"alpha": "nominal_alpha", "beta": "nominal_beta", "next_index": "following_index"}
"""Of `recursive_gains`: the gains so far are any; those of a third index stand for them."""
ROOTS = {
    "nominal_root": "1 + 2/n",
    "root": "1 + 2/e",
    "deviation": "sigma_i",
    "s": "s",
    "u": "u",
    "v": "v",
}
BOUNDS = {
    "0": End(boundary={"s": sp.Integer(1), "u": sp.Integer(1), "v": sp.Integer(2)}),
    "infinity": End(
        weights={"s": 1, "u": 1, "v": 1},
        constants={"root_5": 5},
        boundary={"s": real("root_5"), "u": sp.Integer(2), "v": real("root_5")},
    ),
}


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    return page_graphs(FORMULAS)


def build(folder: Path = FOLDER) -> Subject:
    """Derive errors, limits and drift of first-order gains, and what wrong gains cost.

    `folder`: where the page is. Raises PageError with the line of a mistake on it.
    """
    made, scaled = graphs(), scale(model())
    given = Given(
        models={"random_acceleration": scaled.data()},
        ends={"bounds": BOUNDS},
        programs=made,
        roots=ROOTS,
    )
    page = written(NAME, given, folder)
    sources = (KALATA.key, MATRICES.key, UPDATED.key)
    latex = {**LATEX, **page.latex, "root_3": r"\sqrt{3}", "root_5": r"\sqrt{5}"}
    return Subject(
        name=NAME,
        title=page.title,
        model=scaled,
        derivation=Derivation(page.opening, page.steps, sources, latex),
        towers=page.towers,
        programs={name: Program(_inputs(name, graph), graph) for name, graph in made.items()},
        module=page_module(FORMULAS, made, NAME, page.title),
        textbook=dict,
    )


def _inputs(name: str, graph: Graph) -> dict[str, str]:
    named = INPUTS if name == "recursive_gains" else {}
    return {symbol: named.get(symbol, symbol) for symbol in symbols_of(graph)}
