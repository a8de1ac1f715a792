"""The indices at which half the sum of the pair of poles vanishes, and their distance."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Tower
from gainproof.derive.expression import real
from gainproof.derive.steady_state.towers import rational, surd
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
