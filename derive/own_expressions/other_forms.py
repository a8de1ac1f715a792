"""Other forms of an expression in which less may cancel, overflow or underflow.

Of the differences of roots, sqrt(a) - sqrt(b) is (a - b)/(sqrt(a) + sqrt(b)): where a - b is a
product of few exact differences nothing cancels. A sum of fractions, such as a derivative, is one
fraction with its factors drawn apart: u/r - x (x u + y v)/r^3 is y (y u - x v)/r^3 with
r = sqrt(x^2 + y^2), whose terms are smaller; differences of two inputs stay as they are in it. What
is squared under a root is its quotient with the root, at most 1, times the root: (y/r)(y/r u -
x/r v)/r leaves no format where the whole does not. What is proved of the errors decides (see
`subject`); that nothing but the form changes is proved for each (see `written_form`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import sympy as sp

HALF = sp.Rational(1, 2)


@dataclass(frozen=True)
class Form:
    """`value`; powers of what is in `roots` are written as powers of its square root, and with
    `in_pairs` a product is divided factor by factor, so that it does not leave the format.
    """

    value: sp.Expr
    roots: frozenset[sp.Expr] = frozenset()
    in_pairs: bool = False


def forms(value: sp.Expr, roots: frozenset[sp.Expr], required: Sequence[sp.Expr]) -> Iterator[Form]:
    """The expression itself first; `roots`: what roots are taken of in it and beside it,
    `required`: what inputs fulfil together.
    """
    values, aligned = [value], _aligned(value, required)
    for found in (aligned, conjugated(aligned)):
        one = fraction(found)
        values += [found, one, by_legs(one), by_legs(found)]
    for found in dict.fromkeys(values):
        for named in dict.fromkeys((frozenset[sp.Expr](), roots)):
            for in_pairs in (False, True):
                yield Form(found, named, in_pairs)


def _aligned(value: sp.Expr, required: Sequence[sp.Expr]) -> sp.Expr:
    """With (a - b)^2 for (b - a)^2 where that stands in what is required: one number, not two."""
    squares = {each.base for other in required for each in other.atoms(sp.Pow) if each.exp.is_even}
    return value.replace(
        lambda each: (
            each.is_Pow and each.exp.is_even and each.base not in squares and -each.base in squares
        ),
        lambda each: (-each.base) ** each.exp,
    )


def rooted(value: sp.Basic) -> frozenset[sp.Expr]:
    """What square roots are taken of, odd powers included, or what is a sum of squares and divides:
    its root keeps the sizes of what is squared.
    """
    powers = [each for each in value.atoms(sp.Pow) if each.exp.is_Rational]
    return frozenset(
        each.base
        for each in powers
        if each.exp.q == 2 or (each.exp < 0 and len(_legs(each.base)) > 1)
    )


def _legs(value: sp.Expr) -> list[sp.Expr]:
    """What is squared in a sum of squares; nothing of another."""
    terms = sp.Add.make_args(value)
    legs = [term.base for term in terms if term.is_Pow and term.exp == 2]
    return legs if len(legs) == len(terms) else []


def fraction(value: sp.Expr) -> sp.Expr:
    """The expression as one quotient of products."""
    short, names = _shortened(value)
    return sp.factor(sp.together(short)).xreplace(names)


def _shortened(value: sp.Expr) -> tuple[sp.Expr, dict[sp.Expr, sp.Expr]]:
    """The expression with a symbol for each difference or sum of two inputs, and what they are."""
    names: dict[sp.Expr, sp.Expr] = {}
    known: dict[sp.Expr, sp.Expr] = {}
    for each in sorted(value.atoms(sp.Add), key=str):
        pair = [term.as_coeff_Mul() for term in each.args]
        size = abs(pair[0][0])
        if len(pair) != 2 or any(abs(c) != size or not t.is_Symbol for c, t in pair):
            continue
        pure = sp.Add(*(c / size * t for c, t in pair))
        sign, pure = (-1, -pure) if -pure in names.values() else (1, pure)
        name = next((old for old, value in names.items() if value == pure), None)
        if name is None:
            name = sp.Dummy(f"d_{len(names)}", real=True)
            names[name] = pure
        known[each] = sign * size * name
    return value.xreplace(known), names


def by_legs(value: sp.Expr) -> sp.Expr:
    """The expression with what is squared under a root as a multiple of that root."""
    short, names = _shortened(value)
    for radicand in sorted(rooted(short), key=str):
        legs = _legs(radicand)
        if len(legs) < 2 or not all(leg.is_Symbol for leg in legs):
            continue
        root, quotients = sp.Dummy("r", positive=True), [sp.Dummy(real=True) for _ in legs]
        scaled = {leg: quotient * root for leg, quotient in zip(legs, quotients, strict=True)}
        plain = short.replace(
            lambda each, base=radicand: each.is_Pow and each.base == base,
            lambda each, r=root: r ** (2 * each.exp),
        )
        if plain.free_symbols & set(legs) and root in plain.free_symbols:
            plain = sp.factor(sp.together(plain.xreplace(scaled)))
            back = {q: leg / sp.sqrt(radicand) for leg, q in zip(legs, quotients, strict=True)}
            short = plain.xreplace(back).xreplace({root: sp.sqrt(radicand)})
    return short.xreplace(names)


def conjugated(value: sp.Expr) -> sp.Expr:
    """The expression with every difference of two roots as a quotient without it."""
    if not value.args:
        return value
    found = value.func(*map(conjugated, value.args))
    return _sum(found) if isinstance(found, sp.Add) else found


def _sum(value: sp.Add) -> sp.Expr:
    """Pairs of a positive and a negative root, those first whose quotient is shortest."""
    terms = list(value.args)
    while True:
        pairs = [
            (sp.count_ops(quotient), str(quotient), quotient, one, other)
            for one, other in combinations(terms, 2)
            for quotient in [_quotient(one, other)]
            if quotient is not None
        ]
        if not pairs:
            return sp.Add(*terms)
        *_, quotient, one, other = min(pairs, key=lambda pair: pair[:2])
        terms = [term for term in terms if term not in (one, other)]
        terms.append(quotient)


def _quotient(one: sp.Expr, other: sp.Expr) -> sp.Expr | None:
    """The sum of two multiples of roots of different signs without a difference."""
    (a, root), (b, second) = one.as_coeff_Mul(), other.as_coeff_Mul()
    if not (a * b).is_negative or not all(_is_root(each) for each in (root, second)):
        return None
    above = sp.factor(sp.expand(a**2 * root**2 - b**2 * second**2))
    return sp.sign(a) * above / (abs(a) * root + abs(b) * second)


def _is_root(value: sp.Expr) -> bool:
    return isinstance(value, sp.Pow) and value.exp == HALF and not value.is_number
