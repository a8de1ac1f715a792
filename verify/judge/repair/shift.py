"""An index moved by one, written the way one would print it: 2(k + 1) - 1 is 2k + 1."""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import Expr, number, symbol
from gainproof.verify.judge.repair.construct import opposite, product, remade, total


def shifted(expr: Expr, name: str, by: int) -> Expr:
    """The symbol replaced by itself plus a number, sums of numbers added up."""
    moved = _summed((symbol(name), number(by)))

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr:
        if node.kind == "symbol" and node.name == name:
            return moved
        return _summed(parts) if node.kind == "add" else remade(node.kind, node.value, parts)

    return rebuilt(expr, change)


def _summed(terms: tuple[Expr, ...]) -> Expr:
    constant = Fraction(0)
    rest: list[Expr] = []
    for part in (part for term in terms for part in _flat(term)):
        value = _number(part)
        if value is None:
            rest.append(part)
        else:
            constant += value
    size = number(abs(constant))
    return total(*rest, size if constant > 0 else opposite(size)) if constant else total(*rest)


def _number(term: Expr) -> Fraction | None:
    if term.kind == "number":
        return term.fraction
    inner = term.parts[0] if term.kind == "neg" else None
    return -inner.fraction if inner is not None and inner.kind == "number" else None


def _flat(term: Expr) -> tuple[Expr, ...]:
    return term.parts if term.kind == "add" else _spread(term)


def _spread(term: Expr) -> tuple[Expr, ...]:
    """A number times a sum, term by term."""
    if term.kind != "mul" or len(term.parts) != 2:
        return (term,)
    factor, inner = term.parts
    if factor.kind != "number" or inner.kind != "add":
        return (term,)
    found = []
    for part in inner.parts:
        value = _number(part)
        found.append(product(factor, part) if value is None else number(factor.fraction * value))
    return tuple(found)
