"""Towers for the two sides of `SWITCH`, and what the roots of the gains' kernels are there.

Below it Lambda = SWITCH x^2/(1 + x^2) with x > 0, from it on Lambda = SWITCH + g, g >= 0: either
side's difference of both is then positive by its looks. For e > 0 only, e = 0 has no choice.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.expression import real
from gainproof.derive.steady_state.gain_kernels import CHOICES, RAISED, SWITCH, UNIT
from gainproof.derive.steady_state.names import ALPHA, INDEX, ROOT
from gainproof.derive.steady_state.towers import (
    ROOT_16,
    ROOT_S,
    graph_roots,
    rational,
    steady_elements,
)

X, G = real("x"), real("g")
WIDE = 1 + X**2
LIMIT = rational(SWITCH)
FROM_SWITCH = Parameter("g", above=None, start="0")


@dataclass(frozen=True)
class Side:
    """One side of SWITCH: its tower, the branch that both choices take and why, and the roots."""

    tower: Tower
    branch: str
    gap: sp.Expr
    roots: dict[str, sp.Expr]

    @property
    def branches(self) -> dict[str, str]:
        """The branches of the choices by name."""
        return dict.fromkeys(CHOICES, self.branch)

    @property
    def gaps(self) -> dict[str, sp.Expr]:
        """The difference that decides each choice."""
        return dict.fromkeys(CHOICES, self.gap)


def sides(e: Fraction, n: Fraction) -> tuple[Side, ...]:
    """Below SWITCH and from there on; none for e = 0."""
    if e == 0:
        return ()
    below, above = below_tower(e, n), above_tower(e, n)
    return (
        Side(below, "then", LIMIT / WIDE, _roots(e, sp.Integer(1))),
        Side(above, "else", G, _roots(e, LIMIT / INDEX)),
    )


def range_towers(e: Fraction) -> tuple[Tower, ...]:
    """The index alone on either side, in which it is shown where it reaches."""
    if e == 0:
        return ()
    return (
        Tower("index_below", (Parameter("x"),), (), {"tracking_index": LIMIT * X**2 / WIDE}),
        Tower("index_above", (FROM_SWITCH,), (), {"tracking_index": LIMIT + G}),
    )


def below_tower(e: Fraction, n: Fraction) -> Tower:
    """The steady state where 0 < Lambda < SWITCH."""
    ratio = rational(e)
    generators = (
        Generator("y", LIMIT * WIDE),
        Generator("G", sp.expand(16 * WIDE**2 + ratio * LIMIT**2 * X**4)),
        Generator("u", sp.expand(WIDE * ((1 + ratio) * LIMIT * X**2 + 2 * real("G")))),
    )
    elements: dict[str, sp.Expr] = {
        "p": real("y") * X / WIDE,
        "H": real("G") / WIDE,
        "s": real("u") / (2 * WIDE),
    }
    elements |= steady_elements(e, n, LIMIT * X**2 / WIDE)
    return Tower("below_switch", (Parameter("x"),), generators, elements)


def above_tower(e: Fraction, n: Fraction) -> Tower:
    """The steady state where Lambda >= SWITCH."""
    ratio, index = rational(e), LIMIT + G
    generators = (
        Generator("p", index),
        Generator("H", sp.expand(16 + ratio * index**2)),
        Generator("s", sp.expand(((1 + ratio) * index + 2 * ROOT_16) / 4)),
    )
    return Tower("above_switch", (FROM_SWITCH,), generators, steady_elements(e, n, index))


def _roots(e: Fraction, scale: sp.Expr) -> dict[str, sp.Expr]:
    """Tower values of the roots of `gain_kernels`; `scale` is a over UNIT Lambda."""
    both = real("predictor_position")
    return {
        **graph_roots(e),
        "eta_scaled": UNIT * scale * ROOT_16,
        "ratio_scaled": UNIT * scale * 2 * ROOT * ROOT_S,
        **last_roots(),
        "position_raised": both * sp.Rational(RAISED, 4),
    }


def last_roots() -> dict[str, sp.Expr]:
    """The value of the root that is alpha, whatever the family."""
    return {"alpha_raised": ALPHA * sp.Rational(RAISED, 4)}
