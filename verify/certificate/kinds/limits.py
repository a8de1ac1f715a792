"""Limits at the ends of a parameter's domain, and monotone maps onto an interval.

Every other parameter of the tower is held: a statement holds for each fixed value of theirs.
"""

from __future__ import annotations

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.boundary import Boundary, read_boundary
from gainproof.verify.certificate.checked_statement import Case
from gainproof.verify.certificate.derivative import derivative
from gainproof.verify.certificate.expression import Evaluation, Value
from gainproof.verify.certificate.graph import Graph
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.ratio import Ratio
from gainproof.verify.certificate.rejection import RejectedError
from gainproof.verify.certificate.tower import Tower
from gainproof.verify.certificate.variable import (
    require_end,
    require_increasing_bijection,
    running_parameter,
)


def limit(case: Case) -> str:
    """The expression tends to the value as the variable tends to 0 or to infinity.

    Claim: expression, variable (a parameter or an element that runs with it alone), point ("0" or
    "infinity"), value (a graph of numbers, roots and what does not depend on that parameter, or
    "infinity").
    Evidence: weights, constants, boundary, nonzero, and possibly form (a fraction equal to the
    expression, which shows what the expression's own does not).
    """
    claim = case.claims("expression", "variable", "point", "value")
    evidence = _evidences(case, "weights", "constants", "boundary", "nonzero")
    if claim["point"] not in ("0", "infinity"):
        raise RejectedError(f"{case.place}.claim.point: '0' or 'infinity' is wanted")
    at_infinity = claim["point"] == "infinity"
    variable = schema.name(claim["variable"], f"{case.place}.claim.variable")
    position = require_end(case.tower, variable, at_infinity)
    nonzero = case.nonzero(evidence["nonzero"])
    expression = case.expression(claim["expression"], "expression")
    value = case.evaluation(nonzero).scalar(expression)
    case.finish(nonzero)
    end: Plain = {key: evidence[key] for key in ("weights", "constants", "boundary")}
    form = _Form(case, value, evidence)
    _require_limit(case, form, end, (position, at_infinity), claim["value"], "value")
    form.finish()
    return "proved"


def increasing_onto(case: Case) -> str:
    """The expression increases strictly with the variable, from one value to another.

    As its parameter runs over its whole domain the expression runs over everything between the two
    values, each once; the value "from" is taken if and only if the domain is closed.
    Claim: expression, variable (a parameter, or an element that runs from 0 to infinity with it
    alone), from, to (values as in `limit`).
    Evidence: derivative (the derivative by the variable, manifestly positive away from a closed
    end), start, end (the evidence of the limits at the two ends of the domain), nonzero, and
    possibly form as in `limit`.
    """
    claim = case.claims("expression", "variable", "from", "to")
    evidence = _evidences(case, "derivative", "start", "end", "nonzero")
    variable = schema.name(claim["variable"], f"{case.place}.claim.variable")
    position = require_increasing_bijection(case.tower, variable)
    nonzero = case.nonzero(evidence["nonzero"])
    expression = case.expression(claim["expression"], "expression")
    value = case.evaluation(nonzero).scalar(expression)
    slope = derivative(case.tower, value, variable, nonzero)
    stated = case.fraction(evidence["derivative"], "derivative")
    if not slope.equals(stated.positive_along(case.tower.field, position)):
        raise RejectedError("the derivative does not equal the manifestly positive fraction")
    case.finish(nonzero)
    form = _Form(case, value, evidence)
    _require_limit(case, form, evidence["start"], (position, False), claim["from"], "from")
    _require_limit(case, form, evidence["end"], (position, True), claim["to"], "to")
    form.finish()
    return "proved"


def monotone(case: Case) -> str:
    """The expression increases (or decreases) strictly with the variable, all else held.

    Claim: expression, variable (a parameter, or an element that depends on one alone), trend
    ("increasing" or "decreasing").
    Evidence: derivative (the derivative by the variable, or its negative for "decreasing",
    manifestly positive away from a closed end of that parameter), nonzero.
    """
    claim = case.claims("expression", "variable", "trend")
    evidence = case.evidences("derivative", "nonzero")
    if claim["trend"] not in ("increasing", "decreasing"):
        raise RejectedError(f"{case.place}.claim.trend: 'increasing' or 'decreasing' is wanted")
    variable = schema.name(claim["variable"], f"{case.place}.claim.variable")
    position = running_parameter(case.tower, variable)
    nonzero = case.nonzero(evidence["nonzero"])
    expression = case.expression(claim["expression"], "expression")
    value = case.evaluation(nonzero).scalar(expression)
    slope = derivative(case.tower, value, variable, nonzero)
    stated = case.fraction(evidence["derivative"], "derivative")
    wanted = slope if claim["trend"] == "increasing" else -slope
    if not wanted.equals(stated.positive_along(case.tower.field, position)):
        raise RejectedError(
            "the derivative, or its negative, does not equal the manifestly positive fraction"
        )
    case.finish(nonzero)
    return "proved"


def _evidences(case: Case, *fields: str) -> dict[str, Plain]:
    """The evidence, which may have a form besides its fields."""
    given = schema.table(case.evidence, f"{case.place}.evidence")
    return case.evidences(*fields, "form") if "form" in given else case.evidences(*fields)


class _Form:
    """An expression's value, and the form that the evidence gives it where its own is mute."""

    def __init__(self, case: Case, value: Ratio, evidence: dict[str, Plain]) -> None:
        self._value = value
        self._form: Ratio | None = None
        self._needed = False
        if "form" in evidence:
            self._form = case.fraction(evidence["form"], "form").ratio(case.tower.field)
            if not value.equals(self._form):
                raise RejectedError("the form given does not equal the expression")

    def limit(self, boundary: Boundary) -> Ratio | None:
        """The limit, of the form only if the value itself does not show it."""
        try:
            return boundary.limit(self._value)
        except RejectedError:
            if self._form is None:
                raise
        self._needed = True
        return boundary.limit(self._form)

    def finish(self) -> None:
        """Reject a form that nothing needed."""
        if self._form is not None and not self._needed:
            raise RejectedError("the form given is not needed: the limit shows without it")


def _require_limit(
    case: Case,
    form: _Form,
    evidence: Plain,
    end: tuple[int, bool],
    stated: Plain,
    field: str,
) -> None:
    """Reject unless the expression tends to what the claim states at this end of a parameter."""
    place = f"{case.place}.evidence"
    boundary, finish = read_boundary(evidence, case.tower, end, place)
    found = form.limit(boundary)
    if stated == "infinity":
        if found is not None:
            raise RejectedError("the limit is finite, not infinity")
        finish(set())
        return
    wanted = _Held(case, boundary).scalar(case.expression(stated, field))
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


class _Held(Evaluation):
    """The value of a limit: numbers, roots found among the constants, and what is held.

    The names are the tower's; those of the evidence's constants mean nothing in a claim.
    """

    def __init__(self, case: Case, boundary: Boundary) -> None:
        tower = Tower(boundary.constants, {}, set())
        super().__init__(tower, case.with_tower(tower).no_fractions())
        self._case = case
        self._boundary = boundary

    def symbol(self, name: str) -> Ratio:
        return self._boundary.held(self._case.tower.value(name))

    def _derivative(self, value: Ratio, symbol: str) -> Ratio:
        del value, symbol
        raise RejectedError("a derivative stands in the value of a limit")

    def _at(self, graph: Graph, inner: int, symbol: str, new: Ratio) -> Value:
        del graph, inner, symbol, new
        raise RejectedError("a substitution stands in the value of a limit")
