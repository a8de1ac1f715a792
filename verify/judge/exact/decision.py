"""Decides statements with one real parameter completely, and identities in further free symbols.

The candidate points are the roots of the norms of every radicand, every denominator and, where a
comparison needs it, of the difference of its sides; the faces of the box are candidates too.
Between neighbouring candidates every relation is true everywhere or false everywhere, and at each
candidate it is decided exactly.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.exact.calculus import roots_made_prime, substituted
from gainproof.verify.judge.exact.expression import Expr, power, symbol, walk
from gainproof.verify.judge.exact.limits import DEFAULT_LIMITS, Limits, Undecided
from gainproof.verify.judge.exact.local import Local
from gainproof.verify.judge.exact.norm import vanishing_factors
from gainproof.verify.judge.exact.place import Box, Place, places, region_text
from gainproof.verify.judge.exact.poly import Poly
from gainproof.verify.judge.exact.statement import (
    ORDERS,
    Enclosure,
    Outcome,
    Rel,
    Statement,
    Witness,
    unstated,
)
from gainproof.verify.judge.exact.tower import NeedsPower, Tower, build_tower
from gainproof.verify.judge.exact.witness import (
    equal_sides_witness,
    find_witness,
    undefined_witness,
)

TRUE, FALSE, NO_VALUE, SKIPPED = "true", "false", "no value", "outside"


@dataclass
class Judged:
    """A place, what was found there, the tower there, and the relation that fails."""

    place: Place
    truth: str
    local: Local
    failing: Rel | None = None


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
    for _ in range(8):
        try:
            return _decide(statement, boxes, parameter, labels, limits)
        except NeedsPower as need:
            statement, boxes, labels = _with_power(statement, boxes, labels, need)
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


class _Work:
    """One tower, its boxes, and the places it is judged on."""

    def __init__(
        self,
        statement: Statement,
        boxes: Mapping[str, Box],
        parameter: str | None,
        labels: Mapping[str, str],
        limits: Limits,
    ) -> None:
        self.statement, self.boxes, self.labels = statement, boxes, labels
        free = tuple(sorted(name for name in boxes if name != parameter))
        positive = frozenset(name for name, box in boxes.items() if box.is_positive)
        self.differences = {
            rel: rel.left - rel.right for rel in (*statement.relations, *statement.conditions)
        }
        exprs = (*statement.exprs(), *self.differences.values())
        self.tower: Tower = build_tower(exprs, parameter, free, positive, limits)
        self.box = boxes[parameter] if parameter is not None else Box()
        self.factors: list[Any] = []
        self.split: set[Rel] = set()
        self.exclusions: list[str] = []
        for check in self.tower.checks:
            self.add_factors(check.poly)
        for rel in self.differences:
            if rel.operator != "=":
                self.split_by(rel)

    def add_factors(self, p: Poly) -> None:
        """The places are cut where p may vanish."""
        known = {tuple(int(c) for c in f.coeffs()) for f in self.factors}
        self.factors += [
            f
            for f in vanishing_factors(self.tower, p)
            if tuple(int(c) for c in f.coeffs()) not in known
        ]

    def split_by(self, rel: Rel) -> None:
        """The places are cut where the sides of this relation may be equal."""
        if rel not in self.split:
            self.split.add(rel)
            self.add_factors(self.tower.element(self.differences[rel]).num)

    def places(self) -> list[Place]:
        """All places of the parameter's box; one place if there is no parameter."""
        return [Place()] if self.tower.parameter is None else places(self.factors, self.box)


def _decide(
    statement: Statement,
    boxes: Mapping[str, Box],
    parameter: str | None,
    labels: Mapping[str, str],
    limits: Limits,
) -> Outcome:
    work = _Work(statement, boxes, parameter, labels, limits)
    while True:
        count = len(work.split)
        judged = []
        for place in work.places():
            if work.box.integer and parameter is not None and not place.holds_integer:
                continue
            judged.append(_judge_place(work, place))
        if len(work.split) == count:
            return _outcome(work, judged)


def _judge_place(work: _Work, place: Place) -> Judged:
    local = Local(work.tower, place)
    statement = work.statement
    if statement.connective == "if":
        for condition in statement.conditions:
            if local.undefined(condition.left, condition.right) is not None:
                return Judged(place, SKIPPED, local)
            if not _holds(work, local, condition, everywhere=False):
                return Judged(place, SKIPPED, local)
        for rel in statement.relations:
            if local.undefined(rel.left, rel.right, *statement.needed) is not None:
                return Judged(place, NO_VALUE, local, rel)
            _note_exclusions(work, local, rel)
        for rel in statement.relations:
            if not _holds(work, local, rel, everywhere=True):
                return Judged(place, FALSE, local, rel)
        return Judged(place, TRUE, local)
    if local.undefined(*statement.exprs()) is not None:
        return Judged(place, NO_VALUE, local, statement.relations[0])
    first = all(_holds(work, local, rel, everywhere=False) for rel in statement.relations)
    second = all(_holds(work, local, rel, everywhere=False) for rel in statement.conditions)
    good = first == second if statement.connective == "iff" else (second or not first)
    return Judged(place, TRUE if good else FALSE, local, None if good else statement.relations[0])


def _note_exclusions(work: _Work, local: Local, rel: Rel) -> None:
    """Divisors that vanish for some values of the free symbols only."""
    below = {side.key for side in _nodes(rel)}
    for check in work.tower.checks:
        if check.node.key not in below:
            continue
        involved = [
            n
            for n, i in zip(work.tower.free, work.tower.free_indices, strict=True)
            if check.poly.degrees()[i] > 0
        ]
        if not involved:
            continue
        try:
            local.sign(check.poly)
        except Undecided:
            if any(work.boxes[name].stated for name in involved):
                names = ", ".join(work.labels.get(n, n) for n in involved)
                raise Undecided(f"a divisor may vanish for some values of {names}") from None
            text = f"where the divisor {readable(work, check.poly)} is not zero"
            if text not in work.exclusions:
                work.exclusions.append(text)


def _nodes(rel: Rel) -> list[Expr]:
    return list(walk(rel.left, rel.right))


def readable(work: _Work, p: Poly) -> str:
    """A polynomial in the claim's own symbols."""
    shown = str(p)
    for place, name in zip(work.tower.free_indices, work.tower.free, strict=True):
        shown = shown.replace(work.tower.names[place], work.labels.get(name, name))
    return shown


def _holds(work: _Work, local: Local, rel: Rel, *, everywhere: bool) -> bool:
    """The truth of a relation at a place; `everywhere`: for all values of the free symbols.

    Otherwise (conditions) a relation that depends on the values of free symbols raises Undecided.
    """
    element = work.tower.element(work.differences[rel])
    equal = local.vanishes(element.num)
    if rel.operator == "=":
        if equal:
            return True
        if local.place.is_cell and rel not in work.split:
            # exact only once the cells are cut where the sides may be equal; the loop in _decide
            # comes back
            work.split_by(rel)
        if not everywhere and work.tower.free:
            local.sign(element.num)
        return False
    if equal:
        return rel.operator in ("<=", ">=")
    sign = local.sign(element.num) * local.sign(element.den)
    match rel.operator:
        case "<" | "<=":
            return sign < 0
        case ">" | ">=":
            return sign > 0
        case "!=":
            return True
        case _:
            raise Undecided(f"the relation {rel.operator} is not covered here")


def _outcome(work: _Work, judged: list[Judged]) -> Outcome:
    statement, name = work.statement, work.tower.parameter or ""
    label = work.labels.get(name, name)
    stated = work.tower.parameter is None or work.box.stated
    relevant = [j for j in judged if j.truth != SKIPPED and (stated or j.truth != NO_VALUE)]
    held = [j for j in relevant if j.truth == TRUE]
    failed = [j for j in relevant if j.truth != TRUE]
    certificate = _certificate(work, judged)
    if not relevant:
        if any(j.truth == NO_VALUE for j in judged):
            raise Undecided("the formula has no value anywhere on its domain")
        raise Undecided("the conditions hold nowhere on the domain")
    wide = [j for j in held if j.place.is_cell or work.tower.parameter is None]
    if not wide and held and _is_single(work, judged):
        wide = held
    domain = _domain_text(work, [j.place for j in held], label)
    method = _method(statement, work)
    if not failed:
        if not wide:
            raise Undecided("the formula has a value at isolated points only")
        return Outcome("proved", domain, "holds on the whole domain", method, None, certificate)
    witness, tried = _witness(work, failed)
    if wide:
        reason = f"fails {witness.text()}; holds exactly {domain}"
        return Outcome("conditional", domain, reason, method, witness, certificate, tried)
    reason = f"fails {witness.text()}" + (f"; holds only {domain}" if held else "")
    return Outcome(
        "refuted", domain if held else "nowhere", reason, method, witness, certificate, tried
    )


def _is_single(work: _Work, judged: list[Judged]) -> bool:
    """Whether the whole domain is one point, so that no cell could be found."""
    return len(judged) == 1 and work.box.lower is not None and work.box.lower == work.box.upper


def _domain_text(work: _Work, kept: list[Place], label: str) -> str:
    if work.tower.parameter is None:
        parts = []
    elif work.box.integer:
        parts = [f"for integers with {region_text(kept, label)}"]
    else:
        parts = [f"for {region_text(kept, label)}"]
    for name in work.tower.free:
        box = work.boxes[name]
        if box.lower is not None or box.upper is not None:
            parts.append(box.text(work.labels.get(name, name)))
    return ", ".join([*parts, *work.exclusions]) or "everywhere"


def _method(statement: Statement, work: _Work) -> str:
    if any(rel.operator in ORDERS for rel in statement.relations):
        return "signs on the cells of one parameter, end points decided exactly"
    if work.tower.roots:
        return "zero in a tower of radicals, branch decided by a ball"
    return "identity of polynomials"


def _witness(work: _Work, failed: list[Judged]) -> tuple[Witness, int]:
    """A counterexample, from intervals first."""
    integer = work.box.integer and work.tower.parameter is not None
    ordered = sorted(failed, key=lambda j: (j.truth == NO_VALUE, not j.place.is_cell))
    tried = 0
    for j in ordered:
        rel = j.failing or work.statement.relations[0]
        if j.truth == NO_VALUE:
            none = undefined_witness(j.local, rel, work.boxes, work.labels, integer)
            if none is not None:
                return none, tried + 1
            continue
        found = find_witness(j.local, rel, work.boxes, work.labels, integer)
        if found is not None:
            return found[0], tried + found[1]
        equal = j.local.vanishes(work.tower.element(work.differences[rel]).num)
        if equal and rel.operator in ("<", ">", "!="):
            return equal_sides_witness(j.local, rel, work.boxes, work.labels, integer), tried + 1
        if work.statement.connective != "if":
            sample = next(iter(_samples(j.place, integer)), None)
            note = "one side of the equivalence holds there and the other does not"
            point = (
                {}
                if sample is None
                else {work.labels.get(work.tower.parameter or "", ""): str(sample)}
            )
            none_ = Enclosure("", "", "not compared")
            return Witness(point, rel.operator, none_, none_, exact=True, note=note), tried + 1
    raise Undecided("the statement is false, but no rational point that shows it was found")


def _samples(place: Place, integer: bool) -> list[Fraction]:
    if integer:
        return [Fraction(n) for n in place.integers(1)]
    return list(place.samples[:1])


def _certificate(work: _Work, judged: list[Judged]) -> dict[str, Any]:
    """What another program needs to go through the same steps."""
    names = {
        work.tower.names[i]: n
        for i, n in zip(work.tower.free_indices, work.tower.free, strict=True)
    }
    if work.tower.parameter is not None:
        names["x"] = work.tower.parameter
    return {
        "checked": "replayed",
        "variables": {short: work.labels.get(full, full) for short, full in names.items()},
        "tower": work.tower.relations_text(),
        "candidates": [str(f) for f in work.factors],
        "places": [
            {
                "place": j.place.text(
                    work.labels.get(work.tower.parameter or "", work.tower.parameter or "")
                ),
                "samples": [str(s) for s in j.place.samples[:3]],
                "found": j.truth,
                "balls": list(dict.fromkeys(j.local.steps))[:20],
            }
            for j in judged
        ],
    }
