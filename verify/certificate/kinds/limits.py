"""Limits at the ends of the parameter's domain, and monotone maps onto an interval."""

from __future__ import annotations

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.boundary import read_boundary
from gainproof.verify.certificate.case import Case
from gainproof.verify.certificate.derivative import derivative
from gainproof.verify.certificate.expression import Evaluation
from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.plain import Plain
from gainproof.verify.certificate.ratio import Ratio
from gainproof.verify.certificate.rejection import RejectedError
from gainproof.verify.certificate.tower import Tower
from gainproof.verify.certificate.variable import require_end, require_increasing_bijection


def limit(case: Case) -> str:
    """The expression tends to the value as the variable tends to 0 or to infinity.

    Claim: expression, variable (the parameter or an element that runs with it), point ("0" or
    "infinity"), value (a graph of numbers, or "infinity").
    Evidence: weights, constants, boundary, nonzero.
    """
    claim = case.claims("expression", "variable", "point", "value")
    evidence = case.evidences("weights", "constants", "boundary", "nonzero")
    if claim["point"] not in ("0", "infinity"):
        raise RejectedError(f"{case.place}.claim.point: '0' or 'infinity' is wanted")
    at_infinity = claim["point"] == "infinity"
    variable = schema.name(claim["variable"], f"{case.place}.claim.variable")
    require_end(case.tower, variable, at_infinity)
    nonzero = case.nonzero(evidence["nonzero"])
    expression = case.expression(claim["expression"], "expression")
    value = case.evaluation(nonzero).scalar(expression)
    case.finish(nonzero)
    end: Plain = {key: entry for key, entry in evidence.items() if key != "nonzero"}
    _require_limit(case, value, end, claim["value"], at_infinity, "value")
    return "proved"


def increasing_onto(case: Case) -> str:
    """The expression increases strictly with the variable, from one value to another.

    As the parameter runs over its whole domain the expression runs over everything between the two
    values, each once; the value "from" is taken if and only if the domain is closed.
    Claim: expression, variable (the parameter, or an element that runs from 0 to infinity with
    it), from, to (graphs of numbers, or "infinity").
    Evidence: derivative (the derivative by the variable, manifestly positive away from a closed
    end), start, end (the evidence of the limits at the two ends of the domain), nonzero.
    """
    claim = case.claims("expression", "variable", "from", "to")
    evidence = case.evidences("derivative", "start", "end", "nonzero")
    variable = schema.name(claim["variable"], f"{case.place}.claim.variable")
    require_increasing_bijection(case.tower, variable)
    nonzero = case.nonzero(evidence["nonzero"])
    expression = case.expression(claim["expression"], "expression")
    value = case.evaluation(nonzero).scalar(expression)
    slope = derivative(case.tower, value, variable, nonzero)
    stated = case.fraction(evidence["derivative"], "derivative").positive_inside(case.tower.field)
    if not slope.equals(stated):
        raise RejectedError("the derivative does not equal the manifestly positive fraction")
    case.finish(nonzero)
    _require_limit(case, value, evidence["start"], claim["from"], False, "from")
    _require_limit(case, value, evidence["end"], claim["to"], True, "to")
    return "proved"


def _require_limit(
    case: Case,
    value: Ratio,
    evidence: Plain,
    stated: Plain,
    at_infinity: bool,
    field: str,
) -> None:
    """Reject unless ``value`` tends to what the claim states at this end of the domain."""
    place = f"{case.place}.evidence"
    boundary, finish = read_boundary(evidence, case.tower, at_infinity, place)
    found = boundary.limit(value)
    if stated == "infinity":
        if found is not None:
            raise RejectedError("the limit is finite, not infinity")
        finish(set())
        return
    wanted = _constant(case, stated, boundary.constants, field)
    if found is None:
        raise RejectedError("the limit is infinity")
    if not found.equals(wanted):
        raise RejectedError("the limit is another one")
    finish(
        {
            i
            for i in range(boundary.constants.ring.size)
            if wanted.numerator.occurs(i) or any(factor.occurs(i) for factor in wanted.factors)
        }
    )


def _constant(case: Case, stated: Plain, constants: Field, field: str) -> Ratio:
    """The value of a graph of numbers; its roots are found among the constants."""
    tower = Tower(constants, {}, set())
    evaluation = _Constants(tower, case.with_tower(tower).no_fractions())
    return evaluation.scalar(case.expression(stated, field))


class _Constants(Evaluation):
    """Numbers and roots only: the names of the evidence's constants mean nothing in a claim."""

    def symbol(self, name: str) -> Ratio:
        raise RejectedError(f"the symbol {name!r} stands in the value of a limit")
