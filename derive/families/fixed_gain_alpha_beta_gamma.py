"""Alpha-beta-gamma filters with any gains, and the named ones among them.

The derivation is the page `alpha-beta-gamma` of `derive/pages`; what it shares with two states, and
what the kernels compute, is made in `derive/fixed_gain`.
"""

from __future__ import annotations

from pathlib import Path

import sympy as sp

import gainproof.derive.fixed_gain
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.algebra.variables import above_zero
from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.derivation import kernel_step
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain import three_noise_forms as forms
from gainproof.derive.fixed_gain.loop import pairs, row, symmetric
from gainproof.derive.fixed_gain.names import LATEX
from gainproof.derive.fixed_gain.page_slots import page_slots
from gainproof.derive.fixed_gain.three_noise_forms import ONE, After, Place
from gainproof.derive.fixed_gain.three_noise_kernels import NOISES, kernel_of, noise_graphs
from gainproof.derive.fixed_gain.three_random_jerk_tower import curve_roots, curve_towers
from gainproof.derive.fixed_gain.three_towers import (
    LOOP,
    D,
    M,
    X,
    gain_elements,
    lecture_variance,
    main_tower,
)
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.pages.kernel_formulas import SCALE
from gainproof.derive.pages.kernel_page import page_graphs, page_kernels
from gainproof.derive.printer.graph import Graph
from gainproof.derive.source import LECTURE
from gainproof.derive.subject import Subject, page_subject

TOWER = "noise"
Y = (D + M) / X
HERE = Place(ONE, X, Y, D, M, 1 + Y, 1 + X + Y, 1 + X + Y + D)
ALPHA = 2 * (1 + Y) / HERE.n
THERE = After(X - 1, (1 - ALPHA) * HERE.n, sp.Integer(1))


def noise_tower() -> Tower:
    """Every stable filter, with what each noise adds before the update."""
    added = {
        f"{name}_{ij}": value
        for name, noise in NOISES.items()
        for ij, value in forms.predicted(noise, HERE).items()
    }
    gains = {**gain_elements(X, Y, D), "share": (D + X) / (D + X + M)}
    return Tower(TOWER, above_zero("x", "d", "m"), (), {**gains, **added})


def noise_variances() -> sp.ImmutableDenseMatrix:
    """What each noise of ratio 1 adds to the variance of the predicted position."""
    return row(*(forms.predicted(noise, HERE)["11"] for noise in NOISES.values()))


def noise_meanings(kernel: str, graph: Graph) -> dict[str, sp.Expr]:
    """What kernels' outputs stand for: entries of the setting, and (I - K H) D (I - K H)'."""
    name = next(each for each in NOISES if kernel.startswith(kernel_of(each)))
    before = symmetric(name, 3)
    after = LOOP.rest * before * LOOP.rest.T
    places = {ij: (int(ij[0]) - 1, int(ij[1]) - 1) for ij in pairs(3)}
    known = {f"predicted_{ij}": before[place] for ij, place in places.items()}
    known |= {f"updated_{ij}": after[place] for ij, place in places.items()}
    for ij, (plus, minus) in forms.updated(NOISES[name], HERE, THERE).items():
        if minus is not None:
            known[f"updated_{ij}{SCALE}"] = plus + minus
    return {output: known[output] for output in graph["outputs"]}


NAME = "alpha-beta-gamma"
FOLDER = Path(gainproof.derive.fixed_gain.__path__[0])
FORMULAS, NOISE = FOLDER / "three_kernels.md", FOLDER / "three_noise_kernels.md"
LAST_OF_FIRST = "updated_variances_of_coordinates"
"""The kernel before those of noise."""
SYMBOLS = {"linear_coefficient": "x", "cubic_coefficient": "d", "hurwitz_determinant": "m"}


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    found: dict[str, Graph] = {}
    for name, graph in page_graphs(FORMULAS).items():
        found |= {name: graph} | (noise_graphs() if name == LAST_OF_FIRST else {})
    return found


def build() -> Subject:
    """Derive the alpha-beta-gamma filter with fixed gains."""
    made, noise = graphs(), noise_graphs()
    given = Given(
        towers=(main_tower(), noise_tower(), *curve_towers()),
        models={"fixed_gains": LOOP.model},
        slots={"": {**page_slots(LOOP, lecture_variance()), "noise_variances": noise_variances()}},
        hints={"predicted-definite": {"minors": _minors()}},
        programs=made,
        roots=curve_roots(),
        steps={
            "kernels-of-noise": [
                kernel_step(name, graph, noise_meanings(name, graph), TOWER)
                for name, graph in noise.items()
            ]
        },
    )
    page = written(NAME, given)
    others = {name: graph for name, graph in made.items() if name not in noise}
    kernels = {
        kernel.name: kernel
        for formulas, graphs in ((FORMULAS, others), (NOISE, noise))
        for kernel in page_kernels(formulas, graphs, NAME)
    }
    module = catalogue_module(NAME, page.title, (kernels[name] for name in made))
    return page_subject(NAME, page, module, made, (LECTURE.key,), LATEX, SYMBOLS)


def _minors() -> tuple[sp.Expr, ...]:
    """The leading minors of P; m^2 - m x^3 + x^6 is (m^3 + x^9)/(m + x^3)."""
    second = D * M + M * X + 2 * X**5 + X**4 + (M**3 + X**9) / (M + X**3)
    return real("predicted_11"), 4 * second / (D * M**2 * X), 64 / (D * M**2)
