"""Letters of one update of a filter, and what is known of its innovation, without a page."""

from __future__ import annotations

from gainproof.derive.words.expression import ZERO, Expression, symbols
from gainproof.derive.words.hypotheses import definite, semidefinite
from gainproof.derive.words.search import Search
from gainproof.derive.words.setting import Setting
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
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
PRIOR, NOISE = semidefinite("P"), definite("R")


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
