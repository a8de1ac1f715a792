"""Steps on the kernels of the gains, which choose by the index: both sides, which are all."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step
from gainproof.derive.relation import increasing_onto
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.gain_towers import LIMIT, WIDE, Side, X
from gainproof.derive.steady_state.names import INDEX
from gainproof.derive.steady_state.steps_proof import proof_steps


def side_steps(c: Context, sides: tuple[Side, ...]) -> list[Step]:
    """Each side has the steady state of the model, and both have every index."""
    if not sides:
        return []
    return [
        _range("below", sp.Integer(0), LIMIT, "x", 2 * LIMIT * X / WIDE**2),
        _range("above", LIMIT, "infinity", "g", sp.Integer(1)),
        *(_moved(step, side) for side in sides for step in proof_steps(c) if _ties(step)),
    ]


def _ties(step: Step) -> bool:
    """The two steps that make the names of a tower mean the steady state."""
    return step.id in ("riccati", "stable")


def _moved(step: Step, side: Side) -> Step:
    where = side.tower.name
    return replace(
        step,
        id=f"{where.replace('_', '-')}-{step.id}",
        sentence="",
        reason="",
        tower=where,
        heading="",
        shown=False,
    )


def _range(side: str, low: sp.Expr, high: sp.Expr | str, variable: str, slope: sp.Expr) -> Step:
    ends: Mapping[str, End] = {"0": End(), "infinity": End()}
    hint: dict[str, Any] = {"form": slope, "ends": ends}
    relation = increasing_onto(INDEX, low, high, variable=variable)
    return Step(
        f"{side}-switch-range", "", relation, "", tower=f"index_{side}", hint=hint, shown=False
    )
