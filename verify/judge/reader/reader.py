"""Formulas read: text and declared symbols in, relations between expression graphs out."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import pairwise
from math import prod

from lark import Token

from gainproof.verify.judge.formula import Formula, Graph, Relation
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_AMBIGUOUS_SLASHES, MOST_READINGS
from gainproof.verify.judge.reader.grammar import parse_tokens
from gainproof.verify.judge.reader.graph_building import build_graph
from gainproof.verify.judge.reader.reading_tokens import read_tokens
from gainproof.verify.judge.reader.slash import extent_text, extents_of
from gainproof.verify.judge.reader.statements import read_relations, read_statements
from gainproof.verify.judge.reader.syntax_tree import Branch, children, sole, start, tokens
from gainproof.verify.judge.reader.vocabulary import Declared, Vocabulary

_DEFINES = ("==", ":=", "\\coloneqq", "\\triangleq", "\\equiv")
"""Signs for = that some write in a definition, a test or an identity."""
_UP, _DOWN = ("<", "<="), (">", ">=")


def read_formula(
    latex: str,
    symbols: Mapping[str, Declared],
    branch: str | None = None,
    logarithm: int | None = None,
) -> Formula:
    """One or more relations, with conditions in trailing parentheses, behind a word such as `for`,
    or joined by an arrow.

    `symbols` maps canonical tokens to their declarations; `branch` says which sign of `\\pm` is
    meant, `logarithm` the base of `\\log` where none is printed, e unless it is given: so below.
    Raises ReaderError for anything that is not read whole.
    """
    return _formula(latex, Vocabulary(symbols, branch, logarithm), plain=False)


def read_plain(text: str, symbols: Mapping[str, Declared], logarithm: int | None = None) -> Formula:
    """The same from plain text: `alpha^2/(2 - alpha) = beta`. Names are LaTeX tokens without their
    backslashes.
    """
    return _formula(text, Vocabulary(symbols, logarithm=logarithm), plain=True)


def _formula(text: str, vocabulary: Vocabulary, plain: bool) -> Formula:
    tree, names = _parse(text, vocabulary, "formula", plain)
    taken, long = readings_taken(tree, text), chains(tree, text)
    readings = tuple(
        replace(
            read_statements(tree, text, extents, vocabulary, _named(words, vocabulary.branch)),
            taken=taken,
            chains=long,
        )
        for extents, words in _choices(tree, text)
    )
    return Formula(text, readings, names)


def _named(words: str | None, branch: str | None) -> str | None:
    """What names a reading: the slashes and bars, and the signs where a branch is meant."""
    return words if branch is None else "; ".join(filter(None, (words, f"the {branch} signs")))


def read_conditions(
    text: str, symbols: Mapping[str, Declared], logarithm: int | None = None
) -> tuple[Relation, ...]:
    """Relations joined by commas or `and`, such as a domain. A slash with two readings is refused
    here.
    """
    vocabulary = Vocabulary(symbols, logarithm=logarithm)
    tree, _ = _parse(text, vocabulary, "conditions", plain=False)
    extents = extents_of(tree, text)
    if extents:
        problem = "a slash before juxtaposed factors has two readings: write \\frac in a condition"
        raise ReaderError(problem, text, min(extents), "/")
    return read_relations(children(tree)[0], text, {}, vocabulary)


def read_expression(
    text: str,
    symbols: Mapping[str, Declared],
    plain: bool = False,
    logarithm: int | None = None,
) -> tuple[Graph, ...]:
    """One expression without a relation, in LaTeX or in plain text: a graph for each reading."""
    vocabulary = Vocabulary(symbols, logarithm=logarithm)
    tree, _ = _parse(text, vocabulary, "single", plain)
    return tuple(
        build_graph(tree, text, extents, vocabulary) for extents, _ in _choices(tree, text)
    )


def _parse(
    text: str, vocabulary: Vocabulary, start: str, plain: bool
) -> tuple[Branch, tuple[str, ...]]:
    tokens = read_tokens(text, vocabulary, plain)
    names = dict.fromkeys(token.value for token in tokens if token.kind in ("SYMBOL", "FUNCTION"))
    return parse_tokens(text, tokens, start), tuple(names)


def _choices(tree: Branch, text: str) -> Iterator[tuple[dict[int, int], str | None]]:
    """Every combination of what ambiguous slashes may divide by and ambiguous bars apply to, with
    words for it.
    """
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
            words.append(under)
        yield dict(zip(places, choice, strict=True)), "; ".join(words) or None


def readings_taken(tree: Branch, text: str) -> tuple[str, ...]:
    """Clauses such as `f(x) is the product of f and x`, each once."""
    parts = sorted(tree.iter_subtrees(), key=start)
    return tuple(dict.fromkeys(words for part in parts for words in _taken(part, text)))


def chains(tree: Branch, text: str) -> tuple[str, ...]:
    """For each chain of three sides and more what it says: `a = b = c says a = b and b = c`."""
    parts = sorted(tree.iter_subtrees(), key=start)
    return tuple(_chain(part, text) for part in parts if _is_long(part))


def _taken(part: Branch, text: str) -> Iterator[str]:
    match part.data:
        case "chain":
            signs = [child for child in part.children if isinstance(child, Token)]
            shown = [text[sign.start_pos : sign.end_pos] for sign in signs]
            yield from (f"{sign} is an equation" for sign in shown if sign in _DEFINES)
            if _is_long(part) and not _is_transitive([str(sign) for sign in signs]):
                yield f"{_chain(part, text)} and nothing of other pairs"
        case "named" | "named_raised":
            (arguments,) = (child for child in children(part) if child.data == "arguments")
            inner = children(arguments)[0]
            if tokens(arguments, "ARGUMENT_OPEN") and len(inner.children) > 1:
                name = text[part.meta.start_pos : inner.meta.start_pos].rstrip()
                yield f"{_shown(part, text)} is {name}({_shown(inner, text)})"
        case "number" if (code := _shown(part, text))[-1:] in ("f", "F"):
            yield f"{code} is the number {code[:-1]}, single precision as in C"
        case "product":
            factors = children(part)
            for before, after in pairwise(factors):
                yield from _maybe_called(before, after, text)


def _maybe_called(before: Branch, after: Branch, text: str) -> Iterator[str]:
    """A symbol before another in brackets of its own, which do nothing in a product."""
    joined = before.data in ("juxtaposed", "dotted", "divided", "crossed")
    name = children(before)[-1] if joined else before
    base = children(name)[0] if name.data == "raised" else name
    group = children(after)[0] if after.data == "juxtaposed" else None
    if base.data != "symbol" or group is None or group.data != "group":
        return
    inner = sole(children(group)[0])
    if inner.data == "symbol" and tokens(group, "OPEN"):
        both = text[name.meta.start_pos : group.meta.end_pos]
        yield f"{both} is the product of {_shown(name, text)} and {_shown(inner, text)}"


def _is_long(part: Branch) -> bool:
    return part.data == "chain" and len(children(part)) > 2


def _is_transitive(signs: list[str]) -> bool:
    """Whether what a chain says of neighbours holds of all of its sides."""
    others = [sign for sign in signs if sign != "="]
    directions = (all(sign in signs for sign in others) for signs in (_UP, _DOWN))
    return len(others) < 2 or any(directions)


def _chain(part: Branch, text: str) -> str:
    sides = [_shown(side, text) for side in children(part)]
    signs = [child for child in part.children if isinstance(child, Token)]
    shown = [text[sign.start_pos : sign.end_pos] for sign in signs]
    links = [
        f"{left} {sign} {right}" for left, sign, right in zip(sides, shown, sides[1:], strict=False)
    ]
    return f"{_shown(part, text)} says {' and '.join(links)}"


def _shown(tree: Branch, text: str) -> str:
    return " ".join(text[tree.meta.start_pos : tree.meta.end_pos].split())
