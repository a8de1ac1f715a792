"""Steps on the inverse in the order of symmetric matrices: property A4."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.order_setting import (
    D1,
    D2,
    ORDER,
)
from gainproof.derive.estimation.spoken import together
from gainproof.derive.words.expression import ZERO, symbol, unit
from gainproof.derive.words.hypotheses import (
    Hypothesis,
    definite,
    semidefinite,
)
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_invertible,
    prove_order,
)

WHOLE = unit("n")


def inverse_facts(letter: str, known: Hypothesis) -> list[Statement]:
    """The inverse of a positive definite letter: that it is, is symmetric, positive definite."""
    matrix = symbol(letter)
    regular = prove_invertible(f"{letter}-regular", Search(ORDER, [known]), letter, known)
    turned = prove_equal(
        f"{letter}-inverse-symmetric",
        Search(ORDER, [known], [regular], rounds=1),
        matrix.inverse.T,
        matrix.inverse,
    )
    positive = prove_order(
        f"{letter}-inverse-definite",
        Search(ORDER, [known], [regular, turned]),
        matrix.inverse,
        ZERO,
        [Square(matrix.inverse, known, left_inverse=matrix)],
        strict=True,
    )
    return [regular, turned, positive]


def inverse_steps() -> list[Step]:
    below, gap = definite("D2"), semidefinite("first_gap")
    above = prove_order(
        "larger-definite",
        Search(ORDER, [below, gap]),
        D1,
        ZERO,
        [Square(WHOLE, below, left_inverse=WHOLE), Square(WHOLE, gap)],
        strict=True,
    )
    facts = inverse_facts("D2", below)
    regular = prove_invertible("D1-regular", Search(ORDER, using=[above]), "D1", above)
    turned = prove_equal(
        "D1-inverse-symmetric",
        Search(ORDER, [below, gap], [regular], rounds=1),
        D1.inverse.T,
        D1.inverse,
    )
    positive = prove_order(
        "D1-inverse-definite",
        Search(ORDER, [below, gap], [above, regular, turned]),
        D1.inverse,
        ZERO,
        [Square(D1.inverse, above, left_inverse=D1)],
        strict=True,
    )
    change = D1.inverse - D2.inverse
    turned_order = prove_order(
        "inverse-order",
        Search(ORDER, [below, gap], [*facts[:2], regular, turned]),
        D2.inverse,
        D1.inverse,
        [Square(change, below), Square(D1.inverse, gap)],
    )
    return [
        above.step(
            "Property A4: the inverse turns the order. Let `D1 >= D2 > 0`; then `D1 > 0`, both "
            "have inverses, and",
            "`D2^-1 - D1^-1` is the sum of the squares of `D1^-1 - D2^-1` around `D2` and of "
            "`D1^-1` around `D1 - D2`.",
        ),
        *together([regular, turned, positive, *facts, turned_order]),
    ]
