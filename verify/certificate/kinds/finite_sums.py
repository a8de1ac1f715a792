"""Finite sums in closed form, by induction."""

from __future__ import annotations

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.checked_statement import Case
from gainproof.verify.certificate.generator import lifted
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.polynomial import Polynomial
from gainproof.verify.certificate.rejection import RejectedError


def finite_sum(case: Case) -> str:
    """The sum of the summand over index = start, ..., upper equals the closed form.

    For every integer ``upper`` in the parameter's domain: the closed form grows by the summand from
    upper - 1 to upper, and both agree at the start, as polynomials.
    Claim: index (a new name), start (integer as text), upper (a parameter with "from"),
    summand (in the index, not in the upper limit), closed. Evidence: none, an empty record.
    """
    claim = case.claims("index", "start", "upper", "summand", "closed")
    case.evidences()
    place = f"{case.place}.claim"
    index = schema.name(claim["index"], f"{place}.index")
    start = schema.number(claim["start"], f"{place}.start")
    upper = schema.name(claim["upper"], f"{place}.upper")
    position = case.tower.parameter_position(upper)
    if case.tower.field.generators or position is None:
        raise RejectedError(f"{place}.upper: a parameter of a tower without generators is wanted")
    parameter = case.tower.field.parameters[position]
    if start.denominator != 1 or not parameter.closed or parameter.lower < start:
        raise RejectedError(f"{place}: the upper limit must run from an integer start on")
    extended = case.tower.with_free((index,))
    ring = extended.field.ring
    summand = _polynomial(case.with_tower(extended), claim["summand"], "summand")
    closed = lifted(_polynomial(case, claim["closed"], "closed"), ring)
    if summand.occurs(position):
        raise RejectedError(f"{place}.summand: the upper limit occurs in it")
    variable = ring.variable(position)
    index_position = ring.size - 1
    first = ring.constant(start)
    growth = closed - closed.substitute(position, variable - ring.constant(1))
    if growth != summand.substitute(index_position, variable):
        raise RejectedError("the closed form does not grow by the summand")
    if closed.substitute(position, first) != summand.substitute(index_position, first):
        raise RejectedError("the closed form at the start is not the first summand")
    return "proved"


def _polynomial(case: Case, value: Plain, field: str) -> Polynomial:
    evaluation = case.evaluation(case.no_fractions())
    result = evaluation.scalar(case.expression(value, field))
    if result.factors:
        raise RejectedError(f"{case.place}.claim.{field}: a polynomial is wanted")
    return result.numerator
