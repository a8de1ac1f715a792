"""The judge's steady state of three states, in the parameter of a derivation's tower.

The judge's own parameter is told from names of the tower: a guess, accepted where the judge's index
is the tower's index for every value of its parameter. Each positive index belongs to one value of
the judge's parameter, so that no other value is meant.
"""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import Expr, number, symbol
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.setting.environment import INDEX
from gainproof.verify.judge.setting.three_states import RATIO, SHARE


def in_tower(
    known: Mapping[str, Expr],
    parameter: str,
    values: Mapping[str, Expr],
    name: str | None,
    boxes: Mapping[str, Box],
) -> dict[str, Expr]:
    """The quantities in terms of the tower's parameter. Raises Undecided."""
    if name == parameter:
        return dict(known)
    own, told, inside = _guess(known, parameter, values)
    moved = {q: rebuilt(e, lambda n, _: told if n == own else None) for q, e in known.items()}
    same = Rel("=", moved[INDEX], values[INDEX])
    if decide(Statement((*inside, same)), boxes, name).verdict != "proved":
        raise Undecided(f"the tracking index of the tower is no function of {parameter}")
    return moved


def _guess(
    known: Mapping[str, Expr], parameter: str, values: Mapping[str, Expr]
) -> tuple[Expr, Expr, list[Rel]]:
    """What is replaced by what, and where that must lie."""
    if parameter == SHARE and {"alpha", "beta"} <= set(values):
        a, b = values["alpha"], values["beta"]
        w = tidied(values.get("w", (2 * a - b) / (2 * a + b)))
        return symbol(SHARE), w, [Rel(">", w, number(0)), Rel("<", w, number(1))]
    if RATIO in known and {"beta", "gamma"} <= set(values):
        ratio, xi = known[RATIO], values.get("xi", 2 * values["beta"] / values["gamma"])
        least = rebuilt(ratio, lambda n, _: number(0) if n == symbol(parameter) else None)
        return ratio, xi, [Rel(">", xi, least)]
    raise Undecided(f"the tower does not tell the {parameter}")
