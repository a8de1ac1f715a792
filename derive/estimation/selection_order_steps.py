"""Steps on the order of the covariances of two choices of clean ranges: (112), (113), (121)."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation import selection_steps
from gainproof.derive.estimation.selection_setting import (
    H_S,
    M_L,
    M_S,
    Q_L,
    Q_S,
    SELECTION,
    SOLVABLE,
    WEIGHT,
    P,
)
from gainproof.derive.estimation.spoken import inverse_symmetric, meanings, together
from gainproof.derive.words.expression import ZERO, unit
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_invertible,
    prove_order,
)


def order_steps() -> list[Step]:
    facts = selection_steps.facts()
    padded = selection_steps.padded_below(facts)
    larger = prove_order(
        "information-ordered",
        Search(SELECTION, [], [padded]),
        M_L,
        M_S,
        [Square(H_S.T @ P, padded)],
    )
    gap = prove_equal("information-gap", Search(SELECTION), M_L - M_S, P.T @ (Q_S - Q_L) @ P)
    return [
        gap.step(
            "(113) and (121): by (103) the inverses of the covariances are `M_S = K11 - P' Q_S P` "
            "and `M_L = K11 - P' Q_L P`; the larger choice has the larger one.",
            "(119) between `P'` and `P`: A7.",
        ),
        *meanings(SELECTION, "small_information large_information"),
        *together([larger]),
        *_covariances(facts, larger),
    ]


def _covariances(facts: list[Statement], larger: Statement) -> list[Step]:
    whole, turned = unit("k"), [facts[1], facts[2], facts[4], facts[5]]
    above = prove_order(
        "large-definite",
        Search(SELECTION, [SOLVABLE], [larger]),
        M_L,
        ZERO,
        [Square(whole, larger), Square(whole, SOLVABLE, left_inverse=whole)],
        strict=True,
    )
    small = prove_invertible(
        "small-regular", Search(SELECTION, [SOLVABLE]), "small_information", SOLVABLE
    )
    large = prove_invertible(
        "large-regular", Search(SELECTION, using=[above]), "large_information", above
    )
    given = [SOLVABLE, WEIGHT]
    gap = prove_equal(
        "gap-symmetric", Search(SELECTION, [WEIGHT], turned), (M_L - M_S).T, M_L - M_S
    )
    inverses = [
        inverse_symmetric(
            f"{name}-inverse-symmetric",
            matrix,
            regular,
            Search(SELECTION, [SOLVABLE], aside=[gap]),
            sources,
        )
        for name, matrix, regular, sources in (
            ("small", M_S, small, [SOLVABLE]),
            ("large", M_L, large, [SOLVABLE, gap]),
        )
    ]
    last = [found[-1] for found in inverses]
    left = ("inverse", small.id, "left")
    taken = [
        (-whole, left, M_S.inverse),
        (whole, left, M_L.inverse),
        (M_L.inverse, ("inverse", small.id, "right"), whole),
        (-whole, ("inverse", large.id, "left"), M_L.inverse),
    ]
    order = prove_order(
        "covariances-ordered",
        Search(SELECTION, given, [*turned, *last, larger], aside=[small, large], taken=taken),
        M_S.inverse,
        M_L.inverse,
        [Square(M_S.inverse - M_L.inverse, SOLVABLE), Square(M_L.inverse, larger)],
    )
    return [
        above.step(
            "(112), property 14: so the covariance of position and velocity from more clean "
            "ranges is not above that from fewer, and by A6 no variance on its diagonal is. It is "
            "step @fewer-unknowns for columns of the unit matrix.",
            "A4 for `M_L >= M_S > 0`.",
        ),
        *together([small, large, gap, *inverses[0], *inverses[1], order]),
    ]
