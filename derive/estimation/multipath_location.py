"""Location from range and Doppler in multipath: what holds for every number of stations.

The derivation is the page `multipath-location` of `derive/pages`.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import sympy as sp

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.derivation import Derivation
from gainproof.derive.estimation.multipath_hints import HINTS
from gainproof.derive.pages.derivation import FOLDER, Given, written
from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output
from gainproof.derive.source import DOPPLER, MATRICES
from gainproof.derive.subject import Program, Subject

NAME = "multipath-location"
KERNEL, INPUT = "bias_deviation", "variance_ratio"
LARGEST = "1e300"
LATEX = {"deviation": r"\sigma_b/\sigma", "root_two": r"\sqrt{2}"}
LAST = sp.Rational(7, 650)
"""The last variance of table 1, in (m/s)^2."""


def build(folder: Path = FOLDER) -> Subject:
    """Derive the estimates, their covariances, and when they exist.

    `folder`: where the page is. Raises PageError with the line of a mistake on it.
    """
    made = {KERNEL: _graph()}
    differences = {
        "above_1035": _difference(LAST, sp.Rational(1035, 10000) ** 2),
        "below_1045": _difference(sp.Rational(1045, 10000) ** 2, LAST),
    }
    given = Given(slots={"": differences}, hints=HINTS, programs=made, roots={"root": "sigma_b"})
    page = written(NAME, given, folder)
    latex = {**page.latex, **LATEX}
    return Subject(
        name=NAME,
        title=page.title,
        model=None,
        derivation=Derivation(page.opening, page.steps, (DOPPLER.key, MATRICES.key), latex),
        towers=page.towers,
        programs={name: Program({INPUT: INPUT}, graph) for name, graph in made.items()},
        module=_kernel_module(NAME, page.title, made),
        textbook=dict,
        settings=page.settings,
    )


def _difference(left: sp.Expr, right: sp.Expr) -> sp.Expr:
    """Of two numbers, for the checker to work out."""
    return sp.Add(left, -right, evaluate=False)


def _graph() -> Graph:
    """Deviation of the bias over that of its range, and the share of the range's own noise."""
    builder = GraphBuilder()
    whole = 1 + builder.symbol(INPUT)
    root = builder.sqrt(whole)
    return builder.graph({"deviation": root, "share": 1 / whole}, {"root": root})


def _kernel_module(name: str, title: str, made: Mapping[str, Graph]) -> Module:
    """The module with its one kernel."""
    return catalogue_module(
        name,
        f"{title}: the deviation of an estimated bias",
        (
            Kernel(
                name=KERNEL,
                result="BiasDeviation",
                summary="Deviation of an estimated bias over that of its range.",
                equations=("deviation = sqrt(1 + r)", "share = 1/(1 + r)"),
                inputs=(
                    Input(
                        INPUT,
                        "variance of the range to the estimated position over that of the range's "
                        "noise, r",
                        "1e-300",
                        LARGEST,
                        lower_open=False,
                        upper_open=False,
                        single=("1e-30", "1e30"),
                    ),
                ),
                outputs=(
                    Output("deviation", "standard deviation of the bias over that of the range"),
                    Output("share", "share of the range's own noise in the variance of the bias"),
                ),
                graph=made[KERNEL],
                source=f"derivation {name}",
            ),
        ),
    )
