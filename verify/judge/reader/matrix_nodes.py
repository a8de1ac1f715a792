"""Nodes of matrices, transposes and inverses."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from lark import Token

from gainproof.verify.judge.reader.dotted_terms import dotted_row, has_dots
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.syntax_tree import Branch, children, tokens

if TYPE_CHECKING:
    from gainproof.verify.judge.reader.graph_building import Builder


def matrix(builder: Builder, tree: Branch) -> int:
    """A matrix with as many entries in each row; `vmatrix` is its determinant."""
    rows = [children(row) for row in children(tree)]
    if has_dots([entry for row in rows for entry in row]):
        return dotted_row(builder, rows, tree)
    if len({len(row) for row in rows}) > 1:
        counts = ", ".join(str(len(row)) for row in rows)
        raise builder.error(f"rows of a matrix with {counts} entries", tree)
    entries = [builder.value(entry) for row in rows for entry in row]
    opening = tree.children[0]
    assert isinstance(opening, Token)
    round_row = opening.type == "ROW_OPEN" and opening.value == "("
    if round_row and _has_comma(builder, tree) and _all_matrices(builder, entries):
        problem = "two vectors in parentheses: an inner product or a row? write out which"
        raise builder.error(problem, tree)
    number = builder.nodes.add("matrix", len(rows), len(rows[0]), *entries)
    if opening.value == "vmatrix":
        return builder.nodes.add("call", "det", number)
    return number


def _has_comma(builder: Builder, tree: Branch) -> bool:
    """Whether the entries of a row in brackets are separated by commas."""
    return any(
        builder.text[token.start_pos or 0] == ","
        for row in children(tree)
        for token in tokens(row, "CELL")
    )


def _all_matrices(builder: Builder, entries: list[int]) -> bool:
    return len(entries) == 2 and all(map(builder.nodes.is_matrix, entries))


def kronecker(builder: Builder, numbers: Sequence[int]) -> int:
    """Kronecker products from left to right."""
    number = numbers[0]
    for other in numbers[1:]:
        number = builder.nodes.add("kronecker", number, other)
    return number


def transposed(builder: Builder, base: int, mark: Token) -> int:
    """The transpose of a matrix, or of its inverse. ReaderError for a number."""
    if not builder.nodes.is_matrix(base):
        problem = (
            "the transpose of what is not declared as a matrix: declare its shape; "
            "an exponent T is written ^{(T)}"
        )
        raise ReaderError(problem, builder.text, mark.start_pos or 0, "^T")
    if mark == "-T":
        base = builder.nodes.add("inverse", base)
    return builder.nodes.add("transpose", base)


def inverse(builder: Builder, base: int, tree: Branch) -> int:
    """The inverse of a matrix, written as a word. ReaderError for a number."""
    if not builder.nodes.is_matrix(base):
        raise builder.error("the inverse of what is not declared as a matrix: write 1/x", tree)
    return builder.nodes.add("inverse", base)
