"""Claims made false by their dimensions alone: anything in them multiplied by a symbol that is 1
and has a unit. Which of these are false is seen in other units of length and time, at one point.

An equation that is true at a point, and whose dimensions agree, stays true when every value is told
in other units. This needs the declared units and no rule of how dimensions combine.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

import mpmath
from mutation.arithmetic import Misshapen, NoValue
from mutation.tree import Tree, parts, to_graph, to_tree

from claim_campaign.compare import holds
from claim_campaign.draw import domain_of, points
from claim_campaign.point import DIGITS, NotCovered, Point
from claim_campaign.proved import own_model, single_readings
from claim_campaign.subject import Rel, Subject, calls
from gainproof.verify.judge.claim.file import read_claim_file
from gainproof.verify.judge.claim.record import Claim, Setting, SymbolEntry, Unit
from gainproof.verify.judge.convention_effect import choices, with_units
from gainproof.verify.judge.definition_reading import with_one_reading

KINDS = ("identity", "recursion", "definition")
FACTOR = "factor 1"
"""No name that a file can declare."""
SECOND, METRE = Unit(second=Fraction(1)), Unit(metre=Fraction(1))
SCALES = (Fraction(2), Fraction(3))
"""Metres and seconds told in smaller units; no product of small powers of both is 1."""
BINDERS = ("sum", "product", "integral", "family")


@dataclass(frozen=True)
class Mixed:
    """A claim and a setting of which one part is multiplied; `words` say which."""

    words: str
    claim: Claim
    setting: Setting


def equations(path: Path, models: Sequence[Mapping[str, Any]]) -> Iterator[Subject]:
    """The equations of a claim file, each under the first convention of its setting."""
    claim_file = read_claim_file(path)
    for claim in claim_file.claims:
        printed = claim_file.settings[claim.setting]
        if claim.kind not in KINDS or claim.formula is None or printed.matrices is not None:
            continue
        chosen = next(iter(choices(printed)))
        setting = with_units(next(iter(with_one_reading(printed)))[0], chosen)
        model = next((m for m in models if m["name"] == printed.model), None)
        if printed.own_model is not None:
            model = own_model(printed.own_model)
        one = single_readings(claim)[0]
        yield Subject(f"{path.stem} {claim.id}", one, setting, printed, "", chosen, model)


def is_slow(subject: Subject) -> bool:
    """Whether an integral is taken by numbers, which costs a second at each point."""
    named = {token for rel in subject.relations() for token in _names(rel)}
    bodies = [d.body for t, d in subject.definitions().items() if t in subject.reached(named)]
    sides = [side for rel in subject.relations() for side in (rel.left, rel.right)]
    return any("integral" in calls(tree) for tree in (*bodies, *sides))


def true_point(subject: Subject, random: Random) -> Point | None:
    """A point at which the equation is true, the new symbol being 1."""
    try:
        for point in points(domain_of(subject), 3, random):
            if all(holds(relation, point) for relation in subject.relations()):
                return replace(point, values={**point.values, FACTOR: mpmath.mpf(1)})
    except (NotCovered, Misshapen, NoValue, KeyError, ValueError, TypeError):
        pass
    return None


def is_mixed(subject: Subject, point: Point, unit: Unit) -> bool | None:
    """Whether an equation that is true at the point is false in other units; None if that is not
    seen.
    """
    values: dict[str, Any] = {}
    for token, value in point.values.items():
        entry = subject.setting.symbols.get(token)
        known = unit if token == FACTOR else None if entry is None else entry.unit
        if known is None or value is None:
            return None
        with mpmath.workdps(DIGITS):
            values[token] = _told(value, known)
    there = Point(values, subject.definitions())
    here = Point(point.values, subject.definitions())
    try:
        if not all(holds(relation, here) for relation in subject.relations()):
            return None
        return not all(holds(relation, there) for relation in subject.relations())
    except (NotCovered, Misshapen, NoValue, KeyError, ValueError, TypeError):
        return None


def _told(value: Any, unit: Unit) -> Any:
    if isinstance(value, list):
        return [_told(entry, unit) for entry in value]
    factor = mpmath.mpf(1)
    for scale, exponent in zip(SCALES, (unit.metre, unit.second), strict=True):
        power = mpmath.mpf(exponent.numerator) / exponent.denominator
        factor *= mpmath.mpf(scale.numerator) ** power
    return value * factor


def mixed(subject: Subject, unit: Unit) -> Iterator[Mixed]:
    """The claim with each part of its equation, and of each definition that it uses, multiplied by
    a symbol of the unit.
    """
    factor = SymbolEntry(FACTOR, "one, with a unit", "free", unit=unit)
    table = {**subject.setting.symbols, FACTOR: factor}
    setting = replace(subject.setting, symbols=table)
    claim = subject.claim
    assert claim.formula is not None
    (reading,) = claim.formula.readings
    for place, relation in enumerate(reading.relations):
        left = [
            (f"left: {words}", replace(relation, left=to_graph(tree)))
            for words, tree in _multiplied(to_tree(relation.left))
        ]
        right = [
            (f"right: {words}", replace(relation, right=to_graph(tree)))
            for words, tree in _multiplied(to_tree(relation.right))
        ]
        for words, changed in (*left, *right):
            relations = (*reading.relations[:place], changed, *reading.relations[place + 1 :])
            readings = (replace(reading, relations=relations),)
            formula = replace(claim.formula, readings=readings)
            yield Mixed(words, replace(claim, formula=formula), setting)
    named = {token for rel in subject.relations() for token in _names(rel)}
    for token in sorted(subject.reached(named)):
        entry = setting.symbols[token]
        if entry.definition is None:
            continue
        (reading,) = entry.definition.readings
        (relation,) = reading.relations
        for words, tree in _multiplied(to_tree(relation.right)):
            changed = replace(relation, right=to_graph(tree))
            readings = (replace(reading, relations=(changed,)),)
            other = replace(entry, definition=replace(entry.definition, readings=readings))
            within = replace(setting, symbols={**table, token: other})
            yield Mixed(f"definition of {token}: {words}", claim, within)


def _names(rel: Rel) -> set[str]:
    return rel.symbols() | calls(rel.left) | calls(rel.right)


def _multiplied(tree: Tree) -> Iterator[tuple[str, Tree]]:
    """Each part multiplied, matrices and bound names left out, and bases of powers whose exponent
    is a symbol: what dimension these have is not told by the judge.
    """
    bound = {p[3] for p, _ in parts(tree) if p[0] == "call" and p[1] in BINDERS}
    powers = [p for p, _ in parts(tree) if p[0] == "call" and p[1] == "power"]
    bound |= {part for power in powers for part, _ in parts(power[2])}
    for part, graft in parts(tree):
        if part in bound or part[0] in ("matrix", "transpose", "inverse", "kronecker"):
            continue
        yield f"{str(part)[:60]} multiplied", graft(("mul", ("symbol", FACTOR), part))
