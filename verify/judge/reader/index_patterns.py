"""What two expressions have in common that differ in one declared index."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.grammar import parse_tokens
from gainproof.verify.judge.reader.graph_nodes import arguments_of, with_arguments
from gainproof.verify.judge.reader.reading_tokens import read_tokens
from gainproof.verify.judge.reader.words import BINDERS

if TYPE_CHECKING:
    from gainproof.verify.judge.reader.graph_building import Builder


class Pattern(NamedTuple):
    """An entry that holds `index`, and the numbers of the nodes that stand for it in the first and
    in the last one.
    """

    entry: int
    symbol: str
    low: int
    high: int


def common_pattern(builder: Builder, first: int, last: int) -> Pattern | None:
    """The pattern of two nodes, or None where they differ in more than one declared index."""
    found: list[tuple[str, int, int]] = []
    entry = _unified(builder, first, last, found)
    if entry is None or len(set(found)) != 1:
        return None
    index, low, high = found[0]
    bound = builder.nodes.symbols_in(low) | builder.nodes.symbols_in(high)
    used = builder.nodes.symbols_in(first) | builder.nodes.symbols_in(last)
    if index in bound | used or not builder.vocabulary.is_integer(index):
        return None
    return Pattern(entry, index, low, high)


def _unified(
    builder: Builder, first: int, last: int, found: list[tuple[str, int, int]]
) -> int | None:
    """The node with the index in place of what differs; None if that is no index."""
    if first == last:
        return first
    one, other = builder.nodes.node(first), builder.nodes.node(last)
    if one[0] == other[0] == "symbol":
        return _unified_names(builder, str(one[1]), str(other[1]), found)
    arguments, others = arguments_of(one), arguments_of(other)
    none = [0] * len(arguments)
    if len(one) != len(other) or with_arguments(one, none) != with_arguments(other, none):
        return None
    if one[0] in ("derivative", "at") or (one[0] == "call" and one[1] in BINDERS):
        return None
    if one[0] == "call" and one[1] in builder.vocabulary and len(arguments) == 1:
        (index,) = builder.vocabulary.symbols[str(one[1])].arguments
        found.append((index, arguments[0], others[0]))
        return builder.nodes.add("call", one[1], builder.nodes.add("symbol", index))
    parts = [_unified(builder, a, b, found) for a, b in zip(arguments, others, strict=True)]
    if any(part is None for part in parts):
        return None
    return builder.nodes.add(*with_arguments(one, [part for part in parts if part is not None]))


def _unified_names(
    builder: Builder, first: str, last: str, found: list[tuple[str, int, int]]
) -> int | None:
    """The one declared name with a whole number as index from which both names are made."""
    templates = set()
    for template in builder.vocabulary.index_templates:
        low, high = template.inner(first), template.inner(last)
        if template.name not in (first, last) and low and high:
            templates.add((template.name, template.symbol, low, high))
    if len(templates) != 1:
        return None
    ((name, index, low, high),) = templates
    low_node, high_node = (_expression(builder, text) for text in (low, high))
    if low_node is None or high_node is None:
        return None
    found.append((index, low_node, high_node))
    return builder.nodes.add("symbol", name)


def _expression(builder: Builder, text: str) -> int | None:
    """The node of an index as printed, None if it is no expression over declared names."""
    if text not in builder.indices:
        try:
            tokens = read_tokens(text, builder.vocabulary)
            builder.indices[text] = builder.value(parse_tokens(text, tokens, "single"))
        except ReaderError:
            builder.indices[text] = None
    return builder.indices[text]


def instance(builder: Builder, pattern: Pattern, index: int) -> int | None:
    """The node of the pattern's entry for an index; None where no name says it."""
    return _instance(builder, pattern.entry, pattern.symbol, index)


def _instance(builder: Builder, entry: int, index: str, value: int) -> int | None:
    node = builder.nodes.node(entry)
    if node[0] == "symbol":
        if node[1] == index:
            return value
        return _named_instance(builder, str(node[1]), index, value)
    arguments = arguments_of(node)
    parts = [_instance(builder, part, index, value) for part in arguments]
    if any(part is None for part in parts):
        return None
    return builder.nodes.add(*with_arguments(node, [part for part in parts if part is not None]))


def _named_instance(builder: Builder, name: str, index: str, value: int) -> int | None:
    """The declared name that the template becomes for that index; the name itself if it has no
    such index.
    """
    templates = [
        template
        for template in builder.vocabulary.index_templates
        if (template.name, template.symbol) == (name, index)
    ]
    if not templates:
        return builder.nodes.add("symbol", name)
    for template in templates:
        for other in builder.vocabulary.symbols:
            inner = template.inner(other)
            if inner and other != name and _expression(builder, inner) == value:
                return builder.nodes.add("symbol", other)
    return None
