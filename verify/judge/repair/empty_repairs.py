"""Repairs that are true and empty: that follow from the hypotheses of the claim alone, whatever its
symbols mean, or in which a symbol cancels of which the claim speaks.
"""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.exact.expression import symbols_of
from gainproof.verify.judge.exact.polynomial import Ball
from gainproof.verify.judge.exact.work_limits import Malformed
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.repair.formula_values import Values, truth
from gainproof.verify.judge.repair.printed_formula import Link, Printed, printed
from gainproof.verify.judge.repair.sharp_bounds import ORDERS
from gainproof.verify.judge.repair.trivial_formulas import OffTheModel, sorted_key

LEAST_KNOWN = 3
"""So many values of a difference show that it stays as it is."""
LEAST_INSIDE = 8
"""So many points where hypotheses hold show what follows from them."""
TURNED = {">": "<", ">=": "<="}
WEAKER = {"<": ("<=", "!="), "=": ("<=",)}


class Empty:
    """Which changed formulas say nothing of the model, or nothing of what a claim speaks of.

    `off` are points off the model of the claim, `formula` is the claim as printed.
    """

    def __init__(self, claim: Claim, formula: Printed, off: OffTheModel) -> None:
        self._has_symbols = any(symbols_of(side) for side in formula.sides)
        self._cancelled = cancelled(formula, off)
        self._hypotheses, self._off = hypotheses_of(claim), off

    def is_empty(self, changed: Printed) -> bool:
        """Whether a changed formula is; what cancels in the claim as printed may cancel in it."""
        trivial = self._has_symbols and self._off.is_trivial(changed)
        if trivial or follows(changed, self._hypotheses, self._off):
            return True
        return not cancelled(changed, self._off) <= self._cancelled


def hypotheses_of(claim: Claim) -> tuple[Printed, ...]:
    """What a claim says beside its formula of where it holds."""
    readings = [Reading(tuple(claim.domain)), *(f.readings[0] for f in claim.given)]
    try:
        return tuple(printed(reading) for reading in readings if reading.relations)
    except Malformed:
        return ()


def follows(formula: Printed, hypotheses: Sequence[Printed], off: OffTheModel) -> bool:
    """Whether what the formula claims is among its hypotheses, or is seen to hold wherever these
    do with symbols of any values.
    """
    if formula.connective != "if":
        return False
    stated = {said for h in hypotheses for said in _said(h, h.links)}
    stated |= set(_said(formula, formula.conditions))
    if not stated:
        return False
    stated |= {(weak, a, b) for strong, a, b in stated for weak in WEAKER.get(strong, ())}
    stated |= {(op, b, a) for op, a, b in stated if op == "!="}
    if stated >= set(_said(formula, formula.links)):
        return True
    inside = [v for v in off.many if _all_hold(v, formula, hypotheses)]
    if len(inside) < LEAST_INSIDE or not off.names:
        return False
    return all(truth(values, formula) is True for values in inside)


def cancelled(formula: Printed, off: OffTheModel) -> frozenset[str]:
    """Symbols on both sides of an inequality on which the difference of its sides does not depend:
    it says nothing of them.
    """
    return frozenset(
        name
        for link in formula.links
        if link.operator in ORDERS
        for name in symbols_of(formula.sides[link.left]) & symbols_of(formula.sides[link.right])
        if _cancels(name, formula, link, off)
    )


def _cancels(name: str, formula: Printed, link: Link, off: OffTheModel) -> bool:
    known = 0
    for values, other in off.moved(name):
        before, after = (_gap(at, formula, link) for at in (values, other))
        if before is None or after is None:
            continue
        if not (before - after).contains(0):
            return False
        known += 1
    return known >= LEAST_KNOWN


def _gap(values: Values, formula: Printed, link: Link) -> Ball | None:
    a, b = values.ball(formula.sides[link.left]), values.ball(formula.sides[link.right])
    return None if a is None or b is None else a - b


def _all_hold(values: Values, formula: Printed, hypotheses: Sequence[Printed]) -> bool:
    if truth(values, formula, formula.conditions) is not True:
        return False
    return all(truth(values, one) is True for one in hypotheses)


def _said(formula: Printed, links: Sequence[Link]) -> list[tuple[str, bytes, bytes]]:
    """Relations in a form that is the same for terms in any order, and for a > b and b < a."""
    found = []
    for link in links:
        left, right = (sorted_key(formula.sides[n]) for n in (link.left, link.right))
        if link.operator in TURNED:
            found.append((TURNED[link.operator], right, left))
        else:
            found.append((link.operator, left, right))
    return found
