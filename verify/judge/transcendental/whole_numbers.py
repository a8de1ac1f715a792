"""Statements about whole numbers: by induction, and one number after another."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.rational_points import is_seen, try_points
from gainproof.verify.judge.exact.statement import Outcome, Statement, Witness
from gainproof.verify.judge.exact.work_limits import Nowhere, Undecided
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.transcendental.algebraic_form import has_functions
from gainproof.verify.judge.transcendental.certificate import certificate_of
from gainproof.verify.judge.transcendental.domain_text import domain_text
from gainproof.verify.judge.transcendental.free_values import VALUED, freely, where_valued
from gainproof.verify.judge.transcendental.induction import induction
from gainproof.verify.judge.transcendental.statements_at_numbers import at_number, first_numbers
from gainproof.verify.judge.verdict_words import DECIDES


def inductively(
    statement: Statement, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> Outcome:
    """Proved by induction over the number up to which it has sums. Raises Undecided."""
    certificate = {}
    domain = domain_text(statement, boxes, labels)
    for words, part, where in induction(statement, boxes):
        plain = not has_functions(part)
        work = settle if plain else freely
        found = work(part, where, parameter, labels)
        if found.verdict != "proved":
            raise Undecided(f"an induction fails {words}, which refutes nothing: {found.reason}")
        certificate[words] = dict(found.certificate)
        domain = where_valued(domain) if VALUED in found.domain else domain
    return Outcome("proved", domain, "holds on the whole domain", "induction", None, certificate)


def for_numbers(
    statement: Statement, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> Outcome:
    """Refuted by the first whole numbers that a symbol may be, if it fails for one, or proved for
    all where they are few. Raises Undecided.
    """
    for name, values, are_all in first_numbers(statement, boxes):
        label, proofs, is_proved = labels.get(name, name), {}, are_all
        for value in values:
            part = at_number(statement, name, value)
            if has_functions(part) and not are_all:
                continue
            try:
                work = _with_functions if has_functions(part) else settle
                found = work(part, boxes, parameter, labels)
            except Nowhere:
                continue  # the conditions are those of other numbers
            except Undecided:
                is_proved = False
                continue
            if found.verdict == "proved" and VALUED not in found.domain:
                proofs[f"{label} = {value}"] = dict(found.certificate)
                continue
            is_proved = False
            refuted = _refuted(found, label, value, boxes[name])
            if refuted is not None:
                return refuted
        if is_proved and proofs:
            domain = domain_text(statement, boxes, labels)
            reason, method = "holds for each of the whole numbers", "one whole number after another"
            return Outcome("proved", domain, reason, method, None, proofs)
    raise Undecided("")


def _with_functions(
    statement: Statement, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> Outcome:
    """At one whole number: what holds no symbol any more is told by balls. Raises Undecided."""
    if not statement.symbols():
        found = between_numbers(statement, labels) or try_points(statement, boxes, labels)
        if found is not None:
            return found
    return freely(statement, boxes, parameter, labels)


def between_numbers(statement: Statement, labels: Mapping[str, str]) -> Outcome | None:
    """The proof of inequalities without symbols that balls show."""
    if statement.symbols() or statement.connective != "if" or statement.domain or statement.needed:
        return None
    if not all(map(is_seen, statement.relations)):
        return None
    certificate = certificate_of(statement, {}, None, labels)
    reason = "both sides are numbers, which balls tell apart"
    return Outcome("proved", "everywhere", reason, "balls round both sides", None, certificate)


def _refuted(found: Outcome, label: str, value: int, box: Box) -> Outcome | None:
    """The refutation by what was found for a whole number, if it is one."""
    if found.verdict not in ("refuted", "conditional") or found.witness is None:
        return None
    if (found.witness.left.undefined or found.witness.right.undefined) and not box.stated:
        return None  # of a number without a value nothing is said
    point = {label: str(value), **found.witness.point}
    witness: Witness = replace(found.witness, point=point)
    reason = f"fails {witness.text()}; where it may hold is not determined"
    certificate = {**found.certificate, DECIDES: found.verdict}
    refuted = replace(found, verdict="refuted", certificate=certificate, witness=witness)
    return replace(refuted, domain="", reason=reason)
