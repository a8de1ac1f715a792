"""Steps on the gain that makes the updated covariance least in the order of matrices."""

from __future__ import annotations

from gainproof.derive.derivation import Step, joined
from gainproof.derive.relation import definition
from gainproof.derive.words.expression import ZERO, Expression, symbols
from gainproof.derive.words.hypotheses import definite, equation, semidefinite
from gainproof.derive.words.search import Search
from gainproof.derive.words.setting import Setting
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_equal_by_definite,
    prove_invertible,
    prove_order,
)

NAME = "update"
P, H, R, S, K, BEST, UNIT, F, Q = symbols("P H R S K best I transition Q")
SEEN, UPDATED = symbols("any_updated least_updated")


def joseph(gain: Expression) -> Expression:
    """The covariance of the update with any gain."""
    return (UNIT - gain @ H) @ P @ (UNIT - gain @ H).T + gain @ R @ gain.T


UPDATE = Setting(
    NAME,
    {
        **dict.fromkeys(("P", "any_updated", "least_updated", "transition", "Q"), "n n"),
        **dict.fromkeys(("K", "best"), "n m"),
        **dict.fromkeys(("R", "S"), "m m"),
        "H": "m n",
    },
    units={"I": "n"},
    elements={
        "S": H @ P @ H.T + R,
        "best": P @ H.T @ S.inverse,
        "any_updated": joseph(K),
        "least_updated": joseph(BEST),
    },
    inverses=("S",),
)
LATEX = {
    "R": "R",
    "any_updated": "X",
    "least_updated": "X_o",
    "transition": r"\Phi",
    "Q": "Q",
}
PRIOR, NOISE = semidefinite("P"), definite("R")


def _meaning(name: str) -> Step:
    letter = Expression("symbol", name)
    relation = definition(letter.graph, UPDATE.elements[name].graph)
    return joined(f"update-{name.replace('_', '-').lower()}", relation, NAME)


def innovation(
    setting: Setting, prior: str, noise: Expression, rows: Expression
) -> list[Statement]:
    """S > 0, S^-1 exists, and is symmetric, S being rows P rows' + noise."""
    given = [semidefinite("P"), definite(noise.value)]
    unit = setting.shape("S")[0]
    positive = prove_order(
        f"{prior}innovation-definite",
        Search(setting, given),
        S,
        ZERO,
        [
            Square(rows.T, given[0]),
            Square(Expression("unit", unit), given[1], left_inverse=Expression("unit", unit)),
        ],
        strict=True,
    )
    inverse = prove_invertible(
        f"{prior}innovation-inverse", Search(setting, given, [positive]), "S", positive
    )
    symmetric = prove_equal(
        f"{prior}inverse-symmetric",
        Search(setting, given, [inverse], rounds=1),
        S.inverse.T,
        S.inverse,
    )
    return [positive, inverse, symmetric]


def best_steps() -> list[Step]:
    """The completed square, what follows from it, and that nothing else does it."""
    given = [PRIOR, NOISE]
    known = innovation(UPDATE, "", R, H)
    positive, inverse, symmetric = known
    least = prove_order(
        "least-update",
        Search(UPDATE, given, known),
        SEEN,
        UPDATED,
        [Square((K - BEST).T, positive)],
    )
    same = equation(SEEN, UPDATED)
    return [
        positive.step(
            "Any state, any measurement `H x` with noise of covariance `R`: let `P` be the "
            "covariance of the prediction. The covariance of the innovation is positive definite, "
            "so it has an inverse:",
            "`H P H'` is a square with `P` in the middle, `R` is one with `I` around it; what is "
            "positive definite takes no vector but 0 to 0; the inverse of a symmetric matrix is.",
            heading="The least covariance of the update",
        ),
        _meaning("S"),
        inverse.step("", joins=True),
        symmetric.step("", joins=True),
        prove_equal(
            "completed-square",
            Search(UPDATE, given, known),
            SEEN,
            UPDATED + (K - BEST) @ S @ (K - BEST).T,
        ).step(
            "The covariance `X` of the update under any gain `K`, and Kalman's gain `K_o`: the "
            "first exceeds that of the second by a square.",
            "Multiply out and replace `H P H' S^-1` by `I - R S^-1`.",
        ),
        _meaning("any_updated"),
        _meaning("best"),
        _meaning("least_updated"),
        least.step(
            "So no gain has a smaller covariance in any direction, and no other gain has this "
            "one: least in the order of matrices, hence in every entry on the diagonal and in "
            "trace and determinant.",
            "The square has `S > 0` in its middle.",
        ),
        prove_equal_by_definite(
            "only-best",
            Search(UPDATE, [*given, same], known),
            K,
            BEST,
            positive,
            "right",
        ).step("", joins=True),
        prove_order(
            "least-prediction",
            Search(UPDATE, given, [*known, least]),
            F @ SEEN @ F.T + Q,
            F @ UPDATED @ F.T + Q,
            [Square(F.T, least)],
        ).step(
            "The same gain makes the next prediction least, whatever the transition `Phi` and the "
            "process noise `Q`:",
            "The difference is a square with step @least-update in its middle.",
        ),
        prove_equal(
            "short-form", Search(UPDATE, given, known), UPDATED, (UNIT - BEST @ H) @ P
        ).step(
            "With this gain the covariance has the short form, and is not above that of the "
            "prediction:",
            "Multiply out; `P - X_o` is a square with `S^-1` in its middle, which is one itself: "
            "`S^-1 = S^-1 S S^-1`.",
        ),
        *(s.step("", joins=True) for s in _not_above(known, given)),
        prove_order(
            "update-definite",
            Search(UPDATE, [definite("P"), NOISE]),
            SEEN,
            ZERO,
            [
                Square((UNIT - K @ H).T, definite("P"), left_inverse=UNIT),
                Square(K.T, NOISE, left_inverse=H.T),
            ],
            strict=True,
        ).step(
            "For any gain the update of a positive definite covariance is positive definite:",
            "Where both squares vanish, `(I - K H)' x = 0` and `K' x = 0`, so `x = 0`.",
        ),
    ]


def _not_above(known: list[Statement], given: list[dict[str, object]]) -> list[Statement]:
    positive = known[0]
    middle = prove_order(
        "inverse-definite",
        Search(UPDATE, given, known),
        S.inverse,
        ZERO,
        [Square(S.inverse, positive, left_inverse=S)],
        strict=True,
    )
    below = prove_order(
        "never-worse",
        Search(UPDATE, given, [*known, middle]),
        P,
        UPDATED,
        [Square(H @ P, middle)],
    )
    return [middle, below]
