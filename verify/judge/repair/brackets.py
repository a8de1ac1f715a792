"""Brackets, fraction bars, roots and exponents that reach over more or less than they should."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.repair.edits import SLIGHT, Edit, Table
from gainproof.verify.judge.repair.tree_construction import (
    exchanged,
    opposite,
    product,
    quotient,
    raised,
    total,
    without,
)

WHAT = "a bracket"
BAR = "the reach of a fraction bar"
REACH = "the reach of an exponent or root"


def brackets(node: Expr, _: Table) -> Iterator[Edit]:
    """All regroupings at one node."""
    match node.kind:
        case "add":
            yield from _in_sum(node)
        case "mul":
            yield from _in_product(node)
        case "div":
            yield from _in_quotient(node)
        case "pow":
            yield from _in_power(node)


def _signed(term: Expr) -> tuple[bool, Expr]:
    return (True, term.parts[0]) if term.kind == "neg" else (False, term)


def _with_sign(negative: bool, x: Expr) -> Expr:
    return opposite(x) if negative else x


def _in_sum(node: Expr) -> Iterator[Edit]:
    for k in range(len(node.parts) - 1):
        a, b = node.parts[k], node.parts[k + 1]
        before, after = node.parts[:k], node.parts[k + 2 :]
        for new, what in _pair(a, b):
            yield Edit(total(*before, new, *after), SLIGHT, what)


def _pair(a: Expr, b: Expr) -> Iterator[tuple[Expr, str]]:
    """Two terms grouped otherwise: what belonged to one of them now reaches over both."""
    (minus_a, x), (minus_b, y) = _signed(a), _signed(b)
    if y.kind == "mul":
        first, *rest = y.parts
        yield product(total(a, _with_sign(minus_b, first)), *rest), WHAT
    if x.kind == "mul":
        *init, last = x.parts
        inner = total(last, _with_sign(minus_a != minus_b, y))
        yield _with_sign(minus_a, product(*init, inner)), WHAT
    if y.kind == "div":
        top, bottom = y.parts
        yield quotient(total(a, _with_sign(minus_b, top)), bottom), BAR
    if x.kind == "div":
        top, bottom = x.parts
        tail = _with_sign(minus_a != minus_b, y)
        yield _with_sign(minus_a, quotient(top, total(bottom, tail))), BAR
        yield _with_sign(minus_a, quotient(total(top, tail), bottom)), BAR
    if y.kind == "pow":
        yield raised(total(a, _with_sign(minus_b, y.parts[0])), y.fraction), REACH
    if x.kind == "pow":
        inner = total(x.parts[0], _with_sign(minus_a != minus_b, y))
        yield _with_sign(minus_a, raised(inner, x.fraction)), REACH


def _in_product(node: Expr) -> Iterator[Edit]:
    for k, factor in enumerate(node.parts):
        before, after = node.parts[:k], node.parts[k + 1 :]
        if factor.kind == "add":
            for split in range(1, len(factor.parts)):
                left, right = factor.parts[:split], factor.parts[split:]
                yield Edit(
                    total(product(*before, total(*left)), product(total(*right), *after)),
                    SLIGHT,
                    WHAT,
                )
        if factor.kind == "div":
            top, bottom = factor.parts
            for other in range(len(node.parts)):
                if other != k:
                    moved = quotient(top, product(bottom, node.parts[other]))
                    kept = without(exchanged(node.parts, k, moved), other)
                    yield Edit(product(*kept), SLIGHT, BAR)
        if factor.kind == "pow":
            for start in range(k):
                whole = product(*node.parts[start:k], factor.parts[0])
                yield Edit(
                    product(*node.parts[:start], raised(whole, factor.fraction), *after),
                    SLIGHT,
                    REACH,
                )
            if factor.fraction.denominator > 1:
                for end in range(k + 1, len(node.parts)):
                    whole = product(factor.parts[0], *node.parts[k + 1 : end + 1])
                    rest = node.parts[end + 1 :]
                    yield Edit(
                        product(*before, raised(whole, factor.fraction), *rest), SLIGHT, REACH
                    )


def _in_quotient(node: Expr) -> Iterator[Edit]:
    top, bottom = node.parts
    if top.kind == "add":
        for split in range(1, len(top.parts)):
            first, last = total(*top.parts[:split]), total(*top.parts[split:])
            yield Edit(total(first, quotient(last, bottom)), SLIGHT, BAR)
            yield Edit(total(quotient(first, bottom), last), SLIGHT, BAR)
    if bottom.kind == "add":
        for split in range(1, len(bottom.parts)):
            first, last = total(*bottom.parts[:split]), total(*bottom.parts[split:])
            yield Edit(total(quotient(top, first), last), SLIGHT, BAR)
    if bottom.kind == "mul":
        for k, factor in enumerate(bottom.parts):
            rest = product(*without(bottom.parts, k))
            yield Edit(product(quotient(top, rest), factor), SLIGHT, BAR)
    if top.kind == "pow":
        yield Edit(raised(quotient(top.parts[0], bottom), top.fraction), SLIGHT, REACH)
    if bottom.kind == "pow":
        yield Edit(raised(quotient(top, bottom.parts[0]), bottom.fraction), SLIGHT, REACH)


def _in_power(node: Expr) -> Iterator[Edit]:
    base, exponent = node.parts[0], node.fraction
    match base.kind:
        case "mul":
            for k, factor in enumerate(base.parts):
                rest = without(base.parts, k)
                yield Edit(product(*rest, raised(factor, exponent)), SLIGHT, REACH)
                yield Edit(product(factor, raised(product(*rest), exponent)), SLIGHT, REACH)
        case "div":
            top, bottom = base.parts
            yield Edit(quotient(raised(top, exponent), bottom), SLIGHT, REACH)
            yield Edit(quotient(top, raised(bottom, exponent)), SLIGHT, REACH)
        case "add":
            for split in range(1, len(base.parts)):
                left, right = total(*base.parts[:split]), total(*base.parts[split:])
                yield Edit(total(left, raised(right, exponent)), SLIGHT, REACH)
                yield Edit(total(raised(left, exponent), right), SLIGHT, REACH)
        case "pow":
            inner = base.fraction * Fraction(1)
            yield Edit(raised(base.parts[0], inner + exponent), SLIGHT, REACH)
