"""What towers are made of: parameters, generators, and the fractions over them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

Poly = Any  # sympy.polys.rings.PolyElement; SymPy ships no types for it


@dataclass(frozen=True)
class Fraction:
    """num/den, both reduced polynomials of one tower; den is not the zero polynomial."""

    num: Poly
    den: Poly


@dataclass(frozen=True)
class Parameter:
    """A real parameter: greater than `above`, or at least `start` when `above` is None."""

    symbol: str
    above: str | None = "0"
    start: str | None = None


def above_zero(*names: str) -> tuple[Parameter, ...]:
    """Parameters that are positive."""
    return tuple(Parameter(name) for name in names)


def from_zero(*names: str) -> tuple[Parameter, ...]:
    """Parameters that are not negative."""
    return tuple(Parameter(name, above=None, start="0") for name in names)


@dataclass(frozen=True)
class Generator:
    """The positive `power`-th root of `radicand`, an expression in earlier variables.

    Of a coupled pair x^2 = a + b y, y^2 = c + e x two generators follow each other, of power 2; in
    the radicand of each stands the other, its `partner`.
    """

    symbol: str
    radicand: sp.Expr
    power: int = 2
    partner: str = ""


def coupled(
    first: tuple[str, sp.Expr, sp.Expr], second: tuple[str, sp.Expr, sp.Expr]
) -> tuple[Generator, Generator]:
    """The pair of (x, a, b) and (y, c, e); all four positive or, a and c alone, 0."""
    (x, a, b), (y, c, e) = first, second
    one = Generator(x, a + b * sp.Symbol(y, real=True), partner=y)
    other = Generator(y, c + e * sp.Symbol(x, real=True), partner=x)
    return one, other
