"""Location from range and Doppler in multipath: what holds for every number of stations.

The derivation is the page `multipath-location` of `derive/pages`.
"""

from __future__ import annotations

from pathlib import Path

import sympy as sp

from gainproof.derive.pages.derivation import FOLDER, Given, written
from gainproof.derive.pages.kernel_page import page_graphs, page_module
from gainproof.derive.source import DOPPLER, MATRICES
from gainproof.derive.subject import Subject, page_subject

NAME = "multipath-location"
FORMULAS = Path(__file__).with_name("multipath_kernels.md")
LATEX = {"deviation": r"\sigma_b/\sigma", "root_two": r"\sqrt{2}"}
LAST = sp.Rational(7, 650)
"""The last variance of table 1, in (m/s)^2."""


def build(folder: Path = FOLDER) -> Subject:
    """Derive the estimates, their covariances, and when they exist.

    `folder`: where the page is. Raises PageError with the line of a mistake on it.
    """
    made = page_graphs(FORMULAS)
    differences = {
        "above_1035": _difference(LAST, sp.Rational(1035, 10000) ** 2),
        "below_1045": _difference(sp.Rational(1045, 10000) ** 2, LAST),
    }
    given = Given(slots={"": differences}, programs=made, roots={"root": "sigma_b"})
    page = written(NAME, given, folder)
    title = f"{page.title}: the deviation of an estimated bias"
    module = page_module(FORMULAS, made, NAME, title)
    return page_subject(NAME, page, module, made, (DOPPLER.key, MATRICES.key), LATEX)


def _difference(left: sp.Expr, right: sp.Expr) -> sp.Expr:
    """Of two numbers, for the checker to work out."""
    return sp.Add(left, -right, evaluate=False)
