"""Proofs of chains: equations by cofactors, orders by squares, in one book."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any

from gainproof.verify.judge.matrices.cleared_inverses import cleared
from gainproof.verify.judge.matrices.consequences import draw_consequences
from gainproof.verify.judge.matrices.equation import Known
from gainproof.verify.judge.matrices.exact_instance import Unsupported
from gainproof.verify.judge.matrices.hypotheses import (
    add_equation,
    begun,
    suppose_equal,
    suppose_invertible,
    suppose_order,
    suppose_scaled,
)
from gainproof.verify.judge.matrices.ideal_membership import Budget, UnprovedError
from gainproof.verify.judge.matrices.inverse_existence import establish
from gainproof.verify.judge.matrices.inverses_from_products import suppose_product
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.letters import MatrixSetting
from gainproof.verify.judge.matrices.polynomial import Polynomial, TooLongError
from gainproof.verify.judge.matrices.proof_question import asked
from gainproof.verify.judge.matrices.semidefinite_order import prove_order, state_order, state_shown
from gainproof.verify.judge.matrices.shapes import Shapes
from gainproof.verify.judge.matrices.size import ZERO, Size
from gainproof.verify.judge.matrices.statement_letters import Alphabet
from gainproof.verify.judge.matrices.tree import Chain, Node
from gainproof.verify.judge.matrices.used_definitions import opened
from gainproof.verify.judge.matrices.word_expansion import Expander
from gainproof.verify.judge.matrices.zero_matrices import by_definite

MOST_HINTS = 40
MOST_ATOMS = 12
MOST_ROUNDS = 50
Piece = tuple[Size, Size, Size]
"""A size, the place in it where a block begins, the size of the block."""


@dataclass(frozen=True)
class Question:
    """What is to be proved: chains and inverses, with fitted shapes; `premises` first, in order.
    `claim` is the id of the claim that asks it, and makes no difference.
    """

    chains: tuple[Chain, ...]
    given: tuple[Chain, ...] = ()
    invertible: tuple[Node, ...] = ()
    hints: tuple[Node, ...] = ()
    existing: tuple[Node, ...] = ()
    premises: tuple[Question, ...] = field(default=())
    claim: str = field(default="", compare=False)

    def nodes(self) -> list[Node]:
        """Every formula in it."""
        chains = [side for chain in (*self.chains, *self.given) for side in chain.sides]
        own = [*chains, *self.invertible, *self.hints, *self.existing]
        return own + [node for premise in self.premises for node in premise.nodes()]


def proof_of(question: Question, setting: MatrixSetting, most: int, budget: Budget) -> Book:
    """A book that ends with what was asked, each equation of at most so many products. Raises
    UnprovedError, TooLongError, Unsupported.
    """
    nodes = question.nodes()
    alphabet = Alphabet(setting, cuts_of(pieces_of(nodes, setting)))
    expand = Expander(alphabet)
    for node in nodes:
        expand.of(node)
    book = begun(alphabet)
    book.most, book.budget = most, budget
    book.asked = asked(links(question.chains), alphabet, expand)
    suppose_scaled(book)
    _suppose(question, book, expand)
    candidates = [expand.of(side) for chain in question.chains for side in chain.sides]
    book.hints += _hints(question, expand)
    book.said += [expand.of(hint) for hint in question.hints]
    establish(book, definite, candidates)
    for premise in question.premises:
        _prove(premise, book, expand)
    try:
        book.goals += _prove(question, book, expand)
    except UnprovedError:
        wanted = [
            expand.of(left) - expand.of(right)
            for left, operator, right in links(question.chains)
            if operator == "="
        ]
        if not draw_consequences(book, wanted):
            raise
        book.goals += _prove(question, book, expand)
    return book


def _suppose(question: Question, book: Book, expand: Expander) -> None:
    for node in question.invertible:
        suppose_invertible(book, expand.of(node))
    for left, operator, right in links(question.given):
        one, other = expand.of(left), expand.of(right)
        if operator == "=":
            suppose_equal(book, one - other)
            for product, unit in ((left, other), (right, one)):
                if product.kind == "product" and unit.key == book.alphabet.unit(unit.shape[0]).key:
                    first, last = (replace(product, parts=p) for p in _parted(product.parts))
                    suppose_product(book, expand.of(first), expand.of(last))
        else:
            gap = one - other if operator.startswith(">") else other - one
            suppose_order(book, gap, "=" not in operator)


def _parted(parts: tuple[Node, ...]) -> tuple[tuple[Node, ...], tuple[Node, ...]]:
    return parts[:-1], parts[-1:]


def _hints(question: Question, expand: Expander) -> list[Polynomial]:
    """What was said, and every letter that is spoken of; of each polynomial one."""
    found = [expand.of(hint) for hint in question.hints]
    parts = opened(question.nodes(), expand.alphabet.setting.letters)
    names = {part.name: part for part in parts if part.kind == "name"}
    found += [expand.of(node) for node in names.values()]
    return list({(p.shape, p.key): p for p in found if p.terms}.values())[:MOST_HINTS]


def links(chains: Iterable[Chain]) -> list[tuple[Node, str, Node]]:
    """Neighbours of chains."""
    return [
        link
        for chain in chains
        for link in zip(chain.sides, chain.operators, chain.sides[1:], strict=False)
    ]


def _prove(question: Question, book: Book, expand: Expander) -> list[str]:
    """The names of the statements that say it; that an inverse exists is said of all of them."""
    names: list[str] = []
    for node in question.existing:
        value = expand.of(node)
        expand.alphabet.inverse_of(expand.alphabet.short_for(value))
        establish(book, definite)
    for left, operator, right in links(question.chains):
        one, other = expand.of(left), expand.of(right)
        if operator == "=":
            names.append(equal(book, one, other))
        else:
            larger, smaller = (one, other) if operator.startswith(">") else (other, one)
            names.append(order(book, larger, smaller, "=" not in operator))
    return names


def equal(book: Book, left: Polynomial, right: Polynomial) -> str:
    """State that both are equal, and remember it; the name of the statement."""
    residual = left - right
    claim = {"left": book.graph(left), "right": book.graph(right)}
    evidence = _between_orders(book, residual)
    if evidence is None:
        try:
            evidence = {"cofactors": cleared(book, residual, _establish_more)}
        except UnprovedError:
            evidence = by_definite(book, residual)
            if evidence is None:
                raise
    name = book.state("matrix_equal", claim, evidence)
    book.differences[name] = residual
    if residual.terms:
        add_equation(book, book.equation(("statement", name)))
    return name


def _between_orders(book: Book, residual: Polynomial) -> dict[str, Any] | None:
    """N = 0 for N that is known to be at least 0, and at most."""
    if not residual.terms:
        return None
    same = [known for known in book.known if known.value.shape == residual.shape]
    for above in same:
        for below in same:
            try:
                return {
                    "above": above.reference,
                    "below": below.reference,
                    "cofactors": book.vanishing(residual - above.value, most=0),
                    "opposite": book.vanishing(above.value + below.value, most=0),
                }
            except (UnprovedError, TooLongError):
                continue
    return None


def _establish_more(book: Book, left_inverse: Polynomial) -> None:
    establish(book, definite, [left_inverse], eager=True)


def order(
    book: Book,
    larger: Polynomial,
    smaller: Polynomial,
    strict: bool,
) -> str:
    """State that one is at least the other, or more, and remember it; the name of the statement."""
    evidence = prove_order(book, larger - smaller, strict)
    claim = {
        "larger": book.graph(larger),
        "smaller": book.graph(smaller),
        "relation": ">" if strict else ">=",
    }
    name = book.state("matrix_order", claim, evidence)
    book.known.append(Known(("statement", name), larger - smaller, strict))
    return name


__all__ = ["Question", "UnprovedError", "links", "proof_of"]


def definite(book: Book, number: int) -> tuple[object, ...]:
    """Prove a letter positive definite. Raises UnprovedError."""
    letter = book.alphabet.letter(number)
    for known in book.known:
        if known.strict and known.value.key == letter.key:
            return known.reference
    if number not in book.alphabet.symmetric:
        raise UnprovedError("it is not known to be symmetric")
    try:
        evidence = prove_order(book, letter, True)
    except UnprovedError:
        if number not in book.invertible:
            raise
        # with an inverse by hypothesis it is enough that it is at least 0
        return state_order(book, letter, strict=False).reference
    return state_shown(book, letter, True, evidence).reference


def pieces_of(nodes: Iterable[Node], setting: MatrixSetting) -> set[Piece]:
    """The blocks of all matrices in formulas and in the definitions that they use."""
    shapes = Shapes(setting.letters, setting.sizes)
    found: set[Piece] = set()
    for part in opened(nodes, setting.letters, variances=True):
        if part.kind == "matrix":
            for sizes in shapes.blocks(part):
                whole, place = sum(sizes, ZERO), ZERO
                for size in sizes:
                    if size not in (whole, ZERO):
                        found.add((whole, place, size))
                    place = place + size
    return found


def cuts_of(pieces: Iterable[Piece]) -> dict[Size, list[Size]]:
    """The sizes of the blocks of each size that is cut, the finest that any matrix wants; a block
    is not cut again. Raises Unsupported where places cannot be compared for every size.
    """
    pieces = sorted(pieces, key=str)
    places: dict[Size, set[Size]] = {}
    for whole, start, size in pieces:
        places.setdefault(whole, set()).update(p for p in (start, start + size) if inside(p, whole))
    for _ in range(MOST_ROUNDS):
        before = {size: set(found) for size, found in places.items()}
        for whole, start, size in pieces:
            within = {p - start for p in places[whole] if inside(p - start, size)}
            if within or size in places:
                places.setdefault(size, set()).update(within)
                places[whole] |= {start + p for p in places[size]}
        for whole in list(places):
            start = ZERO
            for size in _between(whole, places[whole]):
                if size != whole:
                    places[whole] |= {start + p for p in places.get(size, ())}
                start = start + size
        if places == before:
            return {size: _between(size, found) for size, found in places.items() if found}
    raise Unsupported("blocks are cut again and again")


def inside(place: Size, whole: Size) -> bool:
    """Whether a place lies between 0 and the whole, at neither."""
    if place in (ZERO, whole):
        return False
    if place.is_never_negative and (whole - place).is_never_negative:
        return True
    if place.times(-1).is_never_negative or (place - whole).is_never_negative:
        return False
    raise Unsupported(f"whether blocks of size {whole} overlap at {place} depends on the sizes")


def _between(whole: Size, places: set[Size]) -> list[Size]:
    """The sizes between neighbouring places."""
    if len(places) >= MOST_ATOMS:
        raise Unsupported(f"more than {MOST_ATOMS} blocks")
    ordered: list[Size] = []
    for place in sorted(places, key=str):
        at = 0
        while at < len(ordered) and not (ordered[at] - place).is_never_negative:
            if not (place - ordered[at]).is_never_negative:
                raise Unsupported(
                    f"which of {place} and {ordered[at]} is larger depends on the sizes"
                )
            at += 1
        ordered.insert(at, place)
    ends = [ZERO, *ordered, whole]
    return [after - before for before, after in pairwise(ends)]
