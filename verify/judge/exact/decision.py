"""Decides statements with one real parameter completely, and identities in further free symbols."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.exact.box import Box, bounds_text
from gainproof.verify.judge.exact.calculus import roots_made_prime, substituted
from gainproof.verify.judge.exact.certificate import certificate_of
from gainproof.verify.judge.exact.expression import power, symbol
from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.exact.radicands import NeedsPower
from gainproof.verify.judge.exact.region_text import region_text
from gainproof.verify.judge.exact.statement import (
    ORDERS,
    STRICT,
    Outcome,
    Statement,
    Witness,
    unstated,
)
from gainproof.verify.judge.exact.truth import NO_VALUE, SKIPPED, TRUE
from gainproof.verify.judge.exact.truth_survey import Judged, Work, survey
from gainproof.verify.judge.exact.witness import (
    equal_sides_witness,
    find_witness,
    free_values,
    point_text,
    sides_witness,
    undefined_witness,
)
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Limits, Nowhere, Undecided


def decide(
    statement: Statement,
    boxes: Mapping[str, Box],
    parameter: str | None,
    labels: Mapping[str, str] | None = None,
    limits: Limits = DEFAULT_LIMITS,
) -> Outcome:
    """The verdict on a statement; all symbols but `parameter` are free. Raises Undecided."""
    labels = labels or {}
    statement = statement.mapped(roots_made_prime)
    boxes = {name: boxes.get(name, unstated()) for name in statement.symbols()}
    if parameter is not None:
        boxes.setdefault(parameter, unstated())
    for name, box in boxes.items():
        if box.is_empty:
            raise Undecided(f"the domain of {labels.get(name, name)} is empty")
    roots: list[tuple[str, str, int]] = []
    for _ in range(8):
        try:
            work = Work(statement, boxes, parameter, labels, limits)
            return _in_symbols(_outcome(work, survey(work)), roots)
        except NeedsPower as need:
            shown = labels.get(need.name, need.name)
            statement, boxes, labels = _with_power(statement, boxes, labels, need)
            roots.append((labels[f"{need.name} root"], shown, need.order))
    raise Undecided("roots of roots of free symbols nest too deeply")


def _with_power(
    statement: Statement, boxes: Mapping[str, Box], labels: Mapping[str, str], need: NeedsPower
) -> tuple[Statement, dict[str, Box], dict[str, str]]:
    """A positive symbol replaced by a power of a new positive symbol, which is a bijection of the
    positive numbers.
    """
    new = f"{need.name} root"
    box = boxes[need.name]
    if box.upper is not None or box.lower != 0:
        raise Undecided(f"a root of {need.name}, whose domain is not all positive numbers")
    changed = statement.mapped(
        lambda e: substituted(e, {need.name: power(symbol(new), need.order)})
    )
    kept = {name: b for name, b in boxes.items() if name != need.name}
    shown = labels.get(need.name, need.name)
    return changed, {**kept, new: box}, {**labels, new: f"({shown})^(1/{need.order})"}


def _in_symbols(outcome: Outcome, roots: Sequence[tuple[str, str, int]]) -> Outcome:
    """The outcome told in symbols of which roots were taken for symbols: `roots` are these roots in
    words, what they are roots of, and their orders. q > 0 for q^(1/2) > 0, q = 4 where that is 2.
    """
    for root, symbol_, order in reversed(roots):
        domain = outcome.domain.replace(f"{root} > 0", f"{symbol_} > 0")
        outcome = replace(outcome, domain=domain)
        witness = outcome.witness
        if witness is None or root not in witness.point:
            continue
        try:
            value = str(Fraction(witness.point[root]) ** order)
        except ValueError:  # a number that is not rational
            continue
        point = {
            symbol_ if n == root else n: value if n == root else v for n, v in witness.point.items()
        }
        told = replace(witness, point=point)
        reason = outcome.reason.replace(witness.text(), told.text())
        outcome = replace(outcome, witness=told, reason=reason)
    return outcome


def _outcome(work: Work, judged: list[Judged]) -> Outcome:
    statement, name = work.statement, work.tower.parameter or ""
    label = work.labels.get(name, name)
    stated = work.tower.parameter is None or work.box.stated
    relevant = [j for j in judged if j.truth != SKIPPED and (stated or j.truth != NO_VALUE)]
    held = [j for j in relevant if j.truth == TRUE]
    failed = [j for j in relevant if j.truth != TRUE]
    certificate = certificate_of(work, judged)
    if not relevant:
        if any(j.truth == NO_VALUE for j in judged):
            raise Undecided("the formula has no value anywhere on its domain")
        raise Nowhere
    wide = [j for j in held if j.place.is_cell or work.tower.parameter is None]
    if not wide and held and _is_single(work, judged):
        wide = held
    region = tuple(j.place for j in held) if work.tower.parameter is not None else ()
    domain = _domain_text(work, [j.place for j in held], label)
    method = _method(statement, work)
    if not failed:
        if not wide and not _only_points(judged):
            raise Undecided("the formula has a value at isolated points only")
        reason = "holds on the whole domain"
        return Outcome("proved", domain, reason, method, None, certificate, region=region)
    witness, tried = _witness(work, failed)
    if wide:
        reason = f"fails {witness.text()}; {_extent(work)} {domain}"
        return Outcome("conditional", domain, reason, method, witness, certificate, tried, region)
    reason = f"fails {witness.text()}" + (f"; holds only {domain}" if held else "")
    where = domain if held else "nowhere"
    return Outcome("refuted", where, reason, method, witness, certificate, tried, region)


def _extent(work: Work) -> str:
    return "holds at least" if work.inexact else "holds exactly"


def _is_single(work: Work, judged: list[Judged]) -> bool:
    """Whether the whole domain is one point, so that no cell could be found."""
    return len(judged) == 1 and work.box.lower is not None and work.box.lower == work.box.upper


def _only_points(judged: list[Judged]) -> bool:
    """Whether the conditions leave single points only, as an equation among them does."""
    return all(j.truth == SKIPPED for j in judged if j.place.is_cell)


def _domain_text(work: Work, kept: list[Place], label: str) -> str:
    if work.tower.parameter is None:
        parts = []
    elif work.box.integer:
        parts = [f"for integers with {region_text(kept, label, integer=True)}"]
    else:
        parts = [f"for {region_text(kept, label)}"]
    parts += bounds_text({name: work.boxes[name] for name in work.tower.free}, work.labels)
    return ", ".join([*parts, *work.exclusions]) or "everywhere"


def _method(statement: Statement, work: Work) -> str:
    if any(rel.operator in ORDERS for rel in statement.relations):
        return "signs on the cells of one parameter, end points decided exactly"
    if work.tower.roots:
        return "zero in a tower of radicals, branch decided by a ball"
    return "identity of polynomials"


def _witness(work: Work, failed: list[Judged]) -> tuple[Witness, int]:
    """A counterexample; of a real variable from intervals first."""
    integer = work.box.integer and work.tower.parameter is not None
    ordered = sorted(
        failed, key=lambda j: (j.truth == NO_VALUE, not integer and not j.place.is_cell)
    )
    tried = 0
    for j in ordered:
        rel = j.failing or work.statement.relations[0]
        if j.truth == NO_VALUE:
            none = undefined_witness(j.local, rel, work.boxes, work.labels, integer)
            if none is not None:
                return none, tried + 1
            continue
        if work.statement.connective != "if":
            sample = next(iter(_samples(j.place, integer)), None)
            free = next(free_values(work.tower.free, work.boxes), ())
            point = point_text(j.local, sample, free, work.labels)
            return sides_witness(work.statement, j.local, point), tried + 1
        found = find_witness(j.local, rel, work.boxes, work.labels, integer)
        if found is not None:
            return found[0], tried + found[1]
        equal = j.local.vanishes(work.tower.element(work.differences[rel]).num)
        if equal and rel.operator in STRICT:
            return equal_sides_witness(j.local, rel, work.boxes, work.labels, integer), tried + 1
    raise Undecided("the statement is false, but no rational point that shows it was found")


def _samples(place: Place, integer: bool) -> list[Fraction]:
    if integer:
        return [Fraction(n) for n in place.integers(1)]
    return list(place.samples[:1])
