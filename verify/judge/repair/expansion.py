"""Printed formulas multiplied out; what is more than arithmetic is taken as it is printed."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.repair.trivial_formulas import sorted_key

Monomial = tuple[tuple[bytes, Fraction], ...]
Terms = dict[Monomial, Fraction]
"""Powers of parts as printed, each with its number; none of them 0."""
PARITY = {
    **dict.fromkeys(("cos", "sec", "cosh", "abs"), 1),
    **dict.fromkeys(("sin", "tan", "cot", "csc", "sinh", "tanh", "asin", "atan"), -1),
}
"""Functions whose value at -x is that at x times this number."""
MOST_TERMS = 64
MOST_EXPONENT = 6
WHOLE: Terms = {(): Fraction(1)}


def expanded(expr: Expr) -> Terms:
    """The terms of an expression; what grows beyond `MOST_TERMS` stays one part."""
    match expr.kind:
        case "number":
            return scaled(WHOLE, expr.fraction)
        case "neg":
            return scaled(expanded(expr.parts[0]), Fraction(-1))
        case "add":
            return added(expanded(part) for part in expr.parts)
        case "mul":
            return _product(expr, [expanded(part) for part in expr.parts])
        case "div":
            top, bottom = (expanded(part) for part in expr.parts)
            below = _inverse(bottom)
            if below is None:
                below = {((sorted_key(expr.parts[1]), Fraction(-1)),): Fraction(1)}
            return _product(expr, [top, below])
        case "pow":
            (base,), exponent = expr.parts, expr.fraction
            if exponent.denominator > 1 or abs(exponent) > MOST_EXPONENT:
                return {((sorted_key(base), exponent),): Fraction(1)}
            inner: Terms | None = expanded(base)
            if exponent < 0 and inner is not None:
                inner = _inverse(inner)
            return _one(expr) if inner is None else _product(expr, [inner] * abs(int(exponent)))
        case "call" if expr.name in PARITY:
            inner = expanded(expr.parts[0])
            turned = bool(inner) and inner[min(inner)] < 0
            shown = sorted(scaled(inner, Fraction(-1 if turned else 1)).items())
            name = f"{expr.name} {shown}".encode()
            return {((name, Fraction(1)),): Fraction(PARITY[expr.name] if turned else 1)}
        case _:
            return _one(expr)


def added(sums: Iterable[Terms]) -> Terms:
    """The sum."""
    found: Terms = {}
    for terms in sums:
        for monomial, size in terms.items():
            found[monomial] = found.get(monomial, Fraction(0)) + size
    return {monomial: size for monomial, size in found.items() if size}


def scaled(terms: Terms, by: Fraction) -> Terms:
    """The terms times a number."""
    return {monomial: size * by for monomial, size in terms.items() if by}


def _one(expr: Expr) -> Terms:
    return {((sorted_key(expr), Fraction(1)),): Fraction(1)}


def _inverse(terms: Terms) -> Terms | None:
    """One over a single term; None of others."""
    if len(terms) != 1:
        return None
    ((monomial, size),) = terms.items()
    return {tuple((base, -exponent) for base, exponent in monomial): 1 / size}


def _product(expr: Expr, factors: Iterable[Terms]) -> Terms:
    made = WHOLE
    for factor in factors:
        if len(made) * len(factor) > MOST_TERMS:
            return _one(expr)
        made = added(
            {_joined(a, b): size_a * size_b}
            for a, size_a in made.items()
            for b, size_b in factor.items()
        )
    return made


def _joined(a: Monomial, b: Monomial) -> Monomial:
    powers = dict(a)
    for base, exponent in b:
        powers[base] = powers.get(base, Fraction(0)) + exponent
    return tuple(sorted((base, exponent) for base, exponent in powers.items() if exponent))
