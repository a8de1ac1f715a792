"""How an iteration ended, in words and numbers."""

from __future__ import annotations

from gainproof.location.gauss_newton import (
    AWAY,
    CONVERGED,
    DEFICIENT,
    ENDLESS,
    MOST_HALVINGS,
    MOST_ITERATIONS,
    ON_STATION,
    STUCK,
    Iterated,
)
from gainproof.location.problem import Problem
from gainproof.location.result import Convergence

WORDS = {
    CONVERGED: "converged",
    DEFICIENT: "the linear model lost its rank",
    STUCK: f"neither a part of a step down to 2^-{MOST_HALVINGS} nor damped steps lowered the cost",
    ENDLESS: f"the steps did not become small in {MOST_ITERATIONS} iterations and damped ones",
    ON_STATION: "the target came to lie on a station",
    AWAY: "the target ran away",
}


def report(asked: Problem, iterated: Iterated, number: int, ratio: float) -> Convergence:
    """That of one start; ratio: of the singular values at its end."""
    freedom = len(asked.used.values) - asked.unknowns - asked.columns.shape[1]
    return Convergence(
        WORDS[int(iterated.ended[number])],
        int(iterated.iterations[number]),
        int(iterated.halvings[number]),
        float(iterated.step[number]),
        float(iterated.cost[number]),
        freedom,
        ratio,
    )
