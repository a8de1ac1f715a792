"""What is known before a claim: facts of letters, hypotheses, inverses that exist."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from fractions import Fraction

from gainproof.verify.judge.matrices.alphabet import SYMMETRIC_FACTS, Alphabet
from gainproof.verify.judge.matrices.book import Book
from gainproof.verify.judge.matrices.equation import Cofactor, Equation, Known
from gainproof.verify.judge.matrices.letter import DEFINITE, INVERTIBLE, SEMIDEFINITE, SYMMETRIC
from gainproof.verify.judge.matrices.macaulay import UnprovedError
from gainproof.verify.judge.matrices.polynomial import Polynomial

KINDS = {
    DEFINITE: "definite",
    SEMIDEFINITE: "semidefinite",
    SYMMETRIC: "symmetric",
    INVERTIBLE: "invertible",
}
Definite = Callable[[Book, int], tuple[object, ...]]
"""Proves a letter positive definite; where that is known from. Raises UnprovedError."""


def begun(alphabet: Alphabet) -> Book:
    """A book with the facts of all free letters that are spoken of, and the blocks of sizes."""
    book = Book(alphabet)
    for name, letter in alphabet.setting.letters.items():
        if not letter.facts or not alphabet.has(name):
            continue
        number = alphabet.number(name)
        facts = set(letter.facts)
        if DEFINITE in facts:
            facts -= {SEMIDEFINITE, SYMMETRIC, INVERTIBLE}
        elif SEMIDEFINITE in facts:
            facts -= {SYMMETRIC}
        for fact in sorted(facts):
            source = book.suppose({"kind": KINDS[fact], "letter": number})
            if fact in SYMMETRIC_FACTS:
                book.symmetric[number] = source
            if fact in (DEFINITE, SEMIDEFINITE):
                known = Known(source, alphabet.letter(number), fact == DEFINITE)
                book.known.append(known)
            if fact in (DEFINITE, INVERTIBLE):
                _invertible(book, number, source)
                alphabet.inverse_of(number)
    return book


def suppose_invertible(book: Book, value: Polynomial) -> None:
    """A hypothesis: the matrix has an inverse."""
    number = _letter_for(book, value)
    if number not in book.invertible:
        source = book.suppose({"kind": "invertible", "letter": number})
        _invertible(book, number, source)
    book.alphabet.inverse_of(number)


def suppose_order(book: Book, value: Polynomial, strict: bool) -> None:
    """A hypothesis: the matrix, which is symmetric then, is positive (semi)definite."""
    number = _letter_for(book, value)
    kind = "definite" if strict else "semidefinite"
    source = book.suppose({"kind": kind, "letter": number})
    book.known.append(Known(source, book.alphabet.letter(number), strict))
    if number not in book.symmetric:
        book.symmetric[number] = source
        if number not in book.alphabet.symmetric and number in book.alphabet.elements:
            book.waiting.append((number, source))
        book.alphabet.symmetric.add(number)
    if strict:
        _invertible(book, number, source)
        book.alphabet.inverse_of(number)


def suppose_equal(book: Book, value: Polynomial) -> None:
    """A hypothesis: the polynomial is 0."""
    if value.terms:
        book.pending.append(book.suppose({"equation": value}))


def _add_pending(book: Book) -> None:
    """Equations supposed, as soon as the inverses in them are known to be symmetric."""
    for source in list(book.pending):
        try:
            add_equation(book, book.equation(source))
        except UnprovedError:
            continue
        book.pending.remove(source)


def add_equation(book: Book, equation: Equation) -> None:
    """An equation and its transpose, unless they say nothing."""
    for one in (equation, book.normal(equation.transposed())):
        if one.value.terms and all(one.value.key != e.value.key for e in book.equations):
            book.equations.append(one)


def _letter_for(book: Book, value: Polynomial) -> int:
    """The letter that is the polynomial."""
    if len(value.terms) == 1:
        ((word, factor),) = value.terms.items()
        if (
            len(word) == 1
            and factor == 1
            and not word[0] % 2
            and word[0] // 2 not in book.alphabet.base
        ):
            return word[0] // 2
    return book.alphabet.short_for(value)


def _gap_of_transposes(book: Book, number: int, source: tuple[object, ...]) -> None:
    """The letter is symmetric by hypothesis: so is what it is short for."""
    alphabet = book.alphabet
    value = alphabet.elements[number]
    shape = value.shape
    one, two = alphabet.unit(shape[0]), alphabet.unit(shape[1])
    given = Cofactor(source, False, one, two)  # letter' - letter
    element = Cofactor(("element", number), False, one, two)  # letter - value
    proof = (given, element, element.transposed().negative())
    equation = Equation(value.T - value, lambda: proof)
    add_equation(book, book.normal(equation))


def _invertible(book: Book, number: int, because: tuple[object, ...]) -> None:
    """Write that a letter is invertible, for a reason that the checker knows."""
    if number in book.invertible:
        return
    name = book.alphabet.names[number]
    evidence = {"because": because}
    book.invertible[number] = f"{name}_is_invertible"
    book.state("matrix_invertible", {"matrix": name}, evidence, book.invertible[number])


def establish(
    book: Book,
    definite: Definite,
    candidates: Sequence[Polynomial] = (),
    *,
    eager: bool = False,
) -> None:
    """For every inverse that is spoken of: it exists, is symmetric if its base is, and its
    equations. `candidates` may be left inverses, likely ones where `eager`. Raises UnprovedError,
    saying what has no inverse.
    """
    alphabet = book.alphabet
    done = book.established
    while waiting := [n for n in alphabet.inverse if n not in done]:
        before, reason = len(done), UnprovedError("an inverse")
        # what has an inverse by hypothesis helps to show that others have one
        for number in sorted(
            waiting, key=lambda n: (n in alphabet.elements, n not in book.invertible)
        ):
            _add_pending(book)
            try:
                _establish_one(book, number, definite, candidates, eager)
            except UnprovedError as error:
                reason = error  # perhaps later, when others are established
            else:
                done.add(number)
        if len(done) == before:
            raise reason
    _add_pending(book)
    while book.waiting:
        _gap_of_transposes(book, *book.waiting.pop())


def _establish_one(
    book: Book, number: int, definite: Definite, candidates: Sequence[Polynomial], eager: bool
) -> None:
    alphabet = book.alphabet
    was_given = number in book.invertible
    if not was_given:
        evidence = _why_invertible(book, number, definite, candidates, eager)
        name = alphabet.names[number]
        book.invertible[number] = f"{name}_is_invertible"
        book.state("matrix_invertible", {"matrix": name}, evidence, book.invertible[number])
    _make_symmetric(book, number)
    if was_given and number in alphabet.elements:
        with suppress(UnprovedError):
            definite(book, number)
    _state_symmetric_inverse(book, number)
    _inverse_equations(book, number)
    _state_definite_inverse(book, number)


def _strengthen(book: Book, number: int) -> None:
    """D >= 0 with an inverse is D > 0: D x = 0 only for x = 0."""
    alphabet = book.alphabet
    letter = alphabet.letter(number)
    mine = [known for known in book.known if known.value.key == letter.key]
    if not mine or any(known.strict for known in mine):
        return
    inverse, unit = alphabet.letter(alphabet.inverse[number]), alphabet.unit(letter.shape[0])
    square = {"weight": [["1", [], []]], "factor": unit, "definite": mine[0].reference}
    rank = {
        "left_inverses": [[0, inverse, "middle"]],
        "cofactors": book.traced(unit - inverse @ letter)[1],
    }
    evidence = {"squares": [square], "cofactors": [], "rank": rank}
    claim = {"larger": book.graph(letter), "smaller": book.graph(letter - letter), "relation": ">"}
    name = book.state("matrix_order", claim, evidence)
    book.known[book.known.index(mine[0])] = Known(("statement", name), letter, True)


def _state_definite_inverse(book: Book, number: int) -> None:
    """Y = Y' D Y > 0 for the inverse of D > 0."""
    alphabet = book.alphabet
    letter = alphabet.letter(number)
    _strengthen(book, number)
    base = next((k for k in book.known if k.strict and k.value.key == letter.key), None)
    if base is None or alphabet.inverse[number] not in book.symmetric:
        return
    inverse = alphabet.letter(alphabet.inverse[number])
    if any(known.value.key == inverse.key for known in book.known):
        return
    unit = alphabet.unit(letter.shape[0])
    square = {"weight": [["1", [], []]], "factor": inverse, "definite": base.reference}
    rest = inverse - inverse.T @ letter @ inverse
    evidence = {
        "squares": [square],
        "cofactors": book.traced(rest)[1],
        "rank": {
            "left_inverses": [[0, letter]],
            "cofactors": book.traced(unit - letter @ inverse)[1],
        },
    }
    claim = {"larger": book.graph(inverse), "smaller": book.graph(rest - rest), "relation": ">"}
    name = book.state("matrix_order", claim, evidence)
    book.known.append(Known(("statement", name), inverse, True))


def _why_invertible(
    book: Book, number: int, definite: Definite, candidates: Sequence[Polynomial], eager: bool
) -> dict[str, object]:
    if eager:
        try:
            return _left_inverse(book, number, candidates)
        except UnprovedError:
            pass
    try:
        return {"because": definite(book, number)}
    except UnprovedError:
        return _left_inverse(book, number, candidates)


def _left_inverse(book: Book, number: int, candidates: Sequence[Polynomial]) -> dict[str, object]:
    alphabet = book.alphabet
    value = alphabet.elements.get(number)
    if value is not None and len(value.terms) == 1:
        ((word, factor),) = value.terms.items()
        if all(each // 2 in book.invertible or each // 2 in alphabet.base for each in word):
            total = alphabet.unit(value.shape[0]).times(1 / factor)
            for each in reversed(word):
                other = alphabet.letter(alphabet.inverse_of(each // 2))
                total = total @ (other.T if each % 2 else other)
            candidates = [total, *candidates]
    for left in candidates:
        if left.shape != alphabet.shapes[number] or number in _bases(book, left):
            continue
        rest = alphabet.unit(left.shape[0]) - left @ alphabet.letter(number)
        try:
            return {"left_inverse": left, "cofactors": book.vanishing(rest)}
        except UnprovedError:
            continue
    raise UnprovedError(f"that {shown(book, number)} has an inverse")


def _bases(book: Book, value: Polynomial) -> set[int]:
    return {book.alphabet.base.get(each // 2, -1) for word in value.terms for each in word}


def shown(book: Book, number: int) -> str:
    """A letter in words, or what it is short for."""
    value = book.alphabet.elements.get(number)
    if value is None:
        return book.alphabet.names[number]
    terms = list(value.terms.items())
    words = "".join(_term(" ".join(book.text(word)), factor) for word, factor in terms[:3])
    more = f" + {len(terms) - 3} more terms" if len(terms) > 3 else ""
    return words.removeprefix(" + ").removeprefix(" ") + more


def _term(word: str, factor: Fraction) -> str:
    """With its sign before it."""
    size = abs(factor)
    number = "" if size == 1 and word else f"{size} " if word else str(size)
    return f" {'-' if factor < 0 else '+'} {number}{word}"


def _make_symmetric(book: Book, number: int) -> None:
    """State that an element is symmetric, if the polynomial is."""
    alphabet = book.alphabet
    if (
        number in book.symmetric
        or number not in alphabet.symmetric
        or number not in alphabet.elements
    ):
        return
    alphabet.symmetric.discard(number)
    try:
        letter, value = alphabet.letter(number), alphabet.elements[number]
        one, two = alphabet.unit(value.shape[0]), alphabet.unit(value.shape[1])
        element = Cofactor(("element", number), False, one, two)
        gap, trace = book.traced(value.T - value)
        assert not gap.terms
        cofactors = [element.transposed(), element.negative(), *trace]
        book.symmetric[number] = _equal(book, letter.T, letter, cofactors)
    finally:
        alphabet.symmetric.add(number)


def _state_symmetric_inverse(book: Book, number: int) -> None:
    """W' = W' (1 - V W) + (W' V) W = W where V' = V."""
    alphabet = book.alphabet
    other = alphabet.inverse[number]
    if number not in book.symmetric or other in book.symmetric:
        return
    alphabet.symmetric.add(other)
    inverse, letter = alphabet.letter(other), alphabet.letter(number)
    unit = alphabet.unit(letter.shape[0])
    right: tuple[object, ...] = ("inverse", number, "right")  # V W - 1
    cofactors = [
        Cofactor(right, False, -inverse.T, unit),
        Cofactor(right, True, unit, inverse),  # W' V' - 1
        Cofactor(book.symmetric[number], False, -inverse.T, inverse),  # V' - V
    ]
    book.symmetric[other] = _equal(book, inverse.T, inverse, cofactors)


def _equal(
    book: Book, left: Polynomial, right: Polynomial, cofactors: list[Cofactor]
) -> tuple[object, ...]:
    name = book.state(
        "matrix_equal",
        {"left": book.graph(left), "right": book.graph(right)},
        {"cofactors": cofactors},
    )
    book.differences[name] = left - right
    return ("statement", name)


def _inverse_equations(book: Book, number: int) -> None:
    """Y p = 1 and p Y = 1 for the inverse of an element p, also between blocks of sizes; the
    inverse of a free letter is part of every normal form.
    """
    alphabet = book.alphabet
    if number not in alphabet.elements:
        return
    value = alphabet.elements[number]
    unit = alphabet.unit(value.shape[0])
    inverse = alphabet.letter(alphabet.inverse[number])
    sides = (
        (("inverse", number, "left"), inverse @ value - unit, (inverse, unit)),
        (("inverse", number, "right"), value @ inverse - unit, (unit, inverse)),
    )
    for source, raw, (before, after) in sides:
        proof = (
            Cofactor(source, False, unit, unit),
            Cofactor(("element", number), False, -before, after),
        )
        equation = book.normal(Equation(raw, lambda proof=proof: proof))  # type: ignore[misc]
        add_equation(book, equation)
        for block in alphabet.blocks.get(value.shape[0], ()):
            column = alphabet.letter(block)
            add_equation(book, book.normal(equation.inside(unit, column)))
            add_equation(book, book.normal(equation.inside(column.T, unit)))
