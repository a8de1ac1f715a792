"""Where a filter with free gains is stable: conditions that say so, from both sides."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.framing import OTHER, Frame, framed, strictly
from gainproof.verify.judge.kinds.identity import resolved
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.verdict import Finding, finding_of

CRITERION = "all poles inside the unit circle, by the Hurwitz criterion"


def judge_stability(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether the filter is stable where, and for the sense `exact` only where, the conditions
    hold; for `unstable`, nowhere there. Raises Undecided where a condition speaks of a variance or
    a lag.
    """
    region = scope.environment.region
    if region is None:
        raise Undecided("only a setting of kind fixed_gain has free gains")
    stated = (*resolved(reading.relations, scope), *resolved(reading.conditions, scope))
    frame = strictly(framed(claim, scope))
    if scope.uses_steady():
        # its value rests on stability, which would then be proved from itself
        raise Undecided("conditions of stability on what only a stable filter has")
    stable, needed = region.relations, tuple(scope.needed)
    match claim.sense or "exact":
        case "sufficient":
            return _told(finding_of(frame.decide(Statement(stable, stated, "if", needed))))
        case "necessary":
            return _told(finding_of(frame.decide(Statement(stated, stable, "if", needed))))
        case "unstable":
            return _told(_nowhere_stable(stated, stable, frame))
        case _:
            return _told(_exactly(stated, stable, frame))


def _told(finding: Finding) -> Finding:
    return replace(finding, method=f"{CRITERION}; {finding.method}")


def _exactly(stated: Sequence[Rel], stable: Sequence[Rel], frame: Frame) -> Finding:
    """Both directions; what is wrong has a witness and the true region beside it."""
    if not stated:
        raise Undecided("no conditions are stated")
    outside = finding_of(frame.decide(Statement(tuple(stated), tuple(stable))))
    try:
        inside = finding_of(frame.decide(Statement(tuple(stable), tuple(stated))))
    except Undecided:
        if outside.verdict == "proved":
            raise
        # conditions that hold nowhere admit no unstable filter
        inside = outside
    region = ", ".join(
        f"{labelled(rel.left, frame.labels)} {rel.operator} 0" for rel in reversed(stable)
    )
    for finding, words in (
        (outside, "a stable filter does not satisfy the conditions"),
        (inside, "an unstable filter satisfies the conditions"),
    ):
        if finding.verdict not in ("proved", "held"):
            reason = f"{words}: {finding.reason.partition(';')[0]}; stable exactly where {region}"
            return finding.told_as("refuted", reason, "nowhere")
    if inside.verdict == outside.verdict == "proved":
        certificate = {
            "stable where they hold": dict(inside.certificate),
            "they hold where it is stable": dict(outside.certificate),
        }
        reason = "the conditions hold exactly where the filter is stable"
        return replace(inside, reason=reason, certificate=certificate, domain=inside.domain)
    return inside if inside.verdict == "held" else outside


def _nowhere_stable(stated: Sequence[Rel], stable: Sequence[Rel], frame: Frame) -> Finding:
    """One of the conditions of stability fails wherever the others and what is stated hold, which
    must be somewhere. Raises Undecided.
    """
    last: Finding | None = None
    for rel in stable:
        others = tuple(other for other in stable if other is not rel)
        fails = Rel(OTHER[rel.operator], rel.left, rel.right)
        for beside in ((), others):
            try:
                found = finding_of(frame.decide(Statement((fails,), (*stated, *beside))))
            except Undecided:
                continue
            if found.verdict == "proved":
                return replace(found, reason="unstable on the whole domain")
            last = found if beside else last
    if last is None:
        raise Undecided("whether a filter under these conditions is stable was not decided")
    if last.verdict in ("refuted", "conditional"):
        # under all other conditions of stability this one holds there: a stable filter
        reason = f"a stable filter: {last.reason.partition(';')[0]}"
        return replace(last, reason=reason)
    return last
