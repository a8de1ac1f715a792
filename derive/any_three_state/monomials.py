"""Polynomials of a three-state tower as terms of known sign over the index and the roots."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import prod

import sympy as sp

from gainproof.derive.algebra.tower import Poly, Tower
from gainproof.derive.any_three_state.model_numbers import Shape
from gainproof.derive.any_three_state.towers import powers_of_root, roots_of
from gainproof.derive.any_two_state.domain import NoSign

Powers = tuple[int, int, int, int, int]
SAMPLES = tuple(
    tuple(Fraction(*pair) for pair in place)
    for place in (
        ((1, 3), (5, 7), (2, 1), (1, 5)),
        ((7, 2), (1, 9), (4, 3), (6, 1)),
        ((1, 40), (30, 1), (1, 17), (1, 2)),
        ((50, 1), (3, 2), (20, 1), (1, 30)),
    )
)
"""Places of the parameters where signs are looked at first: what is shown is shown apart."""


@dataclass(frozen=True)
class Term:
    """A positive number of the model times powers of the index, d0, d1, d2, d3."""

    number: sp.Expr
    powers: Powers


def terms_of(
    shape: Shape, tower: Tower, top: Poly, bottom: sp.Expr
) -> tuple[tuple[Term, ...], tuple[Term, ...]]:
    """The positive and the negative terms of top/bottom; bottom is a positive number of the model.

    A coefficient whose sign is not the same for all parameters stands in both.
    """
    found: tuple[list[Term], list[Term]] = [], []
    names = _names(shape, tower)
    for powers, part in sorted(_by_root(tower, top).items(), reverse=True):
        scale, places = names.of(powers)
        for sign, size in _signed(shape, _coefficient(tower, part)):
            number = shape.readable(shape.numbers.named(size * scale / bottom))
            found[0 if sign > 0 else 1].append(Term(number, places))
    return tuple(found[0]), tuple(found[1])


def against_others(shape: Shape, tower: Tower, top: Poly) -> int:
    """How many terms stand against the others: 0 where all coefficients have one sign, shown."""
    parts = _by_root(tower, top)
    worst = 0
    for place in SAMPLES:
        signs = [_at(part, place) > 0 for part in parts.values()]
        worst = max(worst, min(signs.count(True), signs.count(False)))
    if worst or len(tower.parameters) == 1:
        return worst
    shown = [
        sign for part in parts.values() for sign, _ in _signed(shape, _coefficient(tower, part))
    ]
    return min(shown.count(1), shown.count(-1))


Part = dict[tuple[int, ...], Fraction]


def _at(part: Part, place: tuple[Fraction, ...]) -> Fraction:
    """A coefficient where the tower's parameters have these values."""
    return sum(
        (
            value * prod((x**e for x, e in zip(place, powers, strict=False)), start=Fraction(1))
            for powers, value in part.items()
        ),
        Fraction(0),
    )


def _by_root(tower: Tower, poly: Poly) -> Mapping[tuple[int, ...], Part]:
    """The coefficients, over the tower's parameters, of the powers of all else."""
    numbers = len(tower.parameters)
    parts: dict[tuple[int, ...], Part] = {}
    for exponents, coefficient in poly.terms():
        key = (exponents[0], *exponents[numbers:])
        value = Fraction(int(coefficient.numerator), int(coefficient.denominator))
        parts.setdefault(key, {})[exponents[1:numbers]] = value
    return parts


def _coefficient(tower: Tower, part: Part) -> sp.Expr:
    names = [sp.Symbol(entry.symbol, real=True) for entry in tower.parameters[1:]]
    return sp.Add(
        *(
            sp.Rational(value.numerator, value.denominator)
            * sp.Mul(*(n**e for n, e in zip(names, powers, strict=True)))
            for powers, value in part.items()
        )
    )


def _signed(shape: Shape, coefficient: sp.Expr) -> list[tuple[int, sp.Expr]]:
    """The coefficient with its sign, as a positive number; in two parts where it has none."""
    try:
        sign = shape.numbers.sign(coefficient)
    except NoSign:
        terms = sp.Add.make_args(sp.expand(coefficient))
        up = [term for term in terms if bool(term.as_coeff_Mul()[0] > 0)]
        down = [-term for term in terms if not bool(term.as_coeff_Mul()[0] > 0)]
        return [(1, sp.Add(*up)), (-1, sp.Add(*down))]
    return [(sign, coefficient if sign > 0 else -coefficient)]


@dataclass(frozen=True)
class _Names:
    """The tower's variables beside its parameters over the index and the roots.

    For each a number, and by how much it raises the powers of the index and of d0, ..., d3.
    """

    step: int
    scales: tuple[sp.Expr, ...]
    raises: tuple[Powers, ...]

    def of(self, powers: tuple[int, ...]) -> tuple[sp.Expr, Powers]:
        """A product of the tower's variables as a number times powers."""
        of_index, rest = divmod(powers[0], self.step)
        assert rest == 0, "the spectrum holds whole powers of the index"
        scale, places = sp.Integer(1), [of_index, 0, 0, 0, 0]
        for power, own, rise in zip(powers[1:], self.scales, self.raises, strict=True):
            scale *= own**power
            places = [place + power * step for place, step in zip(places, rise, strict=True)]
        return sp.cancel(scale), (places[0], places[1], places[2], places[3], places[4])


def _names(shape: Shape, tower: Tower) -> _Names:
    step, roots = powers_of_root(shape), roots_of(shape)
    index = sp.Symbol(tower.variables[0], real=True) ** step
    scales: list[sp.Expr] = []
    raises: list[Powers] = []
    for generator in tower.generators:
        name = generator.symbol
        own = sp.Symbol(name, real=True)
        number = int(name[-1] if name in roots.known else name[1])
        if name in roots.known:  # d_k = index * root of its noise
            scales.append(index / roots.values[number].coeff(own))
        else:
            scales.append(own / roots.values[number])
        of_index = -1 if name in roots.known else 0
        raised = [of_index, *(int(k == number) for k in range(4))]
        raises.append((raised[0], raised[1], raised[2], raised[3], raised[4]))
    return _Names(step, tuple(scales), tuple(raises))
