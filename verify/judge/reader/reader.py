"""Formulas read: text and declared symbols in, relations between expression graphs out."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import replace
from math import prod

from gainproof.verify.judge.formula import Formula, Graph, Relation
from gainproof.verify.judge.reader.build import build_graph
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.grammar import parse_tokens
from gainproof.verify.judge.reader.limits import MOST_AMBIGUOUS_SLASHES, MOST_READINGS
from gainproof.verify.judge.reader.reading_tokens import read_tokens
from gainproof.verify.judge.reader.readings import chains, readings_taken
from gainproof.verify.judge.reader.slash import extent_text, extents_of
from gainproof.verify.judge.reader.statements import read_relations, read_statements
from gainproof.verify.judge.reader.tree import Branch, children
from gainproof.verify.judge.reader.vocabulary import Declared, Vocabulary


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
