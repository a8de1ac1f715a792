"""Formulas of matrices read into trees, by descent."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from gainproof.verify.judge.matrices.lexer import Token, tokens_of
from gainproof.verify.judge.matrices.size import Sizes
from gainproof.verify.judge.matrices.size_conditions import split_bounds
from gainproof.verify.judge.matrices.tree import (
    FRACTION,
    INNER,
    REGULAR,
    Chain,
    Node,
    Statement,
    product,
    transposed,
)
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_DEPTH, MOST_ENTRIES

MOST_POWERS = 4
MOST_RAISED = 300
"""Parts of a power written out: powers of powers double with every bracket."""
_STARTS = frozenset(("name", "number", "unit", "zero", "begin", "expect", "frac", "(", "[", "{"))
_CLOSING = {"(": ")", "[": "]", "{": "}"}


def read_statement(text: str, letters: Collection[str], sizes: Sizes) -> Statement:
    """A formula with relations, arrows and conditions on sizes. Raises ReaderError."""
    formula, bounds = split_bounds(text, sizes)
    parser = _Parser(text, tokens_of(formula, letters, sizes))
    chains = parser.chains()
    connective = ""
    after: tuple[Chain, ...] = ()
    if parser.kind == "arrow":
        connective = parser.take().value
        after = parser.chains()
    parser.end()
    return Statement(chains, connective, after, bounds, text)


def read_matrix(text: str, letters: Collection[str], sizes: Sizes) -> Node:
    """One expression. Raises ReaderError."""
    parser = _Parser(text, tokens_of(text, letters, sizes))
    node = parser.sum()
    parser.end()
    return node


class _Parser:
    def __init__(self, text: str, tokens: list[Token]) -> None:
        self._text = text
        self._tokens = [*tokens, Token("end of the formula", len(text.rstrip()))]
        self._at = 0
        self._depth = 0
        self._entries = 0

    @property
    def kind(self) -> str:
        return self._tokens[self._at].kind

    def take(self) -> Token:
        token = self._tokens[self._at]
        self._at += 1
        return token

    def end(self) -> None:
        if self.kind == "unequal":
            raise self._error("\\neq is read after \\det(...) only, else =, <, <=, > and >=")
        if self.kind != "end of the formula":
            raise self._error("the formula should end here")

    def _error(self, problem: str) -> ReaderError:
        token = self._tokens[self._at]
        return ReaderError(problem, self._text, token.position, token.value or token.kind)

    def _want(self, kind: str) -> Token:
        if self.kind != kind:
            raise self._error(f"wanted {kind}, met {self.kind}")
        return self.take()

    def chains(self) -> tuple[Chain, ...]:
        found = [self._chain()]
        while self.kind == ",":
            self.take()
            found.append(self._chain())
        return tuple(found)

    def _chain(self) -> Chain:
        if self.kind == "det":
            self.take()
            if self.kind not in ("(", "["):
                raise self._error("\\det is followed by brackets")
            inner = self._bracket(self.take())
            if self.kind != "unequal":
                raise self._error("of a determinant only \\det(...) \\neq 0 is read")
            self.take()
            if self._want("number").number != 0:
                raise self._error("of a determinant only \\det(...) \\neq 0 is read")
            return Chain((inner,), (REGULAR,))
        sides, operators = [self.sum()], []
        while self.kind == "relation":
            operators.append(self.take().value)
            sides.append(self.sum())
        return Chain(tuple(sides), tuple(operators))

    def sum(self) -> Node:
        self._depth += 1
        if self._depth > MOST_DEPTH:
            raise self._error(f"more than {MOST_DEPTH} brackets inside one another")
        position = self._tokens[self._at].position
        terms = []
        sign = self.take().kind if self.kind in ("+", "-") else "+"
        while True:
            term = self._product()
            terms.append(Node("negative", (term,), position=position) if sign == "-" else term)
            if self.kind not in ("+", "-"):
                break
            sign = self.take().kind
        self._depth -= 1
        return terms[0] if len(terms) == 1 else Node("sum", tuple(terms), position=position)

    def _product(self) -> Node:
        position = self._tokens[self._at].position
        if self.kind not in _STARTS:
            raise self._error(f"a matrix is wanted, met {self.kind}")
        factors = [self._factor()]
        while self.kind in _STARTS:
            factors.append(self._factor())
        return replace(product(*factors), position=position) if len(factors) > 1 else factors[0]

    def _factor(self) -> Node:
        node = self._primary()
        powers = 0
        while self.kind == "power":
            powers += 1
            if powers > MOST_POWERS:
                raise self._error(f"more than {MOST_POWERS} powers of one matrix")
            token = self.take()
            if token.value.isdigit():
                if sum(1 for _ in node.walk()) * int(token.value) > MOST_RAISED:
                    raise self._error(f"a power of more than {MOST_RAISED} parts")
                node = Node("product", (node,) * int(token.value), position=node.position)
            if "-" in token.value:
                node = Node("inverse", (node,), position=node.position)
            if "T" in token.value:
                node = replace(transposed(node), position=node.position)
        return node

    def _primary(self) -> Node:
        token = self.take()
        place = token.position
        match token.kind:
            case "name":
                return Node("name", name=token.value, position=place)
            case "number" if token.number == 0:
                return Node("zero", position=place)
            case "number":
                return Node("number", number=token.number, position=place)
            case "unit" | "zero":
                return Node(token.kind, shape=token.shape, position=place)
            case "begin":
                return self._matrix(place)
            case "frac":
                above, below = (self._bracket(self._want("{")) for _ in range(2))
                under = Node("inverse", (below,), name=FRACTION, position=place)
                return Node("product", (above, under), position=place)
            case "expect":
                if self.kind not in ("[", "("):
                    raise self._error("E is followed by brackets")
                return Node("expectation", (self._bracket(self.take()),), position=place)
            case _:
                return self._bracket(token)

    def _bracket(self, opening: Token) -> Node:
        """One expression; (x, y), which is x^T y; or blocks side by side, wide blanks between."""
        inner = self.sum()
        place, closing = opening.position, _CLOSING[opening.kind]
        if self.kind == "," and opening.kind == "(":
            self.take()
            inner = Node("product", (Node("transpose", (inner,)), self.sum()), name=INNER)
        elif self.kind == "wide":
            cells = [inner]
            while self.kind == "wide":
                self.take()
                cells.append(self.sum())
            inner = Node("matrix", tuple(cells), size=(1, len(cells)), position=place)
        self._want(closing)
        return replace(inner, position=place)

    def _matrix(self, place: int) -> Node:
        rows: list[list[Node]] = [[]]
        while True:
            rows[-1].append(self.sum())
            self._entries += 1
            if self._entries > MOST_ENTRIES:
                raise self._error(f"more than {MOST_ENTRIES} blocks")
            if self.kind in ("&", "wide"):
                self.take()
                continue
            if self.kind == "row":
                self.take()
                if self.kind != "end":
                    rows.append([])
                    continue
            self._want("end")
            break
        width = len(rows[0])
        if any(len(row) != width for row in rows):
            raise ReaderError("rows of different lengths", self._text, place)
        cells = tuple(cell for row in rows for cell in row)
        return Node("matrix", cells, size=(len(rows), width), position=place)
