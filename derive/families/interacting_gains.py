"""Filters with matrix gains: what is true for every number of coordinates.

The derivation is the page `interacting-gains` of `derive/pages`.
"""

from __future__ import annotations

from pathlib import Path

import sympy as sp

import gainproof.derive.fixed_gain
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.pages.kernel_page import page_graphs, page_module
from gainproof.derive.source import LECTURE, MATRICES
from gainproof.derive.subject import Subject, page_subject

NAME = "interacting-gains"
FORMULAS = Path(gainproof.derive.fixed_gain.__path__[0]) / "interacting_kernels.md"
MODEL = {
    "name": "two-coordinates",
    "title": "Two coordinates at constant velocity",
    "transition": [list(row) for row in ("1010", "0101", "0010", "0001")],
    "process_noise": [["0"] * 4] * 4,
    "measurement": [list(row) for row in ("1000", "0100")],
    "measurement_noise": [list(row) for row in ("10", "01")],
}
SLOTS = {
    name: sp.Add(larger, smaller, evaluate=False)
    for name, larger, smaller in (
        ("prediction_smaller", sp.Integer(3), sp.Rational(-133, 45)),
        ("update_smaller", sp.Rational(7, 9), sp.Rational(-10, 13)),
    )
}
"""Differences of two numbers, for the checker to subtract."""


def build() -> Subject:
    """Derive filters with matrix gains."""
    made = page_graphs(FORMULAS)
    given = Given(
        models={"two_coordinates": MODEL},
        slots={"": SLOTS},
        programs=made,
    )
    page = written(NAME, given)
    module = page_module(FORMULAS, made, NAME, f"{page.title}: the gain of one coordinate")
    return page_subject(NAME, page, module, made, (LECTURE.key, MATRICES.key))
