"""Steps on when an estimate exists: property 10, the argument of (86)-(90), fewer columns."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.linear_facts import Facts
from gainproof.derive.estimation.linear_setting import (
    FEWER_M,
    GRAM,
    LINEAR,
    POSITIVE,
    SOLVABLE,
    A,
    M,
    U,
    V,
    X,
)
from gainproof.derive.estimation.spoken import meanings, together
from gainproof.derive.words.expression import ZERO, unit
from gainproof.derive.words.hypotheses import definite, equation, full_column_rank
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_equal_by_definite,
    prove_invertible,
    prove_order,
)

FULL = definite("gram")
RANK = full_column_rank("design")
KEPT = full_column_rank("kept_columns")


def solvable_steps(known: Facts) -> list[Step]:
    """A' A > 0, an inverse of A' V^-1 A, and full column rank of A are the same."""
    return [*_same(known), *_kernel(known), *_fewer(known)]


def _same(known: Facts) -> list[Step]:
    gram = prove_invertible("gram-regular", Search(LINEAR, [FULL]), "gram", FULL)
    information = prove_order(
        "full-information",
        Search(LINEAR, [POSITIVE, FULL], [known.noise_definite, gram]),
        M,
        ZERO,
        [Square(A, known.noise_definite, left_inverse=GRAM.inverse @ A.T)],
        strict=True,
    )
    regular = prove_invertible(
        "full-regular", Search(LINEAR, using=[information]), "information", information
    )
    back = prove_order(
        "gram-from-information",
        Search(LINEAR, [SOLVABLE], [known.regular]),
        GRAM,
        ZERO,
        [Square(A, ("unit", "m"), left_inverse=M.inverse @ A.T @ V.inverse)],
        strict=True,
    )
    rank = prove_order(
        "gram-from-rank",
        Search(LINEAR, [RANK]),
        A.T @ A,
        ZERO,
        [Square(A, ("unit", "m"))],
        rank=RANK,
    )
    return [
        gram.step(
            "Property 10: for `V > 0` the estimate exists if and only if `A' A > 0`, (68), and "
            "that does not ask for `V`. It does ask for `V > 0`: for `A = (1, 1)'` and the "
            "indefinite `V = diag(1, -1)`, `A' A = 2` and `A' V^-1 A = 0`.",
            "One way: `(A' A)^-1 A'` is a left inverse of `A`, so `A' V^-1 A > 0`. Back: `M^-1 A' "
            "V^-1` is one.",
            heading="When the estimate exists",
        ),
        *together([information, regular, back]),
        *meanings(LINEAR, "gram"),
        rank.step(
            "And it is the same to say that the columns of `A` are independent, its rank being "
            "their number:",
            "`x' A' A x` is the square of the length of `A x`. Back: `A x = 0` makes "
            "`x = (A' A)^-1 A' A x = 0`.",
        ),
        *together(
            [
                prove_equal(
                    "no-null-vector",
                    Search(
                        LINEAR,
                        [equation(A @ X, ZERO), FULL],
                        [gram],
                        taken=[(GRAM.inverse @ A.T, equation(A @ X, ZERO), unit("1"))],
                    ),
                    X,
                    ZERO,
                )
            ]
        ),
    ]


def _kernel(known: Facts) -> list[Step]:
    null = equation(X.T @ A.T @ V.inverse @ A @ X, ZERO)
    vanishing = prove_equal_by_definite(
        "design-vanishes",
        Search(LINEAR, [POSITIVE, null], [known.noise_symmetric, known.noise_definite]),
        A @ X,
        ZERO,
        known.noise_definite,
        "left",
    )
    gram = prove_invertible("gram-regular", Search(LINEAR, [FULL]), "gram", FULL)
    return [
        vanishing.step(
            "The argument of (86) to (90) for this: where the form of `A' V^-1 A` vanishes, so "
            "does `A x`, (87), (88), and then `x` itself, (89).",
            "`V^-1 > 0` in (87); `A' A > 0` in (88). `A' V^-1 A >= 0` is A7.",
        ),
        *together(
            [
                prove_equal(
                    "vector-vanishes",
                    Search(
                        LINEAR,
                        [POSITIVE, null, FULL],
                        [gram],
                        aside=[vanishing],
                        taken=[(GRAM.inverse @ A.T, vanishing, unit("1"))],
                    ),
                    X,
                    ZERO,
                ),
                prove_order(
                    "information-not-negative",
                    Search(LINEAR, [POSITIVE], [known.noise_definite]),
                    A.T @ V.inverse @ A,
                    ZERO,
                    [Square(A, known.noise_definite)],
                ),
            ]
        ),
    ]


def fewer_information(known: Facts) -> list[Statement]:
    """U' M U > 0, which has an inverse."""
    information = prove_order(
        "fewer-information-definite",
        Search(LINEAR, [POSITIVE, SOLVABLE, KEPT], [known.definite]),
        FEWER_M,
        ZERO,
        [Square(U, known.definite)],
        rank=KEPT,
    )
    regular = prove_invertible(
        "fewer-regular", Search(LINEAR, using=[information]), "fewer_information", information
    )
    return [information, regular]


def _fewer(known: Facts) -> list[Step]:
    information, regular = fewer_information(known)
    return [
        information.step(
            "Property 11 in general: fewer unknowns. Let the unknowns be `U a_U` with independent "
            "columns of `U`; leaving some unknowns out is a `U` of columns of the unit matrix, one "
            "bias common to all is a column of ones in the place of these. If the estimate exists "
            "with all unknowns, it does with these, (69).",
            "`A_U' V^-1 A_U = U' (A' V^-1 A) U`.",
        ),
        *together([regular]),
        *meanings(LINEAR, "fewer_information fewer_design"),
    ]
