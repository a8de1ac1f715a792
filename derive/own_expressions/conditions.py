"""What inputs fulfil together, as values that are at least a number.

`x**2 + y**2 > 0` is the value on its left, above 0; `a**2 < b**2` that of (b - a)(b + a), whose
factors are differences of exact numbers; `x*y > z + 2` is x y - z, at least 2; an equality is two:
its side is at least a number, and with a minus sign at least another.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction

import sympy as sp
from sympy.core.relational import Relational

from gainproof.derive.own_expressions.expressions import Condition, ExpressionError
from gainproof.derive.printer.kernel import Requirement

NAME = "condition"
KINDS = (sp.Gt, sp.Ge, sp.Lt, sp.Le, sp.Eq)
SMALLER = (sp.Lt, sp.Le)


@dataclass(frozen=True)
class Asked:
    """`value` over the inputs is at least what is required of the output of that name."""

    value: sp.Expr
    required: Requirement

    @property
    def positive(self) -> bool:
        """Whether the value is above 0 then."""
        return not str(self.required.least).startswith("-")


def asked(conditions: Sequence[Condition]) -> tuple[Asked, ...]:
    """All conditions of a kernel; ExpressionError for one that is none."""
    found = [each for condition in conditions for each in _values(condition)]
    return tuple(
        Asked(value, Requirement(f"{NAME}_{number}", meaning, least, single))
        for number, (value, meaning, least, single) in enumerate(found, 1)
    )


def relation_of(condition: Condition) -> Relational:
    """The relation; ExpressionError for what is none, or always or never holds."""
    given = sp.sympify(condition.relation)
    if given in (sp.true, sp.false):
        raise ExpressionError(f"a relation between inputs is wanted, this one is always {given}")
    if not isinstance(given, KINDS):
        raise ExpressionError(f"a relation with <, <=, >, >= or sp.Eq is wanted, {given!r} came")
    return given


def _values(condition: Condition) -> Iterator[tuple[sp.Expr, str, str, str]]:
    """Values, in words, and what each is at least in both formats."""
    given, words = relation_of(condition), condition.meaning
    left, right = given.args
    if isinstance(given, SMALLER) or (isinstance(given, sp.Eq) and left.is_number):
        left, right = right, left
    if isinstance(given, sp.Eq):
        yield from _equal(condition, left, right)
        return
    number, sign = right, 1
    if left.is_number:
        left, number, sign, words = -right, left, -1, f"{words} with a minus sign"
    elif not right.is_number:
        number, rest = (left - right).as_coeff_Add()
        left, number = (rest if number else sp.factor(rest)), -number
    if number == 0 and isinstance(given, (sp.Ge, sp.Le)):
        raise ExpressionError(f"{given}: of a value that may be 0 no digit is sure; write > or <")
    yield left, words, *_least(condition, number, sign)


def _equal(
    condition: Condition, left: sp.Expr, right: sp.Expr
) -> Iterator[tuple[sp.Expr, str, str, str]]:
    if condition.within is None:
        raise ExpressionError(
            f"{condition.relation}: rounded numbers are not equal; wanted: within, by how much the "
            'sides may differ in float64 and float32, such as ("1e-9", "1e-4")'
        )
    if not right.is_number:
        left, right = left - right, sp.Integer(0)
    middle, rooms = _rational(right), [Fraction(text) for text in condition.within]
    yield left, condition.meaning, *(_text(middle - room) for room in rooms)
    words = f"{condition.meaning} with a minus sign"
    yield -left, words, *(_text(-middle - room) for room in rooms)


def _least(condition: Condition, number: sp.Expr, sign: int) -> tuple[str, str]:
    double = _rational(number)
    single = double if condition.single is None else Fraction(condition.single)
    return _text(sign * double), _text(sign * single)


def _rational(number: sp.Expr) -> Fraction:
    if not isinstance(number, sp.Rational):
        raise ExpressionError(f"an exact number (sp.Rational) is wanted, {number} came")
    return Fraction(int(number.p), int(number.q))


def _text(value: Fraction) -> str:
    """As a decimal fraction where it is a short one."""
    decimal = Decimal(value.numerator) / Decimal(value.denominator)
    return f"{decimal.normalize():g}" if Fraction(decimal) == value else str(value)
