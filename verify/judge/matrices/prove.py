"""Proofs of chains: equations by cofactors, orders by squares, in one book."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from gainproof.verify.judge.matrices.alphabet import Alphabet
from gainproof.verify.judge.matrices.book import Book, Known, UnprovedError
from gainproof.verify.judge.matrices.clearing import cleared
from gainproof.verify.judge.matrices.cuts import cuts_of, pieces_of
from gainproof.verify.judge.matrices.establish import (
    add_equation,
    begun,
    establish,
    suppose_equal,
    suppose_invertible,
    suppose_order,
)
from gainproof.verify.judge.matrices.expand import Expander
from gainproof.verify.judge.matrices.letter import MatrixSetting
from gainproof.verify.judge.matrices.order import definite, prove_order
from gainproof.verify.judge.matrices.polynomial import Polynomial
from gainproof.verify.judge.matrices.tree import Chain, Node

MOST_HINTS = 40


@dataclass(frozen=True)
class Question:
    """What is to be proved: chains and inverses, with fitted shapes; `premises` first, in order."""

    chains: tuple[Chain, ...]
    given: tuple[Chain, ...] = ()
    invertible: tuple[Node, ...] = ()
    hints: tuple[Node, ...] = ()
    existing: tuple[Node, ...] = ()
    premises: tuple[Question, ...] = field(default=())

    def nodes(self) -> list[Node]:
        """Every formula in it."""
        chains = [side for chain in (*self.chains, *self.given) for side in chain.sides]
        own = [*chains, *self.invertible, *self.hints, *self.existing]
        return own + [node for premise in self.premises for node in premise.nodes()]


def proof_of(question: Question, setting: MatrixSetting) -> Book:
    """A book that ends with what was asked. Raises UnprovedError, TooLongError, Unsupported."""
    nodes = question.nodes()
    alphabet = Alphabet(setting, cuts_of(pieces_of(nodes, setting)))
    expand = Expander(alphabet)
    for node in nodes:
        expand.of(node)
    book = begun(alphabet)
    _suppose(question, book, expand)
    candidates = [expand.of(side) for chain in question.chains for side in chain.sides]
    book.hints += _hints(question, expand)
    establish(book, definite, candidates)
    for premise in question.premises:
        _prove(premise, book, expand)
    _prove(question, book, expand)
    return book


def _suppose(question: Question, book: Book, expand: Expander) -> None:
    for node in question.invertible:
        suppose_invertible(book, expand.of(node))
    for left, operator, right in links(question.given):
        one, other = expand.of(left), expand.of(right)
        if operator == "=":
            suppose_equal(book, one - other)
        else:
            gap = one - other if operator.startswith(">") else other - one
            suppose_order(book, gap, "=" not in operator)


def _hints(question: Question, expand: Expander) -> list[Polynomial]:
    """What was said, and every letter that is spoken of; of each polynomial one."""
    found = [expand.of(hint) for hint in question.hints]
    letters = expand.alphabet.setting.letters
    waiting, seen = question.nodes(), dict[str, Node]()
    while waiting:
        for part in waiting.pop(0).walk():
            if part.kind == "name" and part.name not in seen:
                seen[part.name] = part
                definition = letters[part.name].definition
                waiting += [] if definition is None else [definition]
    found += [expand.of(node) for node in seen.values()]
    return list({(p.shape, p.key): p for p in found if p.terms}.values())[:MOST_HINTS]


def links(chains: Iterable[Chain]) -> list[tuple[Node, str, Node]]:
    """Neighbours of chains."""
    return [
        link
        for chain in chains
        for link in zip(chain.sides, chain.operators, chain.sides[1:], strict=False)
    ]


def _prove(question: Question, book: Book, expand: Expander) -> None:
    for node in question.existing:
        value = expand.of(node)
        expand.alphabet.inverse_of(expand.alphabet.short_for(value))
        establish(book, definite)
    for left, operator, right in links(question.chains):
        one, other = expand.of(left), expand.of(right)
        if operator == "=":
            equal(book, one, other)
        else:
            larger, smaller = (one, other) if operator.startswith(">") else (other, one)
            order(book, larger, smaller, "=" not in operator)


def equal(book: Book, left: Polynomial, right: Polynomial) -> None:
    """State that both are equal, and remember it."""
    residual = left - right
    cofactors = cleared(book, residual)
    claim = {"left": book.graph(left), "right": book.graph(right)}
    name = book.state("matrix_equal", claim, {"cofactors": cofactors})
    book.differences[name] = residual
    if residual.terms:
        add_equation(book, book.equation(("statement", name)))


def order(
    book: Book,
    larger: Polynomial,
    smaller: Polynomial,
    strict: bool,
) -> None:
    """State that one is at least the other, or more, and remember it."""
    evidence = prove_order(book, larger - smaller, strict)
    claim = {
        "larger": book.graph(larger),
        "smaller": book.graph(smaller),
        "relation": ">" if strict else ">=",
    }
    name = book.state("matrix_order", claim, evidence)
    book.known.append(Known(("statement", name), larger - smaller, strict))


__all__ = ["Question", "UnprovedError", "links", "proof_of"]
