"""Alpha-beta filters with any gains: what is true of all of them, and the named ones among them.

The derivation is the page `alpha-beta` of `derive/pages`; what it shares with three states, and
what the kernels compute, is made in `derive/fixed_gain`.
"""

from __future__ import annotations

from pathlib import Path

import sympy as sp

import gainproof.derive.fixed_gain
from gainproof.derive.derivation import kernel_step
from gainproof.derive.fixed_gain.loop import Loop, pairs
from gainproof.derive.fixed_gain.names import LATEX
from gainproof.derive.fixed_gain.page_slots import page_slots
from gainproof.derive.fixed_gain.process_noise import noise_shares
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.pages.kernel_formulas import SCALE
from gainproof.derive.pages.kernel_page import page_graphs, page_module
from gainproof.derive.printer.graph import Graph
from gainproof.derive.source import LECTURE
from gainproof.derive.subject import Subject, page_subject

NAME = "alpha-beta"
LOOP = Loop(2)
FORMULAS = Path(gainproof.derive.fixed_gain.__path__[0]) / "two_kernels.md"
SYMBOLS = {"linear_coefficient": "x", "quadratic_coefficient": "y"}
NOISE = "process_noise_variances"


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    return page_graphs(FORMULAS)


def noise_meanings() -> dict[str, sp.Expr]:
    """What each entry of a process noise adds to each variance, over the gains: the solved
    equation's coefficients.
    """
    shares = noise_shares(LOOP)
    alpha, beta = LOOP.gains
    below = alpha * beta * (4 - 2 * alpha - beta)
    return {
        f"updated_12_by_q_22{SCALE}": (1 - alpha) * (alpha * (2 - alpha) + beta) / below,
        **{
            f"{kind}_{ij}_by_q_{kl}": shares[kind][ij, kl]
            for kind in shares
            for ij in pairs(2)
            for kl in pairs(2)
        },
    }


def build() -> Subject:
    """Derive the alpha-beta filter with fixed gains."""
    made, meant = graphs(), noise_meanings()
    alpha, beta = LOOP.gains
    lecture = (2 * alpha**2 + 2 * beta + alpha * beta) / (alpha * (4 - 2 * alpha - beta))
    given = Given(
        models={"fixed_gains": LOOP.model},
        hints={"predicted-definite": {"minors": ()}},
        slots={"": page_slots(LOOP, lecture)},
        programs=made,
        roots={"modulus": "rho"},
        steps={
            "kernels-of-noise": [
                kernel_step(name, made[name], {x: meant[x] for x in made[name]["outputs"]})
                for name in (NOISE, f"{NOISE}_of_coordinates")
            ]
        },
    )
    page = written(NAME, given)
    module = page_module(FORMULAS, made, NAME, page.title)
    return page_subject(NAME, page, module, made, (LECTURE.key,), LATEX, SYMBOLS)
