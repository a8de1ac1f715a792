"""Where a filter with free gains is stable: conditions that say so, from both sides."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import flint

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import number
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.polynomial import rational
from gainproof.verify.judge.exact.rational_points import failure_at
from gainproof.verify.judge.exact.statement import Rel, Statement, Witness
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.claim_domain import OTHER, Frame, framed, strictly
from gainproof.verify.judge.kinds.identity import resolved
from gainproof.verify.judge.kinds.kind import Kind, one_of
from gainproof.verify.judge.reader.latex_printer import relations_to_latex
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.verdict import Finding, finding_of
from gainproof.verify.judge.verdict_words import Shown

SENSES = ("exact", "sufficient", "necessary", "unstable")
AT_MOST = "at most "
COEFFICIENT = "closed_loop_coefficient."
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
    match claim.own["sense"].word:
        case "sufficient":
            found = finding_of(frame.decide(Statement(stable, stated, "if", needed)))
        case "necessary":
            found = finding_of(frame.decide(Statement(stated, stable, "if", needed)))
        case "unstable":
            found = _nowhere_stable(stated, stable, frame)
        case _:
            found = _exactly(stated, stable, frame)
    witness = found.witness
    if witness is not None:
        printed = [relations_to_latex([r]) for r in (*reading.relations, *reading.conditions)]
        fits = len(printed) == len(stated)
        told = dict(zip(stated, printed, strict=True)) if fits else {}
        witness = _in_words(witness, told, frame)
    return replace(found, witness=witness, method=f"{CRITERION}; {found.method}")


def _in_words(witness: Witness, printed: Mapping[Rel, str], frame: Frame) -> Witness:
    """The witness with a note on the poles and on the conditions as they are printed; as it is
    where its point is not rational.
    """
    names = {label: name for name, label in frame.labels.items()}
    try:
        point = {names.get(label, label): Fraction(v) for label, v in witness.point.items()}
    except ValueError:
        return witness
    modulus = _moduli(point, frame)
    if modulus is None:
        return witness
    if _is_stable(point, frame):
        failing = [
            text
            for rel, text in printed.items()
            if failure_at(Statement((rel,)), point, frame.labels) is not None
        ]
        poles = f"poles of modulus {modulus}"
        though = f"though {', '.join(failing)} fails" if failing else "though it is said not to be"
        note = f"the filter is stable ({poles}), {though}"
        return replace(witness, note=note, shows=Shown.STABILITY)
    pole = f"a pole of modulus {modulus.removeprefix(AT_MOST)}"
    note = f"the filter is not stable ({pole}), though all that is stated holds"
    return replace(witness, note=note, shows=Shown.STABILITY)


def _is_stable(point: Mapping[str, Fraction], frame: Frame) -> bool:
    """Whether the conditions of stability hold at a point, on whose border balls cannot tell."""
    assert frame.environment.region is not None
    put_in = {name: number(value) for name, value in point.items()}
    gaps = [(r, r.left - r.right) for r in frame.environment.region.relations]
    signs = ((r.operator, constant_value(substituted(gap, put_in))) for r, gap in gaps)
    return all(v is not None and (v > 0 if op == ">" else v < 0) for op, v in signs)


def _moduli(point: Mapping[str, Fraction], frame: Frame) -> str | None:
    """The modulus of the poles, or the greatest of several; None if the point does not fix them."""
    known = frame.environment.quantities
    names = [name for name in known if name.startswith(COEFFICIENT)]
    ordered = sorted(names, key=lambda name: int(name.removeprefix(COEFFICIENT)))
    put_in = {name: number(value) for name, value in point.items()}
    values = [constant_value(substituted(known[name], put_in)) for name in ordered]
    coefficients = [rational(value) for value in values if value is not None]
    if not values or len(coefficients) < len(values):
        return None
    polynomial: Any = flint.fmpq_poly(coefficients).numer()
    moduli = sorted(float(abs(root).mid()) for root, _ in polynomial.complex_roots())
    same = f"{moduli[0]:.6g}" == f"{moduli[-1]:.6g}"
    return f"{'' if same else AT_MOST}{moduli[-1]:.6g}"


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


STABILITY = Kind(
    "stability",
    "the filter with free gains is stable exactly where the conditions of the formula hold, in the "
    "domain and under `given`; with another `sense` one direction, then the formula may be missing",
    judge_stability,
    own={"sense": one_of(SENSES, SENSES[0])},
    own_words="`sense`: `exact`, `sufficient` (stable wherever they hold), `necessary` (only where "
    "they hold), `unstable` (nowhere where they hold); variances and lags, which only stable "
    "filters have, are no conditions",
    needs_formula=False,
    strongest=True,
)
