"""Printed numbers that are wrong: the exact value rounded to as many digits."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.exact.ball_text import is_long
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.kinds.catalogue import kind_named
from gainproof.verify.judge.repair.edits import PLAIN
from gainproof.verify.judge.repair.printed_formula import Link, Printed
from gainproof.verify.judge.repair.tree_construction import opposite
from gainproof.verify.judge.repair.whole_formula import Change, Step
from gainproof.verify.judge.verdict import Finding

FEW = 2
"""So many digits that mean something are kept, if so many are printed."""
MOST_DECIMALS = 30
Judge = Callable[[Printed], Finding | None]


def rounded(claim: Claim, formula: Printed, judge: Judge) -> Iterator[Change]:
    """The claim with each wrong number replaced, found from the witnesses against them one after
    the other.
    """
    steps: tuple[Step, ...] = ()
    for _ in formula.links:
        finding = judge(formula)
        if finding is None or finding.verdict == "proved" or finding.witness is None:
            break
        link = _failing(formula, finding)
        if link is None:
            break
        side, decimals = link
        if is_long(finding.witness.left):
            break
        exact = Fraction(finding.witness.left.midpoint)
        before = formula.sides[side]
        decimals = _shown(exact, before, decimals)
        after = _written(exact, decimals)
        formula = _with_decimals(formula.with_side(side, after), side, decimals)
        steps = (*steps, Step("a printed number", before, after))
    if steps and kind_named(claim.kind).rounded:
        yield Change(formula, PLAIN, steps)


def _failing(formula: Printed, finding: Finding) -> tuple[int, int] | None:
    """The side that shows the number of the witness, and its decimals."""
    assert finding.witness is not None
    shown = finding.witness.right
    if finding.witness.left.undefined or shown.undefined:
        return None
    for link in formula.links:
        for side, decimals in _numbers(link):
            value = constant_value(formula.sides[side])
            if value is not None and float(value) == float(shown.midpoint):
                return side, decimals
    return None


def _numbers(link: Link) -> Iterator[tuple[int, int]]:
    for side, decimals in ((link.right, link.right_decimals), (link.left, link.left_decimals)):
        if isinstance(decimals, int):
            yield side, decimals


def _shown(exact: Fraction, before: Expr, decimals: int) -> int:
    """The decimals of the printed number; more where these show of the true one fewer digits than
    were printed, and fewer than `FEW`.
    """
    printed = constant_value(before) or Fraction(0)
    digits = min(FEW, len(str(abs(round(printed * 10**decimals)))))
    needed = decimals
    while abs(exact) * 10**needed < 10 ** (digits - 1) and needed < MOST_DECIMALS:
        needed += 1
    return needed


def _with_decimals(formula: Printed, side: int, decimals: int) -> Printed:
    def changed(link: Link) -> Link:
        left, right = link.left_decimals, link.right_decimals
        return replace(
            link,
            left_decimals=decimals if link.left == side and left is not None else left,
            right_decimals=decimals if link.right == side and right is not None else right,
        )

    return replace(formula, links=tuple(map(changed, formula.links)))


def _written(exact: Fraction, decimals: int) -> Expr:
    value = Fraction(round(exact * Fraction(10) ** decimals)) / Fraction(10) ** decimals
    size = number(abs(value))
    return size if value >= 0 else opposite(size)
