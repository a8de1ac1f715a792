"""Statements about whole numbers: by induction, and one number after another."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.statement import Outcome, Statement, Witness
from gainproof.verify.judge.freed.domain_words import domain_text
from gainproof.verify.judge.freed.freely import VALUED, freely, where_valued
from gainproof.verify.judge.freed.induction import induction
from gainproof.verify.judge.freed.numbers import at_number, first_numbers
from gainproof.verify.judge.freed.rewriting import has_functions
from gainproof.verify.judge.hypothesis import settle
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
    """Refuted by the first whole numbers that a symbol may be, if it fails for one. Raises
    Undecided.
    """
    for name, value in first_numbers(statement, boxes):
        part = at_number(statement, name, value)
        if has_functions(part):
            continue
        try:
            found = settle(part, boxes, parameter, labels)
        except Undecided:
            continue
        if found.verdict in ("refuted", "conditional") and found.witness is not None:
            nowhere = found.witness.left.undefined or found.witness.right.undefined
            if nowhere and not boxes[name].stated:
                continue  # of a number without a value nothing is said
            point = {labels.get(name, name): str(value), **found.witness.point}
            witness: Witness = replace(found.witness, point=point)
            reason = f"fails {witness.text()}; where it may hold is not determined"
            certificate = {**found.certificate, DECIDES: found.verdict}
            refuted = replace(found, verdict="refuted", certificate=certificate, witness=witness)
            return replace(refuted, domain="", reason=reason)
    raise Undecided("")
