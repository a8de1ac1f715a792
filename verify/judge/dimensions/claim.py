"""Dimensions of a claim: those of its formula, which choose between readings, and of all else that
it says or rests on.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from operator import methodcaller

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.claim_symbols import reached
from gainproof.verify.judge.dimensions.formula import (
    fault_of,
    graph_fault,
    in_said_units,
    names_of,
    number_beside_degrees,
    reading_fault,
    relation_fault,
)
from gainproof.verify.judge.dimensions.symbol_dimensions import has_degrees
from gainproof.verify.judge.formula import Formula, Graph, Reading, Relation
from gainproof.verify.judge.kinds.catalogue import kind_named

_NO = Fraction(0)


def claim_readings(claim: Claim, setting: Setting) -> tuple[tuple[Reading, ...], str | None]:
    """The readings of a claim's formula whose dimensions agree; if there is none, or if anything
    else of the claim mixes dimensions, no reading and what is wrong. A claim without a formula has
    no reading either.
    """
    readings: tuple[Reading, ...] = ()
    supposed = (r for formula in claim.given for r in formula.readings[0].relations)
    setting = in_said_units((*claim.domain, *supposed), setting)
    if claim.formula is not None:
        readings, fault = fitting_readings(claim.formula, setting)
        if fault is not None:
            return (), fault
    fault = next(_faults(claim, setting), None)
    return ((), f"dimensions: {fault}") if fault is not None else (readings, None)


def degrees_are_open(claim: Claim, setting: Setting) -> str | None:
    """Why dimensions do not refute a claim, or None where they may: a bare number stands beside an
    angle in degrees, `90 - \\theta`, and nothing else is wrong. It may count degrees or radians.
    """
    without = {
        token: entry if entry.unit is None else replace(entry, unit=replace(entry.unit, degree=_NO))
        for token, entry in setting.symbols.items()
    }
    if not has_degrees(setting) or claim_readings(claim, replace(setting, symbols=without))[1]:
        return None
    names = names_of(setting)
    if not any(number_beside_degrees(graph, names) for graph in _graphs(claim, setting)):
        return None
    return (
        "a bare number beside an angle in degrees may be one of degrees or of radians: declare the "
        "angle in rad and write \\pi/2 for 90 degrees"
    )


def _graphs(claim: Claim, setting: Setting) -> Iterator[tuple[Graph, ...]]:
    """The expressions of a claim and of definitions that it uses; sides of a relation together."""
    relations = [r for _, found in _relations(claim, setting) for r in found]
    for reading in () if claim.formula is None else claim.formula.readings:
        relations += [*reading.relations, *reading.conditions]
    yield from ((relation.left, relation.right) for relation in relations)
    for token in reached(claim, setting):
        entry = setting.symbols.get(token)
        if entry is not None and entry.definition is not None:
            yield from ((r.relations[0].right,) for r in entry.definition.readings)


def fitting_readings(formula: Formula, setting: Setting) -> tuple[tuple[Reading, ...], str | None]:
    """The readings of a formula whose dimensions agree; if there is none, what is wrong with each:
    of `4 a/b c` its author may have meant either.
    """
    told = [(reading, reading_fault(reading, setting)) for reading in likeliest_first(formula)]
    fitting = tuple(reading for reading, fault in reversed(told) if fault is None)
    wrong = "; read otherwise, ".join(dict.fromkeys(fault for _, fault in told if fault))
    return fitting, None if fitting else f"dimensions: {wrong}"


def likeliest_first(formula: Formula) -> tuple[Reading, ...]:
    """The readings in the order in which they are told where nothing chooses between them: in
    print `4 a/b c` mostly divides by `b c`, the last of its readings.
    """
    return tuple(reversed(formula.readings))


def _faults(claim: Claim, setting: Setting) -> Iterator[str]:
    """What is wrong in the fields of a claim, in its hypotheses, and in definitions that it uses
    through these or through domains.
    """
    names = names_of(setting)
    for each in claim.own.values():
        for graph in each.expressions:
            if (fault := graph_fault(graph, names)) is not None:
                yield f"in {each.place}, {fault}"
    for place, relations in _relations(claim, setting):
        for relation in relations:
            if (fault := relation_fault(relation, names)) is not None:
                yield f"in {place}, {fault}"
    yield from kind_named(claim.kind).units(claim, names)
    for token in sorted(reached(claim, setting)):
        if (fault := fault_of(methodcaller("of", token), names)) is not None:
            yield fault


def _relations(claim: Claim, setting: Setting) -> Iterator[tuple[str, tuple[Relation, ...]]]:
    yield "the domain", claim.domain
    for formula in claim.given:
        yield "a hypothesis", formula.readings[0].relations
    for each in claim.own.values():
        for formula in each.formulas:
            yield each.place, formula.readings[0].relations
        for name in each.filters:
            for formula in setting.filters.get(name, ()):
                yield f"the filter {name}", formula.readings[0].relations
