"""Steps on the first and second derivatives of the gains with respect to the index."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.any_two_state import curvature, derivatives
from gainproof.derive.any_two_state.context import Context
from gainproof.derive.any_two_state.names import INDEX
from gainproof.derive.any_two_state.signed import Signed
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.model import ModelError
from gainproof.derive.relation import equal


def derivative_steps(c: Context) -> list[Step]:
    """Those that have a form; the first gain always has one for the first derivative."""
    try:
        found: Mapping[str, Signed] = derivatives.gains(c.basis)
    except ModelError:
        found = {"alpha": Signed(derivatives.gains_slope(c.basis))}
    steps = _opened(
        found,
        1,
        "The gains change with the index like this.",
        "Differentiate step @stable-alpha and the roots of step @roots.",
        "How the steady state changes with the index",
    )
    try:
        second = curvature.gains(c.basis)
    except ModelError:
        return steps
    return steps + _opened(
        second,
        2,
        "And their derivatives in turn.",
        "Differentiate once more; what is added and what is taken away stand apart.",
        "",
    )


def _opened(
    found: Mapping[str, Signed], degree: int, sentence: str, reason: str, heading: str
) -> list[Step]:
    word = {1: "derivative", 2: "second-derivative"}[degree]
    (first, relation), *others = (
        (f"{word}-{name}", equal(sp.Derivative(real(name), (INDEX, degree)), value.value))
        for name, value in found.items()
        if not value.is_zero
    )
    return [
        Step(first, sentence, relation, reason, heading=heading),
        *(joined(name, entry) for name, entry in others),
    ]
