"""Candidates for inverses that do not exist because something is definite: of p where M p or p M is
definite, and of c + u v by the inverse of c + v u, also where p = G (c + u v).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from gainproof.verify.judge.matrices.ideal_membership import UnprovedError
from gainproof.verify.judge.matrices.inverse_facts import known_inverse
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.polynomial import Polynomial, TooLongError, reciprocal
from gainproof.verify.judge.matrices.statement_letters import Alphabet

Definite = Callable[[Book, int], tuple[object, ...]]
Form = tuple[Polynomial, Polynomial]


def speak_of_definite(book: Book, number: int, definite: Definite) -> None:
    """Ask for the inverse Y of a definite M p or p M with a definite letter M, p being what the
    letter stands for, and try Y M or M Y for that of p.
    """
    alphabet = book.alphabet
    value = alphabet.elements.get(number)
    if value is None or number in alphabet.symmetric or _is_asked(book, number):
        return
    for known in list(book.known):
        factor = known.value
        if not known.strict or len(factor.terms) != 1 or factor.shape != value.shape:
            continue
        for is_left in (True, False):
            try:
                whole = alphabet.reduced(factor @ value if is_left else value @ factor)
                if alphabet.reduced(whole.T).key != whole.key:
                    continue
                other = alphabet.short_for(whole)
                definite(book, other)
            except (UnprovedError, TooLongError):
                continue
            inverse = alphabet.letter(alphabet.inverse_of(other))
            book.products.append((number, inverse @ factor if is_left else factor @ inverse))
            return


def _is_asked(book: Book, number: int) -> bool:
    return any(own == number for own, _ in book.products)


def turned_inverses(book: Book, number: int) -> Iterator[Polynomial]:
    """(1 - u Y v) G^-1 / c for p = G (c + u v) and the inverse Y of c + v u."""
    alphabet = book.alphabet
    value = alphabet.elements.get(number)
    if value is None or value.shape[0] != value.shape[1]:
        return
    known = [
        form
        for base in sorted(book.established & alphabet.elements.keys())
        for form in _forms(
            book, alphabet.elements[base], alphabet.letter(alphabet.inverse[base]), own=False
        )
    ]
    for form, behind in _forms(book, value, alphabet.unit(value.shape[0]), own=True):
        constant = form.terms.get(())
        if constant is None:
            continue
        unit = alphabet.unit(form.shape[0])
        for u, v in _splits(alphabet, form - unit.times(constant)):
            try:
                wanted = alphabet.reduced(alphabet.unit(v.shape[0]).times(constant) + v @ u)
                for other, inverse in known:
                    if other.key == wanted.key:
                        yield (unit - u @ inverse @ v).times(reciprocal(constant)) @ behind
            except TooLongError:
                continue


def _forms(book: Book, value: Polynomial, inverse: Polynomial, *, own: bool) -> Iterator[Form]:
    """p = G f for each word G of p that has an inverse: f with its inverse Y G, given that of p;
    or, where p is the `own` one, f with G^-1.
    """
    alphabet = book.alphabet
    yield value, inverse
    for word, factor in value.terms.items():
        before = alphabet.unit(value.shape[0])
        for letter in word:
            other = known_inverse(book, letter)
            if other is None:
                break
            before = other @ before
        else:
            if word:
                whole = Polynomial({word: factor}, value.shape)
                before = before.times(reciprocal(factor))
                form = alphabet.reduced(before @ value)
                yield form, before if own else inverse @ whole


def _splits(alphabet: Alphabet, value: Polynomial) -> Iterator[tuple[Polynomial, Polynomial]]:
    """u and v with u v the value: all its words end with the word v, or begin with the word u."""
    yield from _ends(alphabet, value)
    for one, other in _ends(alphabet, value.T):
        yield other.T, one.T


def _ends(alphabet: Alphabet, value: Polynomial) -> Iterator[tuple[Polynomial, Polynomial]]:
    rows, columns = value.shape
    words = list(value.terms)
    for length in range(1, min(map(len, words), default=0) + 1):
        tail = words[0][-length:]
        if all(word[-length:] == tail for word in words):
            middle = alphabet.shapes[tail[0] // 2][tail[0] % 2]
            before = {word[:-length]: factor for word, factor in value.terms.items()}
            yield Polynomial(before, (rows, middle)), Polynomial({tail: 1}, (middle, columns))
