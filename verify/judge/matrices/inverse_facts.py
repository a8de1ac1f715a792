"""What is stated of an inverse that exists: its equations, its symmetry, that it is definite."""

from __future__ import annotations

from gainproof.verify.judge.matrices.equation import Cofactor, Equation, Known
from gainproof.verify.judge.matrices.hypotheses import add_equation
from gainproof.verify.judge.matrices.known_equations import Book
from gainproof.verify.judge.matrices.polynomial import Polynomial


def known_inverse(book: Book, letter: int) -> Polynomial | None:
    """The inverse of a letter or its transpose, if it is established that there is one."""
    alphabet, number = book.alphabet, letter // 2
    if alphabet.base.get(number, number) not in book.established:
        return None
    other = alphabet.letter(alphabet.inverse_of(number))
    return other.T if letter % 2 else other


def make_symmetric(book: Book, number: int) -> None:
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


def state_symmetric_inverse(book: Book, number: int) -> None:
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


def state_definite_inverse(book: Book, number: int) -> None:
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


def inverse_equations(book: Book, number: int) -> None:
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
