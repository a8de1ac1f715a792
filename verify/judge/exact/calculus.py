"""Substitution and differentiation of expression trees."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from operator import is_

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
from gainproof.verify.judge.exact.work_limits import Undecided


def rebuilt(expr: Expr, change: Callable[[Expr, tuple[Expr, ...]], Expr | None]) -> Expr:
    """The tree with every node replaced by change(node, new parts), bottom up; None keeps it."""
    done: dict[bytes, Expr] = {}
    for node in walk(expr):
        parts = tuple([done[p.key] for p in node.parts])
        changed = change(node, parts)
        if changed is None:
            same = all(map(is_, parts, node.parts))
            changed = node if same else Expr(node.kind, node.value, parts)
        done[node.key] = changed
    return done[expr.key]


def substituted(expr: Expr, values: Mapping[str, Expr]) -> Expr:
    """Symbols replaced by expressions, all at once."""

    def change(node: Expr, _: tuple[Expr, ...]) -> Expr | None:
        return values.get(node.name) if node.kind == "symbol" else None

    return rebuilt(expr, change)


def differentiated(expr: Expr, name: str) -> Expr:
    """Partial derivative with respect to a symbol. Raises Undecided for unknown functions.

    It may lack a value where the function has a derivative, as that of |x| - |x| does at 0, and it
    may have one beyond the domain of the function.
    """
    # None: the derivative is zero because the symbol does not occur
    slope: dict[bytes, Expr | None] = {}
    expr = _powers_in_one(expr)
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
        case "mul" if (bent := _times_own_size(node, inner)) is not None:
            return bent
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
            if exponent == 0:
                return None  # x^0 is 1 for every x
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


def _times_own_size(node: Expr, inner: list[Expr | None]) -> Expr | None:
    """The derivative of u^m |u|^n times the rest: (m + n) u^(m-1) |u|^n u' times the rest, and so
    on. The product rule has no value where u = 0, where u |u| has a slope. None for other products.
    """
    for place, size in enumerate(node.parts):
        u = _inside_size(size)
        twin = None if u is None else next(_powers_of(u, node.parts), None)
        if twin is None or inner[twin] is None:
            continue
        m = node.parts[twin].fraction if node.parts[twin] != u else Fraction(1)
        rest = [k for k in range(len(node.parts)) if k not in (place, twin)]
        others = [node.parts[k] for k in rest]
        times = number((m + 2 * size.fraction) / m)
        terms = [mul(times, size, _known(inner[twin]), *others)]
        for k in rest:
            if inner[k] is not None:
                kept = [p for n, p in enumerate(node.parts) if n != k]
                terms.append(mul(_known(inner[k]), *kept))
        return add(*terms)
    return None


def _powers_of(u: Expr, parts: tuple[Expr, ...]) -> Iterator[int]:
    """Places of u, or of u to a whole positive power."""
    for place, part in enumerate(parts):
        is_power = part.kind == "pow" and part.parts[0] == u
        if part == u or (is_power and part.fraction > 0 and part.fraction.denominator == 1):
            yield place


def _powers_in_one(expr: Expr) -> Expr:
    """Powers of powers as one, and products of powers of one base, whose slope may have a value
    where the base is zero: y^2 for (y^4)^(1/2), (u^2)^(n/2) for |u|^n, x^(3/2) for x x^(1/2).
    """

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        if node.kind == "mul":
            return _of_one_base(parts)
        if node.kind != "pow" or node.fraction <= 0 or parts[0].kind != "pow":
            return None
        u, inner = parts[0].parts[0], parts[0].fraction
        total = inner * node.fraction
        if node.fraction.denominator == 1:
            # |u|^n with a whole n >= 2
            is_size = node.fraction > 1 and _inside_size(parts[0]) is not None
            return power(u, total) if is_size else None
        if inner.denominator != 1 or inner < 2:
            return None
        odd = inner.numerator % 2 or node.fraction.denominator % 2
        if odd or (total.denominator == 1 and total % 2 == 0):
            # a root of even order of an odd power asks for u >= 0, and that of u^total still does
            return u if total == 1 else power(u, total)
        return None if inner == 2 else power(power(u, 2), total / 2)

    return rebuilt(expr, change)


def _of_one_base(factors: tuple[Expr, ...]) -> Expr | None:
    """A product with the roots of a base and its other powers as one, if that asks for the same
    sign of the base; None if there is nothing to bring together.
    """
    for root in factors:
        if root.kind != "pow" or root.fraction <= 0 or root.fraction.denominator == 1:
            continue
        base = root.parts[0]
        exponents = {k: _exponent(f, base) for k, f in enumerate(factors)}
        own = {k: e for k, e in exponents.items() if e is not None and e > 0}
        total = sum(own.values(), Fraction(0))
        even = any(e.denominator % 2 == 0 for e in own.values())
        if len(own) > 1 and (total.denominator % 2 == 0 or not even):
            rest = [f for k, f in enumerate(factors) if k not in own]
            return mul(base if total == 1 else power(base, total), *rest)
    return None


def _exponent(factor: Expr, base: Expr) -> Fraction | None:
    """Of a power of the base; None for anything else."""
    if factor == base:
        return Fraction(1)
    return factor.fraction if factor.kind == "pow" and factor.parts[0] == base else None


def _inside_size(expr: Expr) -> Expr | None:
    """Of u where it is a power of |u|, written as a root of a power of u^2; else None."""
    if expr.kind != "pow" or expr.fraction <= 0 or expr.fraction.denominator % 2:
        return None
    square = expr.parts[0]
    return square.parts[0] if square.kind == "pow" and square.fraction == 2 else None


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
