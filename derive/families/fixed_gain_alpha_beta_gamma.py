"""Alpha-beta-gamma filters with any gains, and the named ones among them.

The derivation is the page `alpha-beta-gamma` of `derive/pages`; what it shares with two states, and
what the kernels compute, is made in `derive/fixed_gain`.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Derivation
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.names import LATEX
from gainproof.derive.fixed_gain.page_slots import page_slots
from gainproof.derive.fixed_gain.three_kernels import graphs
from gainproof.derive.fixed_gain.three_module import SYMBOLS, kernel_module, kernel_steps
from gainproof.derive.fixed_gain.three_noises import noise_tower, noise_variances
from gainproof.derive.fixed_gain.three_random_jerk_tower import curve_towers
from gainproof.derive.fixed_gain.three_towers import LOOP, D, M, X, lecture_variance, main_tower
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.source import LECTURE
from gainproof.derive.subject import Program, Subject

NAME = "alpha-beta-gamma"


def build() -> Subject:
    """Derive the alpha-beta-gamma filter with fixed gains."""
    made = graphs()
    given = Given(
        towers=(main_tower(), noise_tower(), *curve_towers()),
        models={"fixed_gains": LOOP.model},
        slots={"": {**page_slots(LOOP, lecture_variance()), "noise_variances": noise_variances()}},
        hints={"predicted-definite": {"minors": _minors()}},
    )
    page = written(NAME, given)
    return Subject(
        name=NAME,
        title=page.title,
        model=None,
        derivation=Derivation(
            page.opening,
            (*page.steps, *kernel_steps(made)),
            (LECTURE.key,),
            {**page.latex, **LATEX},
        ),
        towers=page.towers,
        programs={
            name: Program(
                {
                    str(node[1]): SYMBOLS.get(str(node[1]), str(node[1]))
                    for node in graph["nodes"]
                    if node[0] == "symbol"
                },
                graph,
            )
            for name, graph in made.items()
        },
        module=kernel_module(NAME, page.title, made),
        textbook=dict,
    )


def _minors() -> tuple[sp.Expr, ...]:
    """The leading minors of P; m^2 - m x^3 + x^6 is (m^3 + x^9)/(m + x^3)."""
    second = D * M + M * X + 2 * X**5 + X**4 + (M**3 + X**9) / (M + X**3)
    return real("predicted_11"), 4 * second / (D * M**2 * X), 64 / (D * M**2)
