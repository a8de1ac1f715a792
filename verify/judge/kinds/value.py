"""Printed numbers and matrices of them: each exact value lies within half a unit of the last digit
shown.

A tie is rounded away from zero or to the even digit, as sources do: 0.65 is printed as 0.7 or 0.6,
but 0.75 as 0.8 only.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import flint

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.exact.ball_text import enclosure, is_long
from gainproof.verify.judge.exact.balls import NoValue, Unresolved, enclosed
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.certificate import statement_data
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of
from gainproof.verify.judge.exact.polynomial import rational
from gainproof.verify.judge.exact.statement import Enclosure, Rel, Statement, Witness
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Reading, Relation
from gainproof.verify.judge.kinds.claim_domain import Frame, fixed_numbers, framed, only_plain
from gainproof.verify.judge.kinds.kind import Kind
from gainproof.verify.judge.kinds.limit import limit_by_expansion
from gainproof.verify.judge.kinds.limit_neighbourhood import open_sides, others_frame
from gainproof.verify.judge.kinds.limit_point import approach_of, arrow_of, end_of
from gainproof.verify.judge.meaning.value import shape
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.verdict import Finding, finding_of, of_parts
from gainproof.verify.judge.verdict_words import Shown

PRECISION = 512
METHOD = "a ball round the value"


def _lacks_number(reading: Reading) -> str | None:
    first = reading.relations[0]
    if first.left_decimals is None and first.right_decimals is None:
        return "has a number on one side, or a matrix of numbers"
    return None


def judge_value(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether every printed number is the rounded value of the other side."""
    if any(condition.operator == "->" for condition in reading.conditions):
        return _of_limit(claim, reading, scope)
    printed_numbers = [n for relation in reading.relations for n in _turned(relation, scope)]
    printed = tuple(scope.relation(r) for r in reading.conditions)
    only_plain(printed)
    frame = framed(claim, scope, printed)
    if not printed_numbers:
        raise Undecided("no number is printed")
    findings = [_within(exact, shown, frame) for exact, shown, _ in printed_numbers]
    found = _naming(findings, [entry for *_, entry in printed_numbers])
    if found.verdict != "proved" or len(findings) == 1:
        return found
    # each has evidence of its own, and what is claimed is all of them
    bounds = tuple(rel for exact, shown, _ in printed_numbers for rel in shown.bounds(exact))
    parts = {f"number {n}": each.certificate for n, each in enumerate(findings, start=1)}
    reason = "each exact value lies in the interval of the digits shown"
    return replace(found, reason=reason, certificate={**parts, "asked": _asked(bounds, frame)})


def _asked(bounds: tuple[Rel, ...], frame: Frame) -> Mapping[str, Any]:
    whole = Statement(bounds, frame.conditions)
    own = {name: box for name, box in frame.boxes.items() if name in whole.symbols()}
    return statement_data(whole, own, frame.parameter, frame.labels)


def _of_limit(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """The same for the limit of the other side, where the arrow says."""
    arrow, others = arrow_of(reading)
    ((exact, shown, _), *more) = _turned(reading.relations[0], scope)
    if more:
        raise Undecided("a limit of a matrix: make a claim of each entry")
    variable, point = scope.expression(arrow.left), end_of(arrow.right, scope)
    scope.refuse_moving(variable, exact)
    printed = tuple(scope.relation(r) for r in others)
    only_plain(printed)
    frame = framed(claim, scope, printed)
    approach = approach_of(variable, point, frame)
    around, dropped = others_frame(frame, approach)
    if dropped:
        raise Undecided("a limit under conditions on its variable")
    findings: list[Finding] = []
    for side in open_sides(approach, frame, around):
        found = limit_by_expansion(approach.moved(exact, side), around)
        if isinstance(found, str):
            raise Undecided(f"a printed number for a limit that is {found}")
        findings.append(_within(found, shown, around))
    if not findings:
        raise Undecided("the point is not in the domain")
    finding = of_parts(findings) or findings[-1]
    domain = f"as {approach.label} {approach.text}"
    return replace(finding, domain=domain, method=f"expansion near the limit; {finding.method}")


def _turned(relation: Relation, scope: Scope) -> list[tuple[Expr, PrintedNumber, str]]:
    """The exact side, the number printed with its decimals, and of matrices the entry's name."""
    relations = scope.relations(replace(relation, operator="="))
    columns = max(shape(scope.value(side))[1] for side in (relation.left, relation.right))
    for is_right, decimals in ((True, relation.right_decimals), (False, relation.left_decimals)):
        if decimals is None:
            continue
        counts = decimals if isinstance(decimals, tuple) else (decimals,)
        if len(counts) < len(relations):
            continue
        found = []
        for place, (rel, count) in enumerate(zip(relations, counts, strict=True)):
            exact, shown = (rel.left, rel.right) if is_right else (rel.right, rel.left)
            value = constant_value(shown)
            assert value is not None  # decimals are told of numbers alone
            name = f"({place // columns + 1}, {place % columns + 1})" if len(counts) > 1 else ""
            found.append((exact, PrintedNumber(value, count, not is_right), name))
        return found
    raise Undecided("neither side is a number as printed, with its digits, or a matrix of such")


def _naming(findings: Sequence[Finding], entries: Sequence[str]) -> Finding:
    """What stands against the whole, with the names of the entries of a matrix that are wrong."""
    found = of_parts(findings) or findings[-1]
    wrong = [name for name, each in zip(entries, findings, strict=True) if each.witness and name]
    if found.witness is None or found.witness.left.undefined or not wrong:
        return found
    first, *others = wrong
    note = f"entry {first}" + (f" (wrong too: {', '.join(others)})" if others else "")
    return replace(found, witness=replace(found.witness, note=note, shows=Shown.ENTRY))


def _within(exact: Expr, shown: PrintedNumber, frame: Frame) -> Finding:
    point = fixed_numbers(frame.conditions)
    if symbols_of(exact) <= set(point):
        found = _by_ball(exact, shown, point, frame)
        if found is not None:
            return found
    return _against_printed(finding_of(frame.decide(Statement(shown.bounds(exact)))), shown)


def _against_printed(found: Finding, shown: PrintedNumber) -> Finding:
    """The finding with its witness told of the number as printed, not of an end of its interval."""
    witness = found.witness
    if witness is None:
        return found
    value = next((side for side in (witness.left, witness.right) if side.undefined), None)
    if value is None:
        if is_long(witness.left) or is_long(witness.right):
            return found
        # what fails is low <= value or value <= high: the left side is below the number in the
        # first
        is_low = Fraction(witness.left.midpoint) < shown.value
        value = witness.right if is_low else witness.left
    # at a tie the value is an end of the interval, not the number as printed
    (left, right), note = shown.sides(value), shown.note()
    told = replace(witness, operator="approx", left=left, right=right, exact=False, note=note)
    reason = found.reason.replace(witness.text(), told.text())
    return replace(found, witness=told, reason=reason)


def _by_ball(
    exact: Expr, shown: PrintedNumber, point: Mapping[str, Fraction], frame: Frame
) -> Finding | None:
    """The finding where a ball lies inside the interval of the digits shown, or outside of it."""
    used = {n: v for n, v in point.items() if n in symbols_of(exact)}
    # a hypothesis that no value satisfies proves nothing, be it of another symbol
    outside = [n for n, v in point.items() if n in frame.boxes and not frame.boxes[n].holds(v)]
    if outside or len(point) != len(frame.conditions):
        return None
    try:
        ball = enclosed(exact, used, PRECISION)
    except (NoValue, Unresolved):
        return None
    with flint.ctx.workprec(PRECISION):
        above = ball - flint.arb(rational(shown.low))
        below = flint.arb(rational(shown.high)) - ball
    value = enclosure(ball, 15)
    where = {frame.labels.get(n, n): str(v) for n, v in used.items()}
    at = substituted(exact, {n: number(v) for n, v in used.items()})
    asked = statement_data(Statement(shown.bounds(at)), {}, None, {})
    certificate = {"checked": "replayed", "engine": "balls", "statement": asked}
    if frame.conditions:
        certificate["asked"] = _asked(shown.bounds(exact), frame)
    if above > 0 and below > 0:
        certificate |= {"point": where, "value": value.to_json(), "interval": shown.text()}
        reason = f"the exact value {value.midpoint} lies in the interval of the digits shown"
        return Finding("proved", reason, _text(where), METHOD, None, certificate)
    if above < 0 or below < 0:
        witness = Witness(where, "approx", *shown.sides(value), note=shown.note())
        reason = f"fails {witness.text()}"
        return Finding("refuted", reason, "nowhere", METHOD, witness, certificate)
    return None


def _text(where: Mapping[str, str]) -> str:
    return ", ".join(f"{n} = {v}" for n, v in where.items()) or "everywhere"


@dataclass(frozen=True)
class PrintedNumber:
    """A number with its decimals, fewer than none where its last digits are not shown; whether it
    is the left side.
    """

    value: Fraction
    decimals: int
    on_left: bool = False

    @property
    def half(self) -> Fraction:
        """Half a unit of the last digit."""
        return Fraction(1, 2) / Fraction(10) ** self.decimals

    @property
    def low(self) -> Fraction:
        """The lower end of the interval."""
        return self.value - self.half

    @property
    def high(self) -> Fraction:
        """The upper end."""
        return self.value + self.half

    @property
    def is_even(self) -> bool:
        """Whether the last digit is even."""
        units = self.value * Fraction(10) ** self.decimals
        return units.denominator != 1 or units.numerator % 2 == 0

    def bounds(self, exact: Expr) -> tuple[Rel, Rel]:
        """That an exact value lies in the interval, a tie with it where it may be rounded so."""
        low = "<=" if self.value > 0 or self.is_even else "<"
        high = "<=" if self.value < 0 or self.is_even else "<"
        return Rel(low, number(self.low), exact), Rel(high, exact, number(self.high))

    def sides(self, exact: Enclosure) -> tuple[Enclosure, Enclosure]:
        """Both sides for a witness, of the number the interval."""
        ball = Enclosure(str(float(self.value)), str(float(self.half)))
        return (ball, exact) if self.on_left else (exact, ball)

    def text(self) -> str:
        """`13/20 to 3/4`."""
        return f"{self.low} to {self.high}"

    def note(self) -> str:
        """What the digits stand for, in words."""
        if self.is_even:
            return f"the digits stand for {self.text()}"
        end = self.low if self.value < 0 else self.high
        return f"the digits stand for {self.text()}, {end} left out"


VALUE = Kind(
    "value",
    r"the printed number is the exact value rounded to the digits shown: `f \approx 0.382`; a tie "
    "is rounded away from zero or to the even digit: 0.65 to 0.7 or 0.6, but 0.75 to 0.8 only. Of "
    r"a matrix, `K \approx \begin{pmatrix} 0.56 \\ 0.22 \end{pmatrix}`, each entry is compared by "
    "its own digits; one without a point counts as exact as the others, `0` beside `0.25` is no "
    "0.4",
    judge_value,
    operators=frozenset(("=", "approx")),
    form=_lacks_number,
    rounded=True,
)
