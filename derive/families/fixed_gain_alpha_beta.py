"""Alpha-beta filters with any gains: what is true of all of them, and the named ones among them."""

from __future__ import annotations

from gainproof.derive.derivation import Derivation
from gainproof.derive.fixed_gain.names import LATEX
from gainproof.derive.fixed_gain.steps_answer import answer_steps
from gainproof.derive.fixed_gain.steps_filter import filter_steps
from gainproof.derive.fixed_gain.steps_lag import lag_steps
from gainproof.derive.fixed_gain.steps_variance import variance_steps
from gainproof.derive.fixed_gain.two_held_gain_towers import held_gain_towers
from gainproof.derive.fixed_gain.two_module import kernel_module
from gainproof.derive.fixed_gain.two_named_towers import named_towers
from gainproof.derive.fixed_gain.two_programs import SYMBOLS, graphs, kernel_steps
from gainproof.derive.fixed_gain.two_steps_curves import curve_steps
from gainproof.derive.fixed_gain.two_steps_ends import end_steps, end_towers
from gainproof.derive.fixed_gain.two_steps_fitting_gain import fitting_gain_steps
from gainproof.derive.fixed_gain.two_steps_held_gain import held_gain_steps
from gainproof.derive.fixed_gain.two_steps_named import named_steps
from gainproof.derive.fixed_gain.two_steps_optimum import optimum_steps
from gainproof.derive.fixed_gain.two_steps_order import lecture_variance, ordering_steps
from gainproof.derive.fixed_gain.two_steps_stability import ALPHA, BETA, stability_steps
from gainproof.derive.fixed_gain.two_towers import LOOP, towers
from gainproof.derive.source import LECTURE
from gainproof.derive.subject import Program, Subject

NAME = "alpha-beta"
TITLE = "Alpha-beta filters with any gains"
OPENING = (
    "Two numbers make an alpha-beta filter. Which of them are stable, how much of the measurement "
    "noise they let through, how far they fall behind a target that turns, and which are best."
)


def build() -> Subject:
    """Derive the alpha-beta filter with fixed gains."""
    made = graphs()
    steps = (
        *filter_steps(LOOP),
        *answer_steps(LOOP),
        *stability_steps(),
        *variance_steps(LOOP, lecture_variance(ALPHA, BETA)),
        *lag_steps(LOOP),
        *optimum_steps(),
        *named_steps(),
        *ordering_steps(),
        *end_steps(),
        *held_gain_steps(),
        *fitting_gain_steps(),
        *curve_steps(),
        *kernel_steps(made),
    )
    return Subject(
        name=NAME,
        title=TITLE,
        model=None,
        derivation=Derivation(OPENING, steps, (LECTURE.key,), LATEX),
        towers={
            tower.name: tower
            for tower in (*towers(), *named_towers(), *end_towers(), *held_gain_towers())
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
