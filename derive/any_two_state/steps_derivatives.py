"""Steps on the first and second derivatives of the gains with respect to the index."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import sympy as sp

from gainproof.derive.any_two_state import curvature, derivatives
from gainproof.derive.any_two_state.context import Context
from gainproof.derive.any_two_state.names import INDEX
from gainproof.derive.any_two_state.signed import Signed
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.model import ModelError
from gainproof.derive.relation import Relation, equal

LONGEST = 250
"""Operations of what stands on a page: about fifteen lines."""


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
        "Differentiate once more; what is added and what is taken away stand apart."
        + left_out(value.value for value in second.values()),
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
        *(followed(name, entry) for name, entry in others),
    ]


def left_out(values: Iterable[sp.Expr]) -> str:
    """A sentence on those that are not shown, if there are any."""
    if all(sp.count_ops(value) <= LONGEST for value in values):
        return ""
    return " What would fill half a page is checked like the rest and not shown."


def followed(name: str, relation: Relation) -> Step:
    """A step that joins the one before it; one too long for a page is not shown."""
    if sp.count_ops(relation.parts["right"]) <= LONGEST:
        return joined(name, relation)
    return Step(name, "", relation, "", shown=False)
