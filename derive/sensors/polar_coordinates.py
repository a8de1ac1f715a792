"""Polar coordinates: range, elevation, bearing from north; their derivatives, noise and rates.

The derivation is the page `polar-coordinates` of `derive/pages`. There the value of a sine, cosine
or exponential that a kernel calls stands as the quantity that it is, and what an exponential or an
atan2 is taken of is claimed too (see `algebraic_graphs`).
"""

from __future__ import annotations

from pathlib import Path

from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.pages.kernel_page import page_graphs, page_module
from gainproof.derive.printer.graph import Graph
from gainproof.derive.sensors.algebraic_graphs import algebraic
from gainproof.derive.source import ELEMENTARY, LECTURE, PROBABILITY
from gainproof.derive.subject import Subject, page_subject

NAME = "polar-coordinates"
FORMULAS = Path(__file__).with_name("polar_kernels.md")
LATEX = {
    "elevation_loss": r"\ell_E",
    "bearing_loss": r"\ell_B",
    "range_acceleration": "R''",
    "elevation_acceleration": "E''",
    "bearing_acceleration": "B''",
}
"""Where the names on the page are no letters."""


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    return page_graphs(FORMULAS)


def build() -> Subject:
    """Derive the map, its inverse, their derivatives, noise, bias and rates."""
    made = graphs()
    plain = {name: algebraic(graph) for name, graph in made.items()}
    roots = {"horizontal_distance": "h", "distance": "R", "slant_range": "R"}
    page = written(NAME, Given(programs=plain, roots=roots))
    module = page_module(FORMULAS, made, NAME, page.title)
    sources = LECTURE.key, PROBABILITY.key, ELEMENTARY.key
    return page_subject(NAME, page, module, plain, sources, LATEX)
