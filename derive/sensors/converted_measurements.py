"""Converted measurements: polar ones made Cartesian, what that does to their noise.

The derivation is the page `converted-measurements` of `derive/pages`. There the value of a sine,
cosine or exponential that a kernel calls stands as the quantity that it is, and what an exponential
is taken of is claimed too (see `algebraic_graphs`).
"""

from __future__ import annotations

from pathlib import Path

from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.pages.kernel_formulas import PLANE
from gainproof.derive.pages.kernel_page import page_graphs, page_module
from gainproof.derive.printer.graph import Graph
from gainproof.derive.sensors.algebraic_graphs import algebraic
from gainproof.derive.source import (
    DEBIASED,
    ELEMENTARY,
    MODIFIED,
    PROBABILITY,
    TRACKER_LIBRARY,
    UNBIASED,
)
from gainproof.derive.subject import Subject, page_subject

NAME = "converted-measurements"
FORMULAS = Path(__file__).with_name("converted_kernels.md")
SOURCES = (DEBIASED, UNBIASED, MODIFIED, TRACKER_LIBRARY, PROBABILITY, ELEMENTARY)
LATEX = {
    "azimuth": r"\theta",
    "measured_azimuth": r"\theta_m",
    "elevation": r"\eta",
    "azimuth_loss": r"\ell",
    "elevation_loss": r"\ell_\eta",
    "true_spread_radial": r"V_\rho(r)",
    "true_spread_cross": r"V_\kappa(r)",
    "covariance_more": "c_+",
    "covariance_less": "c_-",
    "azimuth_covariance_more": "c_+",
    "azimuth_covariance_less": "c_-",
    "elevation_covariance_more": "e_+",
    "elevation_covariance_less": "e_-",
    **{
        f"{name}_{axis}": rf"{letter}_{{{short}}}"
        for name, letter in (("correlated", "N"), ("correlated_unbiased", "B"))
        for axis, short in (
            ("radial", r"\rho\rho"),
            ("cross", r"\kappa\kappa"),
            ("mixed", r"\rho\kappa"),
        )
    },
}
"""Where the names on the page are no letters."""


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name: those in the plane, in space, of correlated noises."""
    found = page_graphs(FORMULAS)
    return {name: found[name] for name in sorted(found, key=_place)}


def _place(kernel: str) -> tuple[bool, bool]:
    return kernel.startswith("correlated"), not kernel.endswith(PLANE)


def build() -> Subject:
    """Derive the moments, the four conversions, what they are exact for, and their growth."""
    made = graphs()
    plain = {name: algebraic(graph) for name, graph in made.items()}
    page = written(NAME, Given(programs=plain))
    module = page_module(FORMULAS, made, NAME, page.title)
    return page_subject(NAME, page, module, plain, tuple(each.key for each in SOURCES), LATEX)
