"""Formulas read: text and declared symbols in, relations between expression graphs out."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from math import prod
from typing import Protocol

from lark import Token, Tree

from gainproof.verify.judge.formula import (
    INFINITY,
    MINUS_INFINITY,
    Formula,
    Graph,
    Reading,
    Relation,
)
from gainproof.verify.judge.reader.build import build_graph, children, extents_of
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.grammar import parse_tokens
from gainproof.verify.judge.reader.lexer import read_tokens
from gainproof.verify.judge.reader.limits import MOST_AMBIGUOUS_SLASHES, MOST_READINGS
from gainproof.verify.judge.reader.slash import extent_text

Branch = Tree[Token]


class Declared(Protocol):
    """What the reader asks of a declared symbol: the names of its arguments, none unless it is a
    function.
    """

    @property
    def arguments(self) -> tuple[str, ...]:
        """Names of the arguments."""
        ...


def read_formula(latex: str, symbols: Mapping[str, Declared]) -> Formula:
    """One or more relations, with conditions in trailing parentheses or joined by an arrow.

    `symbols` maps canonical tokens to their declarations. Raises ReaderError for anything that is
    not read whole.
    """
    tree, names = _parse(latex, symbols, "formula")
    readings = tuple(
        _reading(tree, latex, extents, text) for extents, text in _choices(tree, latex)
    )
    return Formula(latex, readings, names)


def read_conditions(text: str, symbols: Mapping[str, Declared]) -> tuple[Relation, ...]:
    """Relations joined by commas or `and`, such as a domain. A slash with two readings is refused
    here.
    """
    tree, _ = _parse(text, symbols, "conditions")
    extents = extents_of(tree, text)
    if extents:
        problem = "a slash before juxtaposed factors has two readings: write \\frac in a condition"
        raise ReaderError(problem, text, min(extents), "/")
    return tuple(_relations(children(tree)[0], text, {}))


def read_expression(text: str, symbols: Mapping[str, Declared]) -> tuple[Graph, ...]:
    """One expression without a relation: a graph for each reading."""
    tree, _ = _parse(text, symbols, "single")
    return tuple(build_graph(tree, text, extents) for extents, _ in _choices(tree, text))


def _parse(
    text: str, symbols: Mapping[str, Declared], start: str
) -> tuple[Branch, tuple[str, ...]]:
    tokens = read_tokens(text, {name: bool(entry.arguments) for name, entry in symbols.items()})
    names = dict.fromkeys(token.value for token in tokens if token.kind in ("SYMBOL", "FUNCTION"))
    return parse_tokens(text, tokens, start), tuple(names)


def _choices(tree: Branch, text: str) -> Iterator[tuple[dict[int, int], str | None]]:
    """Every combination of what the ambiguous slashes may divide by, with words for it."""
    extents = extents_of(tree, text)
    places = sorted(extents)
    if (
        len(places) > MOST_AMBIGUOUS_SLASHES
        or prod(len(extents[place]) for place in places) > MOST_READINGS
    ):
        problem = "too many slashes before juxtaposed factors: write \\frac or brackets"
        raise ReaderError(problem, text, places[0], "/")
    products = (
        [found for found in tree.iter_subtrees() if found.data == "product"] if places else []
    )
    for choice in itertools.product(*(extents[place] for place in places)):
        words = []
        for place, extent in zip(places, choice, strict=True):
            under = next(
                filter(None, (extent_text(product, text, place, extent) for product in products))
            )
            words.append(f"the slash of column {_column(text, place)} divides by {under}")
        yield dict(zip(places, choice, strict=True)), "; ".join(words) or None


def _column(text: str, place: int) -> int:
    return place - text.rfind("\n", 0, place)


def _reading(tree: Branch, text: str, extents: Mapping[int, int], words: str | None) -> Reading:
    first, *rest = children(tree)
    relations = tuple(_relations(first, text, extents))
    connectives = [child for child in tree.children if isinstance(child, Token)]
    conditions: list[Relation] = []
    for branch in rest:
        statements = branch if branch.data == "statements" else children(branch)[0]
        conditions += _relations(statements, text, extents)
    connective = str(connectives[0]) if connectives else "if"
    return Reading(relations, tuple(conditions), connective, words)


def _relations(statements: Branch, text: str, extents: Mapping[int, int]) -> Iterator[Relation]:
    for chain in children(statements):
        sides = children(chain)
        operators = [child for child in chain.children if isinstance(child, Token)]
        for number, operator in enumerate(operators):
            left, right = sides[number], sides[number + 1]
            inner = children(right)[0]
            if (inner.data == "infinity" and operator != "->") or children(left)[
                0
            ].data == "infinity":
                raise ReaderError(
                    "\\infty may only stand alone on the right of an arrow",
                    text,
                    operator.start_pos or 0,
                    "\\infty",
                )
            yield Relation(str(operator), _side(left, text, extents), _side(right, text, extents))


def _side(side: Branch, text: str, extents: Mapping[int, int]) -> Graph:
    (inner,) = children(side)
    if inner.data == "infinity":
        minus = any(isinstance(child, Token) and child.type == "MINUS" for child in inner.children)
        return MINUS_INFINITY if minus else INFINITY
    return build_graph(inner, text, extents)
