"""Offers that say the same: one equation is the other times a number or a factor."""

from __future__ import annotations

from fractions import Fraction

import flint

from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.repair.expansion import Terms, expanded
from gainproof.verify.judge.repair.formula_values import PRECISION
from gainproof.verify.judge.repair.number_recognition import common_rational
from gainproof.verify.judge.repair.printed_formula import Printed
from gainproof.verify.judge.repair.trivial_formulas import OffTheModel


def same_equation(a: Printed, b: Printed, off: OffTheModel) -> bool:
    """Whether left - right of one is a number times that of the other, or left over right is the
    same in both, shown exactly and whatever the symbols stand for.
    """
    if any(len(f.links) != 1 or f.links[0].operator != "=" or f.conditions for f in (a, b)):
        return False
    first, second = _difference(a), _difference(b)
    if _proportional(expanded(first), expanded(second)):
        return True
    ratio = _ratio(first, second, off)
    if ratio is not None and _identical(first, number(ratio) * second):
        return True
    (left, right), (other_left, other_right) = _ends(a), _ends(b)
    crossed = left * other_right, other_left * right
    return _ratio(*crossed, off) == 1 and _identical(*crossed)


def _proportional(first: Terms, second: Terms) -> bool:
    """Whether one is a number times the other; a derivative has no value off the model."""
    if first.keys() != second.keys():
        return False
    return len({size / second[monomial] for monomial, size in first.items()}) == 1


def _identical(first: Expr, second: Expr) -> bool:
    try:
        return settle(Statement((Rel("=", first, second),)), {}, None, {}).verdict == "proved"
    except (Undecided, Malformed):
        return False


def _ends(formula: Printed) -> tuple[Expr, Expr]:
    link = formula.links[0]
    return formula.sides[link.left], formula.sides[link.right]


def _difference(formula: Printed) -> Expr:
    left, right = _ends(formula)
    return left - right


def _ratio(first: Expr, second: Expr, off: OffTheModel) -> Fraction | None:
    found = []
    for values in off.values:
        a, b = values.ball(first), values.ball(second)
        if a is not None and b is not None and not b.contains(0):
            with flint.ctx.workprec(PRECISION):
                found.append(a / b)
    return common_rational(found) if len(found) > 2 else None
