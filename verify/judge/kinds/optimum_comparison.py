"""Best gains of two states by comparison: the stated gains against every other stable filter with
the same lag. It asks for no minimum on each slice, so that lags without one can be told apart.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, add, number, symbol, symbols_of
from gainproof.verify.judge.exact.polynomial import terms
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.fixed_gain.lag_slices import without_roots
from gainproof.verify.judge.fixed_gain.rational_system import numerator_and_denominator
from gainproof.verify.judge.fixed_gain.shared_gain import shared_gain
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.claim_domain import Frame, framed, strictly
from gainproof.verify.judge.kinds.identity import resolved
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import DEVIATION, INTERVAL
from gainproof.verify.judge.verdict import Finding, finding_of

METHOD = "the stated gains compared with all other stable ones of the same lag"
UNITS = {INTERVAL: number(1), DEVIATION: number(1)}


def judge_by_comparison(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether one gain as a function of the other, which the lag fixes, is stable for every lag of
    the domain and strictly better than all others. Raises Undecided.
    """
    region = scope.environment.region
    if region is None or len(region.gains) != 2 or claim.given:
        raise Undecided("best gains are compared with others for two states only")
    expr = scope.expression(claim.own["minimised"].expression)
    fixed = [scope.expression(graph) for graph in claim.own["fixed"].expressions]
    stated = resolved(reading.relations, scope)
    frame = strictly(framed(claim, scope))
    held = {shared_gain(part, region.gains, region.relations, frame) for part in fixed}
    (name,) = held if len(held) == 1 else (None,)
    if name is None:
        raise Undecided("what is fixed is no function of one gain alone")
    (free,) = (gain for gain in region.gains if gain != name)
    _refuse_domain_of(free, claim, scope)
    if reading.conditions or len(stated) != 1:
        raise Undecided("the stated gains are not one as a function of the other")
    value = _solved_for(stated[0], free)
    least = _in_units(_without_root(expr, frame))

    def at_stated(part: Expr) -> Expr:
        return substituted(part, {free: value})

    inside = tuple(Rel(r.operator, at_stated(r.left), at_stated(r.right)) for r in region.relations)
    better = Statement(
        (Rel(">", least, at_stated(least)),),
        (*region.relations, *inside, Rel("!=", symbol(free), value)),
    )
    return _told(
        finding_of(_along(name, free, frame, scope).decide(Statement(inside))),
        finding_of(frame.decide(better)),
    )


def _told(stable: Finding, best: Finding) -> Finding:
    if best.verdict not in ("proved", "held") and best.witness is not None:
        note = "left that of these gains, right that of the stated ones with the same lag"
        witness = replace(best.witness, note=note)
        reason = f"other gains of the same lag are as good or better: {witness.text()}"
        if stable.verdict in ("proved", "conditional"):
            return Finding("refuted", reason, "nowhere", METHOD, witness)
    if stable.verdict in ("refuted", "conditional"):
        reason = f"the stated gains are not stable: {stable.reason}"
        stable = replace(stable, reason=reason)
    if stable.verdict != "proved" or best.verdict != "proved":
        weaker = stable if best.verdict == "proved" or stable.verdict == "refuted" else best
        return replace(weaker, method=f"{METHOD}; {weaker.method}")
    certificate = {
        "the stated gains are stable": dict(stable.certificate),
        "all others are worse": dict(best.certificate),
    }
    reason = "the one minimum among the stable filters of each lag of the domain"
    return Finding("proved", reason, stable.domain, METHOD, None, certificate)


def _refuse_domain_of(free: str, claim: Claim, scope: Scope) -> None:
    """A domain may narrow the lags, not the filters of one lag. Raises Undecided."""
    stated = [*claim.domain]
    for token in scope.used:
        stated += scope.setting.symbols[token].domain
    for relation in stated:
        rel = scope.relation(relation)
        if free in symbols_of(rel.left, rel.right):
            raise Undecided("a minimum among some filters of one lag is not covered")


def _solved_for(rel: Rel, free: str) -> Expr:
    """The other side of an equation one side of which is the free gain. Raises Undecided."""
    for side, other in ((rel.left, rel.right), (rel.right, rel.left)):
        if rel.operator == "=" and side == symbol(free) and free not in symbols_of(other):
            return other
    raise Undecided("the stated gains are not one as a function of the other")


def _without_root(expr: Expr, frame: Frame) -> Expr:
    """What is least where this is. Raises Undecided."""
    plain = without_roots(expr)
    if plain != expr and not frame.holds(Rel(">", plain, number(0))):
        raise Undecided("what is minimised is not seen to be positive under its root")
    return plain


def _in_units(expr: Expr) -> Expr:
    """For T = 1 and noise of variance 1, if these only scale it. Raises Undecided."""
    plain = substituted(expr, UNITS)
    names = sorted(symbols_of(expr))
    if plain == expr:
        return expr
    sides = numerator_and_denominator(expr / plain, names)
    units = [i for i, name in enumerate(names) if name in UNITS]
    for side in sides:
        (exponents, *others) = [e for e, _ in terms(side)]
        if others or any(e for i, e in enumerate(exponents) if i not in units):
            raise Undecided("what is minimised depends on T or on the noise beside the gains")
    return plain


def _along(name: str, free: str, frame: Frame, scope: Scope) -> Frame:
    """The frame of all lags of stable filters: the gain that is held from 0 to its largest value.
    Raises Undecided unless it is a number over 1 + x + e for the steps x, e of stable filters.
    """
    region = scope.environment.region
    assert region is not None
    chart = region.charted.quantities[name]
    total = add(number(1), *map(symbol, region.steps))
    most = _at_ones(chart * total, region.steps)
    rest = numerator_and_denominator(chart * total - number(most), region.steps)[0]
    if most <= 0 or not rest.is_zero():
        raise Undecided("which gains have a stable filter is not seen")
    boxes: Mapping[str, Box] = {**frame.boxes, name: _below(frame.boxes[name], most)}
    kept = tuple(c for c in frame.conditions if free not in symbols_of(c.left, c.right))
    return replace(frame, boxes=boxes, conditions=kept)


def _at_ones(expr: Expr, steps: tuple[str, ...]) -> Fraction:
    value = constant_value(substituted(expr, dict.fromkeys(steps, number(1))))
    if value is None:
        raise Undecided("which gains have a stable filter is not seen")
    return value


def _below(box: Box, most: Fraction) -> Box:
    """The box without what is not between 0 and a number. Raises Undecided for what is empty."""
    if box.lower is None or box.lower <= 0:
        box = replace(box, lower=Fraction(0), lower_open=True)
    if box.upper is None or box.upper >= most:
        box = replace(box, upper=most, upper_open=True)
    if box.is_empty:
        raise Undecided("no stable filter has a lag of the domain")
    return box
