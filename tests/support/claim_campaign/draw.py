"""Points of a claim's domain, drawn at random; equations among its conditions are solved."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from random import Random
from typing import Any

import mpmath
from mutation.arithmetic import Misshapen, NoValue, real
from mutation.tree import symbols, to_tree

from claim_campaign import quantities
from claim_campaign.compare import holds, holds_all
from claim_campaign.drawn_numbers import any_number, parameter, small
from claim_campaign.free_filters import drawn_always, steady
from claim_campaign.point import DIGITS, NotCovered, Point
from claim_campaign.quantities import Place
from claim_campaign.solve import solved
from claim_campaign.subject import Rel, Subject, calls, rel

COMPARED = {"minimised", "compared"}
TRIES = 300
TRIES_EACH = 100


@dataclass(frozen=True)
class Domain:
    """`needed` are the tokens that want a value; `given` must hold, its equations solved."""

    subject: Subject
    needed: frozenset[str]
    given: tuple[Rel, ...]


def domain_of(subject: Subject, more: Iterable[Rel] = ()) -> Domain:
    """The domain that the claim states, its symbols state, and `more`."""
    claim = subject.claim
    given = [*map(rel, claim.domain), *more]
    for formula in claim.given:
        given += map(rel, formula.readings[0].relations)
    named = set().union(*(r.symbols() | calls(r.left) | calls(r.right) for r in given), set())
    for one in (*subject.relations(), *subject.conditions()):
        named |= one.symbols() | calls(one.left) | calls(one.right)
    for name in ("polynomial", *COMPARED):
        if name in claim.own:
            graph = claim.own[name].expression
            named |= symbols(to_tree(graph)) | calls(to_tree(graph))
    needed = subject.reached(named | drawn_always(subject.setting))
    for token in sorted(needed):
        given += map(rel, subject.setting.symbols[token].domain)
    return Domain(subject, frozenset(needed), tuple(given))


def points(domain: Domain, count: int, random: Random) -> list[Point]:
    """Up to `count` points of the domain; fewer where none were found."""
    found: list[Point] = []
    with mpmath.workdps(DIGITS):
        for point in _tried(domain, random):
            found.append(point)
            if len(found) == count:
                break
    return found


def _tried(domain: Domain, random: Random) -> Iterator[Point]:
    equations = [r for r in domain.given if r.operator == "="]
    named = set().union(*(e.symbols() for e in equations), set())
    unknowns = sorted(domain.subject.reached(named) & set(_free(domain)))
    for _ in range(TRIES):
        try:
            point = _drawn(domain, random)
            if point is None:
                continue
            if equations and not holds_all(equations, point):
                point = solved(equations, point, unknowns, random)
            if holds_all(domain.given, point):
                yield point
        except (NoValue, Misshapen):
            continue


def _free(domain: Domain) -> list[str]:
    symbols = domain.subject.setting.symbols
    drawn = drawn_always(domain.subject.setting)
    return sorted(t for t in domain.needed if symbols[t].role == "free" or t in drawn)


def _drawn(domain: Domain, random: Random) -> Point | None:
    """Symbols drawn one by one, each within the conditions that speak of it alone."""
    subject = domain.subject
    seed = random.randrange(10**6)
    place = Place(parameter(subject.setting, random), small(random), small(random), seed)
    point = _at_place(domain, place, {})
    for token in _free(domain):
        alone = [r for r in domain.given if r.symbols() == {token} and r.operator != "="]
        for _ in range(TRIES_EACH):
            value = real(any_number(random, subject.setting.symbols[token].integer))
            point = replace(point, values={**point.values, token: value})
            if all(holds(r, point) for r in alone):
                break
        else:
            return None
    if subject.setting.kind == "fixed_gain":
        point = _at_place(domain, place, {t: point.values[t] for t in _free(domain)})
        if not subject.claim.own.keys() & COMPARED and None in point.values.values():
            return None  # an unstable filter, of which the claim says nothing
    return replace(point, moved=_mover(domain, place, point.values))


def _at_place(domain: Domain, place: Place, free: Mapping[str, Any]) -> Point:
    subject = domain.subject
    match subject.setting.kind:
        case "steady_state":
            if subject.model is None:
                raise NotCovered("a model with symbols")
            known = quantities.steady(subject.model, place, subject.chosen)
        case "growing_memory":
            known = quantities.memory(subject.setting.degree or 0, place, subject.chosen)
        case "fixed_gain":
            known = steady(subject.setting, place, free)
        case "fading_memory" | "kalman_bucy":
            raise NotCovered("a filter that has tests against a batch and SciPy of its own")
        case _:
            known = {"sampling_interval": real(place.interval)}
            known["sample_number"] = real(int(place.parameter))
    values = dict(free)
    for token in domain.needed:
        entry = subject.setting.symbols[token]
        if entry.role == "quantity" and token not in free:
            values[token] = known.get(entry.quantity or "")
        elif entry.role == "undefined":
            raise NotCovered(f"{token} is undefined")
    return Point(values, subject.definitions())


def _mover(domain: Domain, place: Place, values: Mapping[str, Any]) -> Any:
    free = {token: values[token] for token in _free(domain)}

    def moved(token: str, value: Any) -> Point:
        entry = domain.subject.setting.symbols[token]
        if token in drawn_always(domain.subject.setting):
            point = _at_place(domain, place, {**free, token: value})
            return replace(point, moved=_mover(domain, place, point.values))
        if entry.role == "free":
            point = Point({**values, token: value}, domain.subject.definitions())
            return replace(point, moved=_mover(domain, place, point.values))
        usual = domain.subject.chosen.noise == "deviation"
        match entry.quantity:
            case "tracking_index" if usual:
                there = replace(place, parameter=fraction(value))
            case "sample_number" if value == int(value):
                origin = int(domain.subject.chosen.index_origin)
                there = replace(place, parameter=Fraction(int(value) - origin))
            case "sampling_interval":
                there = replace(place, interval=fraction(value))
            case "measurement_noise_deviation" if usual:
                there = replace(place, deviation=fraction(value))
            case _:
                raise NotCovered(f"{entry.quantity} moved")
        point = _at_place(domain, there, free)
        return replace(point, moved=_mover(domain, there, point.values))

    return moved


def fraction(value: Any) -> Fraction:
    """A multiprecision number, exactly."""
    sign, mantissa, exponent, _ = mpmath.mpf(value)._mpf_
    size = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return -size if sign else size
