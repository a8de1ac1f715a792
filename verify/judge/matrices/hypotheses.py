"""The hypotheses of a proof: facts of letters, and what the claim supposes."""

from __future__ import annotations

from gainproof.verify.judge.matrices.equation import Equation, Known
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.letters import DEFINITE, INVERTIBLE, SEMIDEFINITE, SYMMETRIC
from gainproof.verify.judge.matrices.polynomial import Polynomial
from gainproof.verify.judge.matrices.statement_letters import SYMMETRIC_FACTS, Alphabet

KINDS = {
    DEFINITE: "definite",
    SEMIDEFINITE: "semidefinite",
    SYMMETRIC: "symmetric",
    INVERTIBLE: "invertible",
}


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


def suppose_scaled(book: Book) -> None:
    """Positive numbers times definite letters and times their inverses are definite."""
    alphabet, letters = book.alphabet, book.alphabet.setting.letters
    facts = {alphabet.number(n): set(x.facts) for n, x in letters.items() if alphabet.has(n)}
    both = {DEFINITE, SEMIDEFINITE}
    for scalar in [n for n in alphabet.scalars if facts.get(n, set()) & both]:
        for number, own in list(facts.items()):
            if number in alphabet.scalars or alphabet.shapes[number] != alphabet.shapes[scalar]:
                continue
            for other in (number, alphabet.inverse.get(number)):
                if other is None or not own & both:
                    continue
                value = Polynomial({(2 * scalar, 2 * other): 1}, alphabet.shapes[number])
                suppose_order(book, value, DEFINITE in facts[scalar] & own)


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


def _invertible(book: Book, number: int, because: tuple[object, ...]) -> None:
    """Write that a letter is invertible, for a reason that the checker knows."""
    if number in book.invertible:
        return
    name = book.alphabet.names[number]
    evidence = {"because": because}
    book.invertible[number] = f"{name}_is_invertible"
    book.state("matrix_invertible", {"matrix": name}, evidence, book.invertible[number])
