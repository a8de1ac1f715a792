"""Orders between the same quantity of several filters with free gains that have something in
common, such as their lag.

Positive symbols under square roots are written as squares: a relation of degree two stays one.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise

from gainproof.verify.judge.claim.record import Claim, OwnField
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.expression import (
    Expr,
    number,
    power,
    symbol,
    symbols_of,
    walk,
    whole_power,
)
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.fixed_gain.shared_gain import shared_gain
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.claim_domain import Frame, framed, only_plain, strictly
from gainproof.verify.judge.kinds.kind import Kind, OwnFields, expression, fixed
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.verdict import Finding, finding_of, of_parts

MOST_FILTERS = 20
METHOD = "each filter with gains of its own, all with the same fixed quantity"


@dataclass(frozen=True)
class _Filter:
    """What is compared, and what holds of the gains: the equations of the filter, stability, the
    domain of the claim.
    """

    compared: Expr
    conditions: tuple[Rel, ...]


def _ascending(claim: OwnFields, name: str) -> OwnField:
    names = claim.fields.texts(name, MOST_FILTERS)
    if len(names) < 2 or len(set(names)) < len(names):
        problem = "two or more different filters of the setting are wanted"
        raise claim.fields.fail(name, problem)
    return OwnField(filters=names)


def judge_ordering(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether the quantity rises strictly from each filter to the next wherever all of them exist
    and are stable. Raises Undecided.
    """
    region = scope.environment.region
    if region is None or reading.relations:
        raise Undecided("an ordering compares filters of a setting of kind fixed_gain")
    compared = scope.expression(claim.own["compared"].expression)
    kept = [scope.expression(graph) for graph in claim.own["fixed"].expressions]
    ascending = claim.own["ascending"].filters
    laws = {name: _laws(name, scope) for name in ascending}
    frame = framed(claim, scope)
    stated = (*frame.conditions, *region.relations)
    by_gain = [(expr, shared_gain(expr, region.gains, region.relations, frame)) for expr in kept]
    shared = {name for _, name in by_gain if name is not None}
    open_ = [expr for expr, name in by_gain if name is None]
    copies: dict[str, _Filter] = {}
    boxes, labels = dict(frame.boxes), dict(frame.labels)
    first: list[Expr] = []
    for name in ascending:
        own = {g: symbol(f"{g} of {name}") for g in region.gains if g not in shared}
        for gain, changed in own.items():
            boxes[changed.name] = frame.boxes[gain]
            labels[changed.name] = f"{frame.labels.get(gain, gain)} of {name}"
        values = [substituted(expr, own) for expr in open_]
        first = first or values
        same = [Rel("=", a, b) for a, b in zip(first, values, strict=True) if a != b]
        conditions = tuple(_moved(rel, own) for rel in (*laws[name], *stated))
        copies[name] = _Filter(substituted(compared, own), (*conditions, *same))
    bare = strictly(replace(frame, boxes=boxes, conditions=(), labels=labels))
    return _chain(ascending, copies, bare)


def _laws(name: str, scope: Scope) -> tuple[Rel, ...]:
    """The equations of a named filter."""
    formulas = scope.setting.filters.get(name)
    if formulas is None:
        raise Undecided(f"the setting has no filter {name}")
    found = [rel for f in formulas for r in f.readings[0].relations for rel in scope.relations(r)]
    only_plain(found)
    return tuple(found)


def _moved(rel: Rel, own: dict[str, Expr]) -> Rel:
    return Rel(rel.operator, substituted(rel.left, own), substituted(rel.right, own))


def _decided(statement: Statement, frame: Frame) -> Finding:
    """As it stands, else over the roots of gains. Raises Undecided."""
    try:
        return finding_of(frame.decide(statement))
    except Undecided:
        moved = as_squares(statement, frame)
        if moved is None:
            raise
        return finding_of(moved[1].decide(moved[0]))


def _chain(names: tuple[str, ...], copies: dict[str, _Filter], frame: Frame) -> Finding:
    """Neighbour by neighbour, first wherever these two exist, then wherever all do."""
    every = tuple(dict.fromkeys(rel for name in names for rel in copies[name].conditions))
    found: list[Finding] = []
    for lower, upper in pairwise(names):
        rises = (Rel("<", copies[lower].compared, copies[upper].compared),)
        own = tuple(dict.fromkeys((*copies[lower].conditions, *copies[upper].conditions)))
        finding = _decided(Statement(rises, own), frame)
        if finding.verdict != "proved" and len(names) > 2:
            finding = _decided(Statement(rises, every), frame)
        if finding.verdict != "proved":
            reason = f"{lower} is not always below {upper}: {finding.reason}"
            finding = replace(finding, reason=reason, method=f"{METHOD}; {finding.method}")
        found.append(finding)
        if finding.verdict == "refuted":
            break
    if (against := of_parts(found)) is not None:
        return against
    certificate = {
        f"{lower} < {upper}": dict(finding.certificate)
        for (lower, upper), finding in zip(pairwise(names), found, strict=True)
    }
    return replace(
        found[-1],
        reason=f"strictly ascending: {', '.join(names)}",
        domain=f"wherever {', '.join(names)} exist and are stable",
        method=f"{METHOD}; {found[-1].method}",
        certificate=certificate,
    )


def as_squares(statement: Statement, frame: Frame) -> tuple[Statement, Frame] | None:
    """The statement over the roots of those symbols whose square roots it holds, and its frame;
    None if there are none. They must be positive by a condition, or by their box, and have no other
    bound, so that their roots are all positive numbers.
    """
    known = {rel.left.name for rel in statement.conditions if _says_positive(rel)}
    found: dict[str, Expr] = {}
    for name in sorted(symbols_of(*statement.exprs())):
        box = frame.boxes.get(name, Box())
        free = box.upper is None and not box.integer and box.lower in (None, 0)
        if free and (name in known or box.is_positive) and _is_rooted(name, statement):
            found[name] = whole_power(symbol(root_name(name)), 2)
    if not found:
        return None
    boxes = {name: box for name, box in frame.boxes.items() if name not in found}
    boxes |= {root_name(name): Box(lower=number(0).fraction) for name in found}
    labels = {**frame.labels}
    labels |= {root_name(name): f"root of {labels.get(name, name)}" for name in found}
    moved = statement.mapped(lambda expr: tidied(_put_in(expr, found)))
    return moved, replace(frame, boxes=boxes, labels=labels)


def root_name(name: str) -> str:
    """The symbol for the positive square root of another."""
    return f"root of {name}"


def _says_positive(rel: Rel) -> bool:
    return rel.operator == ">" and rel.left.kind == "symbol" and rel.right == number(0)


def _is_rooted(name: str, statement: Statement) -> bool:
    return any(
        node.kind == "pow" and node.fraction.denominator == 2 and node.parts[0] == symbol(name)
        for node in walk(*statement.exprs())
    )


def _put_in(expr: Expr, found: Mapping[str, Expr]) -> Expr:
    """A root becomes the new symbol itself: the root of its square would be its absolute value."""

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        if node.kind == "symbol":
            return found.get(node.name)
        if node.kind == "pow" and node.parts[0].kind == "symbol" and node.parts[0].name in found:
            doubled = node.fraction * 2
            if doubled.denominator == 1:
                return whole_power(symbol(root_name(node.parts[0].name)), int(doubled))
            return power(parts[0], node.fraction)
        return None

    return rebuilt(expr, change)


ORDERING = Kind(
    "ordering",
    "something rises strictly from filter to filter, wherever all of them exist and are stable, "
    "each with gains of its own; a domain is that of each",
    judge_ordering,
    own={"compared": expression("what is compared"), "ascending": _ascending, "fixed": fixed},
    own_words="`compared`: an expression; `ascending`: names of `filters` of the setting; `fixed`: "
    "a list of what they have in common",
    needs_formula=False,
)
