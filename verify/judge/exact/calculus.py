"""Substitution and differentiation of expression trees."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    div,
    mul,
    neg,
    number,
    power,
    walk,
)
from gainproof.verify.judge.exact.functions import slope_of
from gainproof.verify.judge.exact.limits import Undecided


def rebuilt(expr: Expr, change: Callable[[Expr, tuple[Expr, ...]], Expr | None]) -> Expr:
    """The tree with every node replaced by change(node, new parts), bottom up; None keeps it."""
    done: dict[bytes, Expr] = {}
    for node in walk(expr):
        parts = tuple(done[p.key] for p in node.parts)
        changed = change(node, parts)
        if changed is None:
            same = all(a is b for a, b in zip(parts, node.parts, strict=True))
            changed = node if same else Expr(node.kind, node.value, parts)
        done[node.key] = changed
    return done[expr.key]


def substituted(expr: Expr, values: Mapping[str, Expr]) -> Expr:
    """Symbols replaced by expressions, all at once."""

    def change(node: Expr, _: tuple[Expr, ...]) -> Expr | None:
        return values.get(node.name) if node.kind == "symbol" else None

    return rebuilt(expr, change)


def differentiated(expr: Expr, name: str) -> Expr:
    """Partial derivative with respect to a symbol. Raises Undecided for unknown functions."""
    slope: dict[
        bytes, Expr | None
    ] = {}  # None: the derivative is zero because the symbol does not occur
    for node in walk(expr):
        slope[node.key] = _slope(node, [slope[p.key] for p in node.parts], name)
    found = slope[expr.key]
    return number(0) if found is None else found


def _slope(node: Expr, inner: list[Expr | None], name: str) -> Expr | None:
    if node.kind == "symbol":
        return number(1) if node.name == name else None
    if all(d is None for d in inner):
        return None
    match node.kind:
        case "add":
            return add(*[d for d in inner if d is not None])
        case "mul":
            terms = []
            for place, d in enumerate(inner):
                if d is not None:
                    others = [p for k, p in enumerate(node.parts) if k != place]
                    terms.append(mul(d, *others))
            return add(*terms)
        case "neg":
            return neg(_known(inner[0]))
        case "div":
            top, bottom = node.parts
            first = None if inner[0] is None else div(inner[0], bottom)
            second = None if inner[1] is None else neg(div(mul(top, inner[1]), power(bottom, 2)))
            return add(*[t for t in (first, second) if t is not None])
        case "pow":
            exponent = node.fraction
            base = node.parts[0]
            if exponent.denominator == 1 or exponent > 1:
                # above 1 it has a value where the base is zero, too: that of x^(3/2) is 0 at x = 0
                outer = mul(number(exponent), power(base, exponent - 1))
            else:
                # written with the root itself, so that no second root is made
                outer = div(mul(number(exponent), node), base)
            return mul(outer, _known(inner[0]))
        case "call" if (known := slope_of(node, inner)) is not None:
            return known
        case _:
            raise Undecided(f"the derivative of {node.kind} {node.value} is not known")


def _known(d: Expr | None) -> Expr:
    return number(0) if d is None else d


def roots_made_prime(expr: Expr) -> Expr:
    """Powers rewritten so that each is an integer power or a square or cube root. Raises Undecided
    otherwise.
    """

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        if node.kind != "pow" or node.fraction.denominator == 1:
            return None
        base, order = parts[0], node.fraction.denominator
        for prime in (2, 3):
            while order % prime == 0:
                base, order = power(base, Fraction(1, prime)), order // prime
        if order != 1:
            raise Undecided(f"a root of order {node.fraction.denominator} is not covered")
        top = node.fraction.numerator
        return base if top == 1 else power(base, top)

    return rebuilt(expr, change)
