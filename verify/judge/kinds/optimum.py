"""Best gains: the one minimum of a quantity over the stable filters of one lag."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.exact.ball_text import enclosure
from gainproof.verify.judge.exact.balls import enclosed
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.statement import Rel, Statement, Witness
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.fixed_gain.lag_slices import (
    Curve,
    fixes_sum,
    has_roots,
    refuse_unless_coercive,
    stationary,
    without_roots,
)
from gainproof.verify.judge.fixed_gain.rational_system import lowest
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.claim_domain import Frame, framed, strictly
from gainproof.verify.judge.kinds.identity import resolved
from gainproof.verify.judge.kinds.kind import Kind, expression, fixed
from gainproof.verify.judge.kinds.optimum_comparison import judge_by_comparison
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import DEVIATION, INTERVAL, Environment
from gainproof.verify.judge.setting.stable_region import StableRegion
from gainproof.verify.judge.verdict import Finding, finding_of

METHOD = (
    "a minimum exists on each slice of one lag, slopes vanish at one filter of it, and the stated "
    "gains are those"
)
BITS = 128
PARTS = tuple(Fraction(1, n) for n in (2, 4, 10, 50, 1000))
"""How much of one step is given to its neighbour, which keeps the lag, to find better gains."""


def judge_optimum(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether the stated gains, and no others, minimise the quantity over all stable filters with
    the same value of what is fixed, whatever this value is. Raises Undecided.
    """
    try:
        return _on_slices(claim, reading, scope)
    except Undecided as reason:
        try:
            return judge_by_comparison(claim, reading, scope)
        except Undecided:
            raise reason from None


def _on_slices(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """By the one place on each slice of one lag where slopes vanish. Raises Undecided."""
    region = scope.environment.region
    if region is None or len(region.steps) < 2:
        raise Undecided("best gains are those of a setting of kind fixed_gain with 2 or 3 states")
    if claim.given:
        raise Undecided("a minimum under further conditions is not covered")
    chart = region.charted
    inner = Scope(scope.setting, chart, held=claim.held)
    least = without_roots(inner.expression(claim.own["minimised"].expression))
    kept = [inner.expression(graph) for graph in claim.own["fixed"].expressions]
    stated = (*resolved(reading.relations, inner), *resolved(reading.conditions, inner))
    if not stated:
        raise Undecided("no gains are stated")
    frame = strictly(framed(claim, inner))
    if not all(fixes_sum(expr, region.steps) for expr in kept):
        raise Undecided("what is fixed is no function of the lag alone")
    refuse_unless_coercive(least, region.steps)
    curve = stationary(least, region.steps)
    return _compared(stated, least, curve, frame, scope, reading)


def _compared(
    stated: tuple[Rel, ...],
    least: Expr,
    curve: Curve,
    frame: Frame,
    scope: Scope,
    reading: Reading,
) -> Finding:
    others = tuple(curve.steps)[1:]
    put_in = {name: curve.steps[name] for name in others}

    def at_best(rel: Rel) -> Rel:
        return Rel(rel.operator, substituted(rel.left, put_in), substituted(rel.right, put_in))

    best = finding_of(
        frame.decide_alone(
            Statement(tuple(map(at_best, stated)), tuple(map(at_best, frame.conditions)))
        )
    )
    told = _best_gains(frame.environment, curve, scope)
    try:
        found = _only(stated, curve, frame, scope, reading)
    except Undecided:
        if best.verdict != "refuted":
            raise
        found = best
    if found.verdict not in ("proved", "held") and found.witness is not None:
        better = _better(found.witness, least, frame, scope)
        if better is not None:
            reason = f"other gains of the same lag are better: {better.text()}; best are {told}"
            return Finding("refuted", reason, "nowhere", METHOD, better)
    if best.verdict == "refuted" or (best.verdict == "conditional" and found.verdict != "proved"):
        reason = f"the best gains do not satisfy it: {best.reason}; best are {told}"
        return replace(best.told_as("refuted", reason, "nowhere"), method=METHOD)
    if best.verdict == "conditional":
        reason = f"the best gains satisfy it for some lags only: {best.reason}; best are {told}"
        return replace(best, reason=reason, method=METHOD)
    if found.verdict != "proved":
        reason = f"not only the best gains satisfy it: {found.reason}; best are {told}"
        return replace(found, reason=reason, method=METHOD)
    if best.verdict != "proved":
        return replace(best, method=METHOD)
    certificate = {
        "the best gains satisfy it": dict(best.certificate),
        "no others do": dict(found.certificate),
    }
    reason = f"the one minimum among the stable filters of each lag: {told}"
    within = "" if not frame.conditions else " whose best gains lie in the stated domain"
    domain = f"for every lag of a stable filter{within}"
    return Finding("proved", reason, domain, METHOD, None, certificate)


def _only(
    stated: tuple[Rel, ...], curve: Curve, frame: Frame, scope: Scope, reading: Reading
) -> Finding:
    """Whether all stable filters that satisfy the formula lie where slopes vanish: over the steps,
    else in the gains. Raises Undecided.
    """
    zeros = tuple(Rel("=", zero, number(0)) for zero in curve.zeros)
    reasons: list[str] = []
    for attempt in _ways(stated, zeros, frame, scope, reading):
        try:
            found = finding_of(attempt[0].decide_alone(attempt[1]))
        except Undecided as reason:
            reasons.append(str(reason))
            continue
        if found.verdict != "held":
            return found
    raise Undecided("whether only the best gains satisfy it: " + "; ".join(dict.fromkeys(reasons)))


def _ways(
    stated: tuple[Rel, ...], zeros: tuple[Rel, ...], frame: Frame, scope: Scope, reading: Reading
) -> list[tuple[Frame, Statement]]:
    """Over the steps, where all is positive, and in the gains, where roots are simpler."""
    ways = [(frame, Statement(zeros, (*stated, *frame.conditions)))]
    region = scope.environment.region
    if region is None or frame.conditions:
        return ways
    plain = (*resolved(reading.relations, scope), *resolved(reading.conditions, scope))
    moved = tuple(
        Rel("=", substituted(rel.left, region.back), substituted(rel.right, region.back))
        for rel in zeros
    )
    boxes, labels = scope.boxes(), scope.labels()
    around = strictly(replace(frame, boxes=boxes, conditions=(), labels=labels))
    ways.append((around, Statement(moved, (*plain, *region.relations))))
    sides = [side for rel in stated for side in (rel.left, rel.right)]
    return ways[::-1] if any(has_roots(side) for side in sides) else ways


def _best_gains(environment: Environment, curve: Curve, scope: Scope) -> str:
    """The best gains as functions of the first step, in the source's symbols."""
    region = scope.environment.region
    labels = scope.labels()
    names = () if region is None else region.gains
    first = next(iter(curve.steps))
    told = []
    for name in names:
        value = substituted(environment.quantities[name], dict(curve.steps))
        shown = labelled(lowest(value, (first,)), {first: "s"})
        told.append(f"{labels.get(name, name)} = {shown}")
    return ", ".join(told) + " with s > 0"


def _better(witness: Witness, least: Expr, frame: Frame, scope: Scope) -> Witness | None:
    """A filter of the same lag with a smaller value, if the witness is a rational point."""
    region = scope.environment.region
    here = None if region is None else _steps_of(witness, region, scope)
    if region is None or here is None:
        return None
    value = substituted(least, {INTERVAL: number(1), DEVIATION: number(1)})
    now = _value(value, here)
    if now is None:
        return None
    pairs = [pair for couple in pairwise(region.steps) for pair in (couple, couple[::-1])]
    for part in PARTS:
        for one, other in pairs:
            given = part * here[other]
            moved = {**here, one: here[one] + given, other: here[other] - given}
            then = _value(value, moved)
            if then is not None and then < now:
                return _witness(here, moved, value, frame, scope)
    return None


def _steps_of(witness: Witness, region: StableRegion, scope: Scope) -> dict[str, Fraction] | None:
    """The steps of a witness at a rational point, be it told in steps or in gains."""
    labels = scope.labels()
    for names, told in (
        (region.steps, dict(zip(region.steps, region.steps, strict=True))),
        (region.gains, {name: labels.get(name, name) for name in region.gains}),
    ):
        if not {told[name] for name in names} <= set(witness.point):
            continue
        try:
            point = {name: Fraction(witness.point[told[name]]) for name in names}
        except ValueError:
            return None
        if names == region.steps:
            return point
        found = {name: _value(region.back[name], point) for name in region.steps}
        return {name: value for name, value in found.items() if value is not None}
    return None


def _value(expr: Expr, point: Mapping[str, Fraction]) -> Fraction | None:
    return constant_value(substituted(expr, {n: number(v) for n, v in point.items()}))


def _witness(
    stated: Mapping[str, Fraction],
    better: Mapping[str, Fraction],
    value: Expr,
    frame: Frame,
    scope: Scope,
) -> Witness:
    labels = scope.labels()

    def gains(point: Mapping[str, Fraction]) -> dict[str, str]:
        put_in = {n: number(v) for n, v in point.items()}
        quantities = frame.environment.quantities
        names = sorted(n for n in quantities if n.startswith("filter_gain."))
        values = {n: constant_value(substituted(quantities[n], put_in)) for n in names}
        return {labels.get(n, n): str(v) for n, v in values.items()}

    sides = [enclosure(enclosed(value, dict(point), BITS), 12) for point in (stated, better)]
    others = ", ".join(f"{name} = {v}" for name, v in gains(better).items())
    note = f"right that of {others}, both for T = 1 and noise of variance 1"
    return Witness(gains(stated), "<=", sides[0], sides[1], note=note)


OPTIMUM = Kind(
    "optimum",
    "the gains that the formula states, and no others, make something least among all stable "
    "filters with the same lag, whatever this lag is",
    judge_optimum,
    own={"minimised": expression("what is compared"), "fixed": fixed},
    own_words="`minimised`: an expression; `fixed`: a list of what stays, functions of the lag of "
    "the order in which it is constant",
)
