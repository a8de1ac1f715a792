"""The kernel of the closed-loop poles computes the poles of the derivation, on each side."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.relation import Relation
from gainproof.derive.steady_state import poles
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.names import ALPHA, BETA, DEVIATION
from gainproof.derive.steady_state.pole_towers import (
    ABOVE,
    BELOW,
    SIDE,
    G,
    middle_size,
    turning_root,
)
from gainproof.derive.steady_state.steps_poles import FIRST, IM, RE, SECOND
from gainproof.derive.steady_state.towers import graph_roots, rational


def pole_programs(c: Context, graph: Mapping[str, Any]) -> list[Step]:
    """The pole kernel computes these poles on each side."""
    roots = graph_roots(c.e)
    reason = "Evaluate the kernel's graph in the tower."
    sentence = "The kernel closed_loop_poles computes"
    if c.e == 1:
        outputs = _pair(1 - (ALPHA + BETA) / 2, poles.half_width(c.basis, None, None))
        return [
            _program(
                "kernel-poles", sentence + " them.", outputs, "main", roots, {}, {}, graph, reason
            )
        ]
    limit = rational(8 / (1 - c.e))
    roots |= {"turning_root": turning_root(c.e), "below": BELOW, "above": ABOVE}
    choices = [f"choice_{number}" for number in range(1, 7)]
    below = dict.fromkeys(choices, "then")
    above = dict.fromkeys(choices, "else")
    first = {
        "first_real": FIRST,
        "first_imaginary": sp.Integer(0),
        "second_real": SECOND,
        "second_imaginary": sp.Integer(0),
        "first_modulus": -FIRST,
        "second_modulus": -SECOND,
    }
    gap = limit / SIDE
    return [
        _program(
            "kernel-complex-poles",
            sentence + " the complex poles below the turning index.",
            _pair(RE, IM),
            "complex_poles",
            roots,
            {**below, "distance": "positive"},
            {**dict.fromkeys(choices, gap), "distance": gap / 4},
            graph,
            reason,
        ),
        _program(
            "kernel-real-poles",
            sentence + " the real poles above the turning index.",
            first,
            "real_poles",
            roots,
            {**above, "distance": "negative", "middle_size": "negative"},
            {
                **dict.fromkeys(choices, G**2),
                "distance": G**2 / 4,
                "middle_size": middle_size(c.basis),
            },
            graph,
            reason,
        ),
    ]


def _pair(middle: sp.Expr, width: sp.Expr) -> dict[str, sp.Expr]:
    return {
        "first_real": middle,
        "first_imaginary": width,
        "second_real": middle,
        "second_imaginary": -width,
        "first_modulus": 1 / DEVIATION,
        "second_modulus": 1 / DEVIATION,
    }


def _program(
    name: str,
    sentence: str,
    outputs: Mapping[str, sp.Expr],
    tower: str,
    roots: Mapping[str, Any],
    branches: Mapping[str, str],
    gaps: Mapping[str, Any],
    graph: Mapping[str, Any],
    reason: str,
) -> Step:
    return Step(
        name,
        sentence,
        Relation("program", {"program": "closed_loop_poles", "outputs": outputs}),
        reason,
        tower=tower,
        hint={"graph": graph, "roots": roots, "branches": branches, "gaps": gaps},
        shown=False,
    )
