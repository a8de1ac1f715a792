"""A condition that a claim about stability lacks: a bound of a gain it does not speak of."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from gainproof.verify.judge.attempt import judge_claim
from gainproof.verify.judge.claim.record import OwnField
from gainproof.verify.judge.exact.expression import number, symbol, symbols_of
from gainproof.verify.judge.repair.edit import LARGE
from gainproof.verify.judge.repair.printed import Link, Printed
from gainproof.verify.judge.repair.proof import Offer, is_proved, reread, with_formula
from gainproof.verify.judge.repair.whole import Change, Step

if TYPE_CHECKING:
    from gainproof.verify.judge.repair.search import Search

BOUNDS = tuple(Fraction(n) for n in ("2", "1", "4", "1/2", "3/2", "3"))


def with_further_bound(search: Search) -> list[Offer]:
    """The claim with one bound more, if under the conditions it has the filter is stable exactly
    where this bound holds: then no weaker one would do. One offer at most.
    """
    claim = search.claim
    if (
        claim.kind != "stability"
        or claim.own["sense"].word != "sufficient"
        or search.formula.conditions
    ):
        return []
    said = (*claim.domain, *search.reading.relations)
    for bound in _bounds(search):
        formula = reread(bound, search.setting.symbols)
        if formula is None:
            continue
        own = {"sense": OwnField(word="exact")}
        exactly = replace(with_formula(claim, formula), own=own, domain=said)
        if judge_claim(exactly, search.setting, search.environment).verdict != "proved":
            continue
        found = _offered(search, bound)
        return [found] if found is not None else []
    return []


def _bounds(search: Search) -> Iterator[Printed]:
    region = search.environment.region
    labels = search.scope.labels()
    used = set().union(*[symbols_of(side) for side in search.formula.sides])
    for gain in () if region is None else region.gains:
        token = labels.get(gain, gain)
        if token in used or token not in search.setting.symbols:
            continue
        for operator in ("<", ">"):
            for value in BOUNDS:
                if search.is_late:
                    return
                yield Printed((symbol(token), number(value)), (Link(operator, 0, 1),))


def _offered(search: Search, bound: Printed) -> Offer | None:
    own = search.formula
    (link,) = bound.links
    place = len(own.sides)
    condition = replace(link, left=place, right=place + 1)
    both = Printed((*own.sides, *bound.sides), own.links, (condition,), own.connective)
    formula = reread(both, search.setting.symbols)
    if formula is None:
        return None
    if not is_proved(with_formula(search.claim, formula), search.setting, search.environment):
        return None
    step = Step("a condition is missing")
    return Offer(formula, Change(both, LARGE, (step,)), search.environment.name)
