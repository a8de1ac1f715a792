"""Symbols with an index, such as x_i, x_k and x_{k-1}, as terms of one sequence.

A sum over i of x_i speaks of a sequence; what the source calls x_k is then its term number k.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gainproof.verify.judge.claim.record import SymbolEntry
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number, symbol
from gainproof.verify.judge.exact.expression_text import HOLE, TERM
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.work_limits import Undecided


@dataclass(frozen=True)
class Indexed:
    """A token without its index: `stem` has a mark in its place; the index is base + offset."""

    stem: str
    base: str | None
    offset: int

    def term(self, index: Expr) -> Expr:
        """The term of the sequence with that index."""
        return Expr("call", TERM + self.stem, (index,))


def indexed(token: str) -> Indexed | None:
    """What a token such as `x_{k-1}` is a term of; None for others."""
    head, mark, rest = token.partition("_")
    if not mark or not rest:
        return None
    inner = rest[1:-1] if rest.startswith("{") and rest.endswith("}") else rest
    for sign in ("+", "-"):
        base, found, offset = inner.partition(sign)
        if found and base and offset.isascii() and offset.isdigit():
            return Indexed(f"{head}_{HOLE}", base, int(sign + offset))
    if inner.isascii() and inner.isdigit():
        return Indexed(f"{head}_{HOLE}", None, int(inner))
    return Indexed(f"{head}_{HOLE}", inner, 0)


def terms_of(
    stems: set[str], symbols: Mapping[str, SymbolEntry], variables: Mapping[str, Expr]
) -> dict[str, Expr]:
    """Free variables of tokens that are terms of these sequences, as such terms.

    `variables` are the integer symbols that an index may be. Raises Undecided.
    """
    found: dict[str, Expr] = {}
    for token, entry in symbols.items():
        parsed = indexed(token)
        if entry.role != "free" or parsed is None or parsed.stem not in stems:
            continue
        if entry.domain or entry.variance is not None:
            raise Undecided(f"{token}, a term of a sequence with a domain or variance of its own")
        if parsed.base is None:
            found[free_name(token)] = parsed.term(number(parsed.offset))
        elif parsed.base in variables:
            base = variables[parsed.base]
            index = base + number(parsed.offset) if parsed.offset else base
            found[free_name(token)] = parsed.term(index)
    return found


def is_term(expr: Expr) -> bool:
    """Whether an expression is a term of a sequence."""
    return expr.kind == "call" and expr.name.startswith(TERM)


def with_variables(expr: Expr) -> Expr:
    """Terms with a number as index as variables."""

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        value = constant_value(parts[0]) if is_term(node) else None
        if value is None:
            return None
        return symbol(free_name(node.name.removeprefix(TERM).replace(HOLE, str(value))))

    return rebuilt(expr, change)
