"""Alpha-beta filters with any gains: what is true of all of them, and the named ones among them.

The derivation is the page `alpha-beta` of `derive/pages`; what it shares with three states, and
what the kernels compute, is made in `derive/fixed_gain`.
"""

from __future__ import annotations

from typing import Any

from gainproof.derive.derivation import Derivation
from gainproof.derive.fixed_gain.loop import Loop
from gainproof.derive.fixed_gain.names import LATEX
from gainproof.derive.fixed_gain.page_slots import page_slots
from gainproof.derive.fixed_gain.two_module import kernel_module
from gainproof.derive.fixed_gain.two_programs import SYMBOLS, graphs, kernel_steps
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.source import LECTURE
from gainproof.derive.subject import Program, Subject

NAME = "alpha-beta"
LOOP = Loop(2)
HINTS: dict[str, dict[str, Any]] = {
    "random-velocity-stable": {"form": "4 (x + root_two)/(x (x + 2))"},
    "random-velocity-stable-alpha": {"form": "2 root_two (root_two - 1)/(x + 2)"},
    "order-at-equal-lag": {
        "form": "((1 + y + g) (1/(g + 1 + r))/(g y second remainder)) "
        "(((2 + y + 2 g)^2 - (2 + 2 y + 2 g))/(2 + y + 2 g + r) + second/(g + 1 + r))"
    },
    "order-at-equal-lag-best": {
        "form": "(1 + y + g) (((1 + y + g)/(r + n))/third)^2/(second remainder)"
    },
    "order-at-equal-smaller-alpha": {"form": "(1 + x)^3 2 (1 + w)/(x^2 w (1 + x + w)^2)"},
    "predicted-definite": {"minors": ()},
}
"""Without the differences that hide a sign."""


def build() -> Subject:
    """Derive the alpha-beta filter with fixed gains."""
    made = graphs()
    alpha, beta = LOOP.gains
    lecture = (2 * alpha**2 + 2 * beta + alpha * beta) / (alpha * (4 - 2 * alpha - beta))
    given = Given(
        models={"fixed_gains": LOOP.model},
        hints=HINTS,
        slots={"": page_slots(LOOP, lecture)},
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
