"""Steps on both ends of the index, and on the range of the first gain."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

import sympy as sp

from gainproof.derive.algebra.derivative import by
from gainproof.derive.algebra.leading_elements import Edge, Leading, NoLeadingTerm
from gainproof.derive.algebra.positive_forms import NoPlainSign, nonnegative_form
from gainproof.derive.algebra.tower import Fraction, Tower
from gainproof.derive.any_two_state import covariance_forms, derivatives, forms
from gainproof.derive.any_two_state.context import Context
from gainproof.derive.any_two_state.names import ALPHA, DEVIATION, INDEX, ROOT
from gainproof.derive.any_two_state.signed_values import Signed
from gainproof.derive.any_two_state.towers import variable
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.model import ModelError
from gainproof.derive.relation import increasing_onto, limit


def limit_steps(c: Context) -> Mapping[str, list[Step]]:
    """Leading behaviour at both ends; what has no plain leading term is left out."""
    try:
        small, large = c.edges
    except NoLeadingTerm:
        return {"small-index": [], "large-index": [], "range": []}
    values = {
        **forms.gains(c.basis),
        "predicted_11": Signed(forms.variance_excess(c.basis)),
        "updated_22": covariance_forms.updated_22(c.basis),
    }
    found = {}
    for edge, word in ((small, "small"), (large, "large")):
        named = {DEVIATION.name: Signed(), **values} if edge.at_infinity else values
        ways = variable(c.shape)[0], partial(_power, c), partial(_value, c)
        group = (leading_limit(c.tower, edge, name, form, *ways) for name, form in named.items())
        found[f"{word}-index"] = [step for step in group if step is not None]
    return {**found, "range": _range(c, (small, large))}


def leading_limit(
    tower: Tower,
    edge: Edge,
    name: str,
    form: Signed,
    parameter: str,
    power: Callable[[int], sp.Expr],
    value: Callable[[sp.Expr], sp.Expr],
) -> Step | None:
    """The limit of a quantity over its leading power of the index; nothing where it is not known.

    `power`: of the parameter by its order. `value`: a limit over the model's own numbers.
    """
    word, point = ("large", "infinity") if edge.at_infinity else ("small", "0")
    fractions = [tower.elements[name]]
    if not form.is_zero and not form.cancels:
        fractions.append(tower.fraction(form.value))
    found = first_leading(edge, fractions)
    if found is None or not known_limit(edge, found[0].coefficient):
        return None
    leading, needed = found
    size = power(leading.order)
    hint: dict[str, object] = {"ends": {point: edge.end}}
    if needed:
        hint["limit_form"] = form.value / size
    relation = limit(real(name) / size, point, value(leading.coefficient), parameter)
    return joined(f"{word}-{name.replace('_', '-')}", relation, hint=hint)


def first_leading(edge: Edge, fractions: list[Fraction]) -> tuple[Leading, bool] | None:
    """The leading term of the first that shows one, and whether it is a later one."""
    for number, fraction in enumerate(fractions):
        try:
            return edge.of(fraction), number > 0
        except NoLeadingTerm:
            continue
    return None


def known_limit(edge: Edge, value: sp.Expr) -> bool:
    """Whether each root in a limit is one of the edge's own, which the checker knows."""
    inside = {root.args[0] for root in edge.roots.values() if root.args}
    if value.free_symbols & {root for root in edge.roots.values() if not root.args}:
        return False  # a coupled pair of constants has no form
    roots = [entry for entry in value.atoms(sp.Pow) if not entry.exp.is_Integer]
    # SymPy writes a root of a root as a fourth one, of which the checker knows nothing
    return all(entry.base in inside and entry.exp.q == 2 for entry in roots)


def _power(c: Context, order: int) -> sp.Expr:
    """The parameter to a power, over the index where the power is whole."""
    if variable(c.shape)[0] == INDEX.name:
        return INDEX**order
    return INDEX ** (order // 2) if order % 2 == 0 else ROOT**order


def _value(c: Context, value: sp.Expr) -> sp.Expr:
    """A limit over the model's own parameters; with roots over the tower's, where they are."""
    plain = all(entry.exp.is_Integer for entry in value.atoms(sp.Pow))
    return c.shape.readable(c.shape.numbers.named(value)) if plain else value


def _range(c: Context, edges: tuple[Edge, Edge]) -> list[Step]:
    """The first gain grows; it takes every value between its limits."""
    small, large = edges
    form = forms.alpha(c.basis)
    try:
        slope = derivatives.gains_slope(c.basis)
        nonnegative_form(c.tower, slope)
        start = small.of(c.tower.fraction(form))
    except (ModelError, NoPlainSign, NoLeadingTerm):
        return []
    if start.order < 0 or large.of(c.tower.fraction(form)).order:
        return []
    needed = False
    for edge in edges:
        try:
            edge.of(c.tower.elements[ALPHA.name])
        except NoLeadingTerm:
            needed = True
    hint = {"form": slope, "ends": {"0": small.end, "infinity": large.end}}
    if needed:
        hint["limit_form"] = form
    least = sp.Integer(0) if start.order else _value(c, start.coefficient)
    name, index = variable(c.shape)
    if name != INDEX.name:
        hint["form"] = slope * by(index, ROOT)
    relation = increasing_onto(ALPHA, least, sp.Integer(1), variable=name)
    return [Step("alpha-range", "", relation, "", hint=hint)]
