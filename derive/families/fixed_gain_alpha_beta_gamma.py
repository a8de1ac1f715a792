"""Alpha-beta-gamma filters with any gains, and the named ones among them."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Derivation
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.names import LATEX
from gainproof.derive.fixed_gain.steps_answer import answer_steps
from gainproof.derive.fixed_gain.steps_filter import filter_steps
from gainproof.derive.fixed_gain.steps_lag import lag_steps
from gainproof.derive.fixed_gain.steps_variance import variance_steps
from gainproof.derive.fixed_gain.three_curve_towers import curve_steps, curve_towers
from gainproof.derive.fixed_gain.three_kernels import graphs
from gainproof.derive.fixed_gain.three_module import SYMBOLS, kernel_module, kernel_steps
from gainproof.derive.fixed_gain.three_pole_kernels import pole_steps, pole_tower
from gainproof.derive.fixed_gain.three_steps_minimum import minimum_steps
from gainproof.derive.fixed_gain.three_steps_named import named_steps
from gainproof.derive.fixed_gain.three_steps_noise import noise_steps, noise_tower
from gainproof.derive.fixed_gain.three_steps_optimum import lecture_variance, optimum_steps
from gainproof.derive.fixed_gain.three_steps_order import ordering_steps
from gainproof.derive.fixed_gain.three_steps_stability import stability_steps
from gainproof.derive.fixed_gain.three_towers import LOOP, D, M, X, towers
from gainproof.derive.source import LECTURE
from gainproof.derive.subject import Program, Subject

NAME = "alpha-beta-gamma"
TITLE = "Alpha-beta-gamma filters with any gains"
OPENING = (
    "Three numbers make an alpha-beta-gamma filter. Which of them are stable, how much of the "
    "measurement noise they let through, how far they fall behind, and which are best."
)


def build() -> Subject:
    """Derive the alpha-beta-gamma filter with fixed gains."""
    made = graphs()
    steps = (
        *filter_steps(LOOP),
        *answer_steps(LOOP),
        *stability_steps(),
        *pole_steps(),
        *variance_steps(LOOP, lecture_variance(), _minors()),
        *noise_steps(),
        *lag_steps(LOOP),
        *optimum_steps(),
        *minimum_steps(),
        *named_steps(),
        *ordering_steps(),
        *curve_steps(),
        *kernel_steps(made),
    )
    return Subject(
        name=NAME,
        title=TITLE,
        model=None,
        derivation=Derivation(OPENING, steps, (LECTURE.key,), LATEX),
        towers={
            tower.name: tower for tower in (*towers(), noise_tower(), pole_tower(), *curve_towers())
        },
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
        module=kernel_module(NAME, TITLE, made),
        textbook=dict,
    )


def _minors() -> tuple[sp.Expr, ...]:
    """The leading minors of P; m^2 - m x^3 + x^6 is (m^3 + x^9)/(m + x^3)."""
    second = D * M + M * X + 2 * X**5 + X**4 + (M**3 + X**9) / (M + X**3)
    return real("predicted_11"), 4 * second / (D * M**2 * X), 64 / (D * M**2)
