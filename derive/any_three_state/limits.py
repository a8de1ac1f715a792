"""Statements on both ends of the index, and on the range of the first gain."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

import sympy as sp

from gainproof.derive.algebra.derivative import by
from gainproof.derive.algebra.leading_elements import Edge, NoLeadingTerm
from gainproof.derive.algebra.positive_forms import NoPlainSign, nonnegative_form
from gainproof.derive.any_three_state import derivatives
from gainproof.derive.any_three_state.context import Context
from gainproof.derive.any_three_state.names import DEVIATION, GAINS, INDEX, ROOT
from gainproof.derive.any_three_state.towers import powers_of_root, variable
from gainproof.derive.any_two_state.limits import leading_limit
from gainproof.derive.any_two_state.signed_values import Signed
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import increasing_onto


def limit_steps(c: Context) -> Mapping[str, list[Step]]:
    """Leading behaviour at both ends; what has no plain leading term is left out."""
    try:
        ends = c.edges
    except NoLeadingTerm:
        return {"small-index": [], "large-index": [], "range": []}
    values = {
        **c.quantities.gains(c.basis),
        "predicted_11": c.quantities.value(c.basis, "predicted_11"),
    }
    found = {}
    for edge, word in zip(ends, ("small", "large"), strict=True):
        named = {**values, DEVIATION.name: Signed()} if word == "large" else values
        ways = variable(c.shape)[0], partial(_power, c), partial(_value, c)
        group = (leading_limit(c.tower, edge, name, form, *ways) for name, form in named.items())
        found[f"{word}-index"] = [step for step in group if step is not None]
    return {**found, "range": _range(c, ends)}


def _power(c: Context, order: int) -> sp.Expr:
    """The parameter to a power, over the index where the power is whole."""
    step = powers_of_root(c.shape)
    return INDEX ** (order // step) if order % step == 0 else ROOT**order


def _value(c: Context, value: sp.Expr) -> sp.Expr:
    """A limit over the model's own parameters; with roots over the tower's, where they are."""
    radicals = {entry for entry in value.atoms(sp.Pow) if not entry.exp.is_Integer}
    if not radicals:
        return c.shape.readable(c.shape.numbers.named(value))
    outer = [r for r in radicals if not any(r != other and other.has(r) for other in radicals)]
    hidden = {radical: sp.Dummy(positive=True) for radical in outer}
    return sp.factor(value.subs(hidden)).subs({dummy: root for root, dummy in hidden.items()})


def _range(c: Context, ends: tuple[Edge, Edge]) -> list[Step]:
    """The first gain grows from 0 to 1 and takes every value between; the checker compares its
    slope, which with several free numbers takes it too long.
    """
    if len(c.tower.parameters) > 2:
        return []
    alpha = c.quantities.value(c.basis, "alpha")
    name, index = variable(c.shape)
    slope = derivatives.alpha(c.basis) * by(index, real(name))
    try:
        form = c.tower.fraction(alpha.value)
        nonnegative_form(c.tower, slope)
        start, end = (edge.of(form) for edge in ends)
    except (NoPlainSign, NoLeadingTerm):
        return []
    if alpha.cancels or start.order <= 0 or end.order or end.coefficient != 1:
        return []
    hint = {"form": slope, "ends": {"0": ends[0].end, "infinity": ends[1].end}}
    if any(_silent(c, edge) for edge in ends):
        hint["limit_form"] = alpha.value
    relation = increasing_onto(GAINS[0], sp.Integer(0), sp.Integer(1), variable=name)
    return [Step("alpha-range", "", relation, "", hint=hint)]


def _silent(c: Context, edge: Edge) -> bool:
    """Whether the first gain's own numerator shows no leading term there."""
    try:
        edge.of(c.tower.elements["alpha"])
    except NoLeadingTerm:
        return True
    return False
