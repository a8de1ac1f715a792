"""Steps on the order of symmetric matrices: properties A1 to A7 of the appendix."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation import order_inverse_steps
from gainproof.derive.estimation.order_setting import (
    D1,
    D2,
    D3,
    EIGENVALUE,
    ORDER,
    VALUES,
    VECTORS,
    D,
    F,
    U,
    X,
)
from gainproof.derive.estimation.spoken import meanings, together
from gainproof.derive.relation import cited
from gainproof.derive.source import MATRICES
from gainproof.derive.words.expression import ZERO, symbol, unit
from gainproof.derive.words.hypotheses import (
    Hypothesis,
    definite,
    equation,
    full_column_rank,
    semidefinite,
)
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal_by_orders,
    prove_order,
)

ONE = symbol("one")
WHOLE = unit("n")
UNIT_VECTOR = equation(X.T @ X, ONE)
EIGEN = equation(D @ U, EIGENVALUE * U)
LENGTH = equation(U.T @ U, ONE)


def order_steps() -> list[Step]:
    """What D >= 0 means, that it is a partial order, and what keeps and what turns it."""
    return [*_meaning(), *_partial_order(), *order_inverse_steps.inverse_steps(), *_diagonal()]


def _quadratic(name: str, known: Hypothesis) -> Statement:
    strict = known["kind"] == "definite"
    given = [known, full_column_rank("direction")] if strict else [known]
    search = Search(ORDER, given)
    if not strict:
        return prove_order(name, search, X.T @ D @ X, ZERO, [Square(X, known)])
    return prove_order(name, search, X.T @ D @ X, ZERO, [Square(X, known)], rank=given[1])


def _meaning() -> list[Step]:
    spectral = [semidefinite("eigenvalues"), equation(D, VECTORS @ VALUES @ VECTORS.T)]
    return [
        _quadratic("form-not-negative", semidefinite("D")).step(
            "Appendix. `D1 >= D2` says that `D1 - D2` is symmetric and positive semidefinite, `>` "
            "that it is positive definite. That is a statement on the quadratic form, (A.4) and "
            "(A.5); a single column has full rank if it is not 0.",
            "That is what the words mean here.",
            heading="Appendix: the order of symmetric matrices",
        ),
        *together([_quadratic("form-positive", definite("D"))]),
        prove_order(
            "eigenvalue-not-negative",
            Search(ORDER, [semidefinite("D"), EIGEN, LENGTH], taken=[(U.T, EIGEN, unit("1"))]),
            EIGENVALUE * ONE,
            ZERO,
            [Square(U, semidefinite("D"))],
        ).step(
            "Properties A1 and A2: it is the same to say that no eigenvalue is negative, or that "
            "all are positive. One way: an eigenvalue is the form at its vector of length 1. The "
            "other: `D = U Lambda U'` with the eigenvalues on the diagonal of `Lambda`.",
            "`u' D u = lambda u' u`; the form of `D` at `x` is that of `Lambda` at `U' x`.",
        ),
        *together(
            [
                prove_order(
                    "eigenvalue-positive",
                    Search(ORDER, [definite("D"), EIGEN, LENGTH], taken=[(U.T, EIGEN, unit("1"))]),
                    EIGENVALUE * ONE,
                    ZERO,
                    [Square(U, definite("D"), left_inverse=U.T)],
                    strict=True,
                ),
                prove_order(
                    "form-from-eigenvalues",
                    Search(ORDER, spectral),
                    D,
                    ZERO,
                    [Square(VECTORS.T, spectral[0])],
                ),
            ]
        ),
        Step(
            "eigenvectors",
            "Such `U` and `Lambda` exist:",
            cited(
                "A real symmetric matrix has an orthonormal basis of eigenvectors.", MATRICES.text()
            ),
            "The other way of A1 and A2 rests on this.",
            ORDER.name,
        ),
    ]


def _partial_order() -> list[Step]:
    first, second, back = (semidefinite(name) for name in ("first_gap", "second_gap", "back_gap"))
    return [
        prove_order(
            "order-transitive",
            Search(ORDER, [first, second]),
            D1,
            D3,
            [Square(WHOLE, first), Square(WHOLE, second)],
        ).step(
            "Property A3: the order is a partial one, transitive and antisymmetric:",
            "Add. For the second let `N = D1 - D2`: `x' N x = 0` for all `x`, so `2 x' N y = "
            "(x + y)' N (x + y) = 0`.",
        ),
        *meanings(ORDER, "first_gap second_gap back_gap"),
        *together(
            [
                prove_equal_by_orders(
                    "order-antisymmetric", Search(ORDER, [first, back]), D1, D2, first, back
                )
            ]
        ),
    ]


def _diagonal() -> list[Step]:
    return [
        prove_order(
            "diagonal-positive",
            Search(ORDER, [definite("D"), UNIT_VECTOR]),
            X.T @ D @ X,
            ZERO,
            [Square(X, definite("D"), left_inverse=X.T)],
            strict=True,
        ).step(
            "Properties A5 and A6: with a column of the unit matrix for `x` this is an entry on "
            "the diagonal; it is positive if `D > 0`, and not negative if `D >= 0` (step "
            "@form-not-negative). So if `D1 >= D2`, no variance of `D1` is below that of `D2`:",
            "`x' x = 1`; and step @form-not-negative for the difference.",
        ),
        *together(
            [
                prove_order(
                    "diagonal-order",
                    Search(ORDER, [semidefinite("first_gap")]),
                    X.T @ D1 @ X,
                    X.T @ D2 @ X,
                    [Square(X, semidefinite("first_gap"))],
                )
            ]
        ),
        prove_order(
            "congruence",
            Search(ORDER, [semidefinite("D")]),
            F.T @ D @ F,
            ZERO,
            [Square(F, semidefinite("D"))],
        ).step(
            "Property A7: a change of coordinates, also to fewer or more, keeps it; and what is "
            "positive definite stays so if `F` has full column rank.",
            "The form at `x` is that of `D` at `F x`.",
        ),
        *together(
            [
                prove_order(
                    "congruence-strict",
                    Search(ORDER, [definite("D"), full_column_rank("any_factor")]),
                    F.T @ D @ F,
                    ZERO,
                    [Square(F, definite("D"))],
                    rank=full_column_rank("any_factor"),
                )
            ]
        ),
    ]
