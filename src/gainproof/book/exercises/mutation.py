"""A formula with one slip in it: a sign, a factor, an exponent, an index, two things exchanged.

Whether what comes is false is not known here; `refutation` decides it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, mul, neg, number, power, symbol, walk

LARGEST = 40
"""Parts of a formula that are tried: a slip in a longer one is found by nobody."""


@dataclass(frozen=True)
class Mutant:
    """A formula with a slip: its kind in words, and what it was done to, for the key."""

    slip: str
    formula: Expr


def mutants(formula: Expr, others: Sequence[str]) -> list[Mutant]:
    """All slips of one part of a formula; none if it is longer than `LARGEST`.

    `others`: names that the derivation has, of which one may be mistaken for another where they
    differ in digits only.
    """
    places = list(_places(formula))
    if len(places) > LARGEST:
        return []
    found = [
        Mutant(slip, _put(formula, path, part))
        for path, node in places
        for slip, part in _slips(node, others)
    ]
    found += [Mutant("two symbols exchanged", changed) for changed in _exchanged(formula)]
    return [mutant for mutant in found if mutant.formula != formula]


def _places(node: Expr, path: tuple[int, ...] = ()) -> Iterator[tuple[tuple[int, ...], Expr]]:
    """Every occurrence of a part, however often it is shared."""
    yield path, node
    for number_of_part, part in enumerate(node.parts):
        yield from _places(part, (*path, number_of_part))


def _put(node: Expr, path: Sequence[int], part: Expr) -> Expr:
    """The tree with another part at one occurrence."""
    if not path:
        return part
    parts = list(node.parts)
    parts[path[0]] = _put(parts[path[0]], path[1:], part)
    return Expr(node.kind, node.value, tuple(parts))


def _slips(node: Expr, others: Sequence[str]) -> Iterator[tuple[str, Expr]]:
    match node.kind:
        case "add":
            for place, term in enumerate(node.parts):
                yield "the sign of a term", _put(node, [place], _opposite(term))
        case "number" if node.fraction not in (0, 1, -1):
            value = node.fraction
            yield "a factor of two", number(2 * value)
            yield "a factor of two", number(value / 2)
            yield "a number", number(value + (1 if value > 0 else -1))
        case "pow":
            exponent = node.fraction
            yield "an exponent", power(node.parts[0], exponent + 1)
            if exponent == Fraction(1, 2):
                yield "an exponent", node.parts[0]
            elif exponent not in (1, 0):
                yield "an exponent", power(node.parts[0], exponent - 1)
        case "symbol":
            yield "an exponent", power(node, 2)
            for name in others:
                if name != node.name and _stem(name) == _stem(node.name):
                    yield "an index", symbol(name)
        case "div":
            top, bottom = node.parts
            yield "numerator and denominator exchanged", Expr("div", None, (bottom, top))
        case "mul" if not any(part.kind == "matrix" for part in node.parts):
            yield "a factor of two", mul(number(2), *node.parts)
            for place in range(len(node.parts)):
                rest = [part for other, part in enumerate(node.parts) if other != place]
                yield "a factor that is lost", mul(*rest)


def _opposite(term: Expr) -> Expr:
    """A term with the other sign, written as people write it."""
    match term.kind:
        case "neg":
            return term.parts[0]
        case "number":
            return number(-term.fraction)
        case "mul" if term.parts[0].kind == "number":
            return mul(number(-term.parts[0].fraction), *term.parts[1:])
        case _:
            return neg(term)


def _stem(name: str) -> str:
    """A name without its indices; one without indices is like no other."""
    stem = re.sub(r"\d+$", "", name)
    return stem if stem != name else f"{name}!"


def _exchanged(formula: Expr) -> Iterator[Expr]:
    """Two symbols in each other's place throughout."""
    names = sorted({node.name for node in walk(formula) if node.kind == "symbol"})
    for place, first in enumerate(names):
        for second in names[place + 1 :]:
            yield substituted(formula, {first: symbol(second), second: symbol(first)})
