"""The indices at which half the sum of the pair of poles vanishes, and their distance; and that at
which the pair turns real.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Tower
from gainproof.derive.expression import real
from gainproof.derive.model import ModelError
from gainproof.derive.steady_state.spectrum import V
from gainproof.derive.steady_state.towers import rational, surd
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.names import INDEX
from gainproof.derive.three_state.spectrum import Spectrum


@dataclass(frozen=True)
class Place:
    """Where an output vanishes: a root of a number, the level over it and 64/Lambda^2."""

    surd: sp.Expr
    generators: tuple[Generator, ...]
    level: sp.Expr
    square: sp.Expr
    root: sp.Expr


def numbers(spectrum: Spectrum) -> tuple[sp.Rational, sp.Rational]:
    """m1 and m2."""
    return rational(spectrum.m1), rational(spectrum.m2)


def middle(spectrum: Spectrum) -> Place:
    """Where the half sum vanishes: G^2 + (1 - m1) G + m2 = 1."""
    less = 1 - spectrum.m1
    root, names = surd(less * less + 4 * (1 - spectrum.m2))
    level = (root - rational(less)) / 2
    return _place("middle_root", root, names, level, level + 1 - rational(spectrum.m2))


def turn(spectrum: Spectrum) -> Place | None:
    """Where the discriminant vanishes: 3 G^2 + (4 - 2 m1) G = m1^2 - 4 m2."""
    m1, m2 = numbers(spectrum)
    sharp = spectrum.m1**2 - 4 * spectrum.m2
    if sharp <= 0:
        return None
    root, names = surd((2 - spectrum.m1) ** 2 + 3 * sharp)
    level = (root - 2 + m1) / 3
    square = level * (level * (level + 2 - m1) + 1 - m1 + m2)
    return _place("turning_root", root, names, level, square)


def _place(
    name: str, root: sp.Expr, names: dict[str, int], level: sp.Expr, square: sp.Expr
) -> Place:
    generators = [Generator(key, sp.Integer(number)) for key, number in names.items()]
    numbers_only = Tower("numbers", (), tuple(generators), {})
    value = numbers_only.expression(numbers_only.fraction(sp.expand(square)))
    generators.append(Generator(name, value))
    return Place(root, tuple(generators), level, value, real(name))


def places(spectrum: Spectrum) -> tuple[Place, ...]:
    """Both, or the one."""
    other = turn(spectrum)
    return (middle(spectrum),) if other is None else (middle(spectrum), other)


@dataclass(frozen=True)
class Turning:
    """The discriminant of v^3 + q noise(v), divided by q^2, as a polynomial in q = Lambda^2.

    `value`: its positive root, at which the poles turn real, over `tower`; None where it is
    negative for every q. `factor`: the polynomial over (q - value), positive.
    """

    quotient: sp.Expr
    value: sp.Expr | None
    factor: sp.Expr
    tower: Tower


def turning(c: Context) -> Turning:
    """Where the discriminant changes its sign."""
    q = sp.Symbol("q")
    polynomial = sp.Poly(sp.cancel(sp.discriminant(V**3 + q * c.spectrum.noise, V) / q**2), q)
    second, first, constant = (polynomial.coeff_monomial(q**n) for n in (2, 1, 0))
    quotient = polynomial.as_expr().subs(q, INDEX**2)
    if second <= 0 and first <= 0:
        return Turning(quotient, None, sp.Integer(1), c.tower)
    if second == 0:
        return Turning(quotient, -constant / first, first, c.tower)
    if second < 0:
        raise ModelError(
            f"model {c.model.name}: poles that turn real at one index at most are wanted, the "
            f"discriminant {polynomial.as_expr()} may change its sign twice"
        )
    outside, names = surd(Fraction(str(first**2 - 4 * second * constant)))
    generators = tuple(Generator(name, sp.Integer(number)) for name, number in names.items())
    kept = {entry.symbol for entry in c.tower.generators}
    generators = tuple(entry for entry in generators if entry.symbol not in kept)
    tower = c.tower
    if generators:
        tower = Tower(
            "turning",
            tower.parameters,
            (*generators, *tower.generators),
            tower.expressions,
        )
    value = sp.expand((-first + outside) / (2 * second))
    other = (first + outside) / (2 * second)
    return Turning(quotient, value, second * (INDEX**2 + other), tower)
