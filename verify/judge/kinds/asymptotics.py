"""Asymptotics: f = a + b x + O(x^n), an order stated apart, and f ~ g."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.claim.record import Claim, OwnField
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import Expr, mul, neg, number, power, symbol, walk
from gainproof.verify.judge.exact.statement import Enclosure, Rel, Witness
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.claim_domain import framed
from gainproof.verify.judge.kinds.identity import resolved
from gainproof.verify.judge.kinds.kind import Kind, OwnFields
from gainproof.verify.judge.kinds.limit import DEPTHS
from gainproof.verify.judge.kinds.limit_neighbourhood import (
    Coefficients,
    constant_parts,
    open_sides,
    others_frame,
    with_values,
)
from gainproof.verify.judge.kinds.limit_point import (
    SMALL,
    Approach,
    approach_of,
    arrow_of,
    end_of,
    lacks_arrow,
    refuse_real_powers,
)
from gainproof.verify.judge.meaning.expansion import coefficients
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.series.expression_series import expanded
from gainproof.verify.judge.series.series import EXACT, Series, leading
from gainproof.verify.judge.verdict import Finding, finding_of, of_parts

METHOD = "expansion near the limit"
MOST_ORDER = 64
GAP = Fraction(1, 10**6)
"""Less than there is between two exponents of an expansion: denominators are those of roots."""


def _order(claim: OwnFields, name: str) -> OwnField | None:
    order = claim.fields.whole_number(name, 0, MOST_ORDER)
    return None if order is None else OwnField(number=order)


def judge_asymptotics(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether both sides agree to the order stated; without an order, whether their ratio tends to
    1 and, with an approximation, whether what is left is smaller than each of its terms: of 1 + x
    for a root of 1 + x the second is no term of it, nor of (1 + x)(1 - x). Undecided with one by a
    function that has another second term, such as 1/(1 + x): to which order is not said.
    """
    arrow, others = arrow_of(reading)
    relation = reading.relations[0]
    variable, point = scope.expression(arrow.left), end_of(arrow.right, scope)
    left, right = scope.expression(relation.left), scope.expression(relation.right)
    scope.refuse_moving(variable, left, right)
    frame = framed(claim, scope, resolved(others, scope))
    approach = approach_of(variable, point, frame)
    refuse_real_powers(left - right, frame)
    around, dropped = others_frame(frame, approach)
    (first, smaller), (second, errors) = _without_orders(left), _without_orders(right)
    rest = first + neg(second)
    if "order" in claim.own:
        errors.append(power(_distance(variable, approach), claim.own["order"].number))
    if not errors:
        smaller, errors = [], smaller
    if relation.operator == "=" and not errors:
        raise Undecided("asymptotics without an order: O(...) or the field `order` says it")
    parts = constant_parts(approach.name, left, right, *smaller, *errors)
    values = around.decide(with_values(parts))
    oracle = Coefficients(around, parts)
    approximated = relation.operator == "approx" and not errors
    findings: list[Finding] = []
    for side in open_sides(approach, frame, around):
        if errors:
            finding = _agree(rest, smaller, errors, approach, side, oracle)
        else:
            finding = _equivalent(left, right, approach, side, oracle)
        if finding.verdict == "proved" and approximated:
            finding = _beyond(rest, _terms(second), finding, approach, side, oracle)
        if finding.verdict != "proved" and dropped:
            raise Undecided("asymptotics under conditions on the variable: false without them")
        findings.append(finding)
        if finding.verdict == "refuted":
            break
    if (against := of_parts(findings)) is not None:
        return against
    if not findings:
        raise Undecided("the point is not in the domain")
    domain = f"as {approach.label} {approach.text}, {values.domain}".removesuffix(", everywhere")
    if values.verdict != "proved":
        return replace(finding_of(values), domain=domain)
    return replace(findings[-1], domain=domain)


def _distance(variable: Expr, approach: Approach) -> Expr:
    """What the power of a stated order is one of: the variable's own distance to its point."""
    if variable == symbol(approach.name):
        return approach.distance()
    raise Undecided("a stated order in a quantity: write it as O(...)")


def _without_orders(expr: Expr) -> tuple[Expr, list[Expr]]:
    """The expression without its O(...) terms, and what these are multiples of."""
    calls = {n.key: n for n in walk(expr) if n.kind == "call" and n.name == "order"}
    names = {key: f"order {k}" for k, key in enumerate(calls)}
    plain = rebuilt(expr, lambda node, _: symbol(names[node.key]) if node.key in names else None)
    errors = []
    for key, call in calls.items():
        known = coefficients(plain, names[key])
        if known is None or not set(known) <= {0, 1}:
            raise Undecided("an order inside anything but a sum of terms")
        errors.append(mul(known.get(1, number(0)), call.parts[0]))
        plain = known.get(0, number(0))
    if any(n.kind == "symbol" and n.name in names.values() for e in errors for n in walk(e)):
        raise Undecided("a product of orders")
    return plain, errors


def _agree(
    rest: Expr,
    smaller: list[Expr],
    errors: list[Expr],
    approach: Approach,
    side: int,
    oracle: Coefficients,
) -> Finding:
    """Whether what is left is of the order of the errors; so must be those printed on the left,
    `smaller`: x + O(x^3) = x + O(x), not the other way round.
    """
    order = min(_exponent(approach.moved(e, side), oracle) for e in errors)
    if any(_exponent(approach.moved(e, side), oracle) < order for e in smaller):
        raise Undecided("an O(...) on the left that is not of the order of that on the right")
    finding = _zero_below(rest, order, f"not {order}", approach, side, oracle)
    if finding is not None:
        return finding
    certificate = {"order": str(order), "terms below it": "all zero"}
    return Finding("proved", f"the difference is of order {order}", None, METHOD, None, certificate)


def _terms(expr: Expr) -> list[Expr]:
    """What is added, whatever brackets and signs stand round it."""
    if expr.kind not in ("add", "neg"):
        return [expr]
    return [term for part in expr.parts for term in _terms(part)]


def _beyond(
    rest: Expr,
    terms: list[Expr],
    first: Finding,
    approach: Approach,
    side: int,
    oracle: Coefficients,
) -> Finding:
    """Whether what is left is of higher order than the smallest term that is printed; `first` says
    that the first ones agree.
    """
    moved = [approach.moved(term, side) for term in terms]
    last = max(_last_exponent(term, oracle) for term in moved)
    if len(terms) == 1:
        following = _second_exponent(moved[0], oracle)
        if following is None and last == _exponent(moved[0], oracle):
            return first  # one power: it has no other term
        if following is not None:
            if _zero_below(rest, following + GAP, "", approach, side, oracle) is None:
                return first
            raise _another_second(following)
    words = f"not beyond that of the terms printed, {last}"
    finding = _zero_below(rest, last + GAP, words, approach, side, oracle)
    if finding is not None:
        return finding
    # a sum may hide that a function is wrong from its second term on: 1 + e^{3x} - 1 for e^{2x}
    for term in moved:
        following = None if _is_power(term) else _second_exponent(term, oracle)
        if following is None or following <= last:
            continue
        if _zero_below(rest, following + GAP, "", approach, side, oracle) is not None:
            raise _another_second(following)
    certificate = {"order of the last term": str(last), "terms up to it": "all zero"}
    reason = f"the difference is of higher order than {last}, that of the last term"
    return Finding("proved", reason, None, METHOD, None, certificate)


def _another_second(order: Fraction) -> Undecided:
    return Undecided(
        r"\approx with a function whose own second term, of order "
        rf"{order}, is another: write \sim, O(...) or an order"
    )


def _is_power(term: Expr) -> bool:
    """Whether products, quotients and powers are all that it is made of, at a glance."""
    zero = number(0)
    return not any(
        n.kind == "call" or (n.kind == "add" and sum(part != zero for part in n.parts) > 1)
        for n in walk(term)
    )


def _last_exponent(term: Expr, oracle: Coefficients) -> Fraction:
    """The order of the last of a printed term's own, if these end when it is multiplied out; else
    that of the first.
    """
    series = expanded(term, SMALL, oracle, DEPTHS[-1])
    if series.order >= EXACT and series.terms:
        return max(series.terms)
    return _exponent(term, oracle)


def _second_exponent(term: Expr, oracle: Coefficients) -> Fraction | None:
    """The order of a function's second term; None if its expansion ends."""
    for depth in DEPTHS:
        series = expanded(term, SMALL, oracle, depth)
        if series.order >= EXACT:
            return None
        first = leading(series, oracle)
        later = [e for e in series.exponents() if first is not None and e > first[0]]
        for exponent in later:
            if not oracle.is_zero(series.terms[exponent]):
                return exponent
    raise Undecided("an approximation by a function whose second term was not found")


def _zero_below(
    rest: Expr, order: Fraction, words: str, approach: Approach, side: int, oracle: Coefficients
) -> Finding | None:
    """Why what is left has a term below an order; None if it has none."""
    return of_parts(_coefficients(rest, order, words, approach, side, oracle))


def _coefficients(
    rest: Expr, order: Fraction, words: str, approach: Approach, side: int, oracle: Coefficients
) -> Iterator[Finding]:
    """Whether those of lower orders are zero."""
    series = _reaching(approach.moved(rest, side), oracle, order)
    for exponent in series.exponents():
        if exponent >= order:
            break
        outcome = oracle.frame.decide(with_values((), Rel("=", series.terms[exponent], number(0))))
        finding = finding_of(outcome)
        reason = f"the difference has a term of order {exponent}, {words}: {outcome.reason}"
        if outcome.witness is not None:
            note = f"coefficient of order {exponent} of the difference"
            where = {approach.label: approach.text, **outcome.witness.point}
            finding = replace(finding, witness=replace(outcome.witness, point=where, note=note))
        yield replace(finding, reason=reason, method=METHOD)


def _exponent(error: Expr, oracle: Coefficients) -> Fraction:
    """The order of an error term, in the distance to the limit."""
    for depth in DEPTHS:
        found = leading(expanded(error, SMALL, oracle, depth), oracle)
        if found is not None:
            return found[0]
    raise Undecided("an order of something that cancels")


def _reaching(expr: Expr, oracle: Coefficients, order: Fraction) -> Series:
    for depth in (Fraction(0), *DEPTHS):
        series = expanded(expr, SMALL, oracle, depth + abs(order))
        if series.order >= min(order, EXACT):
            return series
    raise Undecided("an expansion that cancels before the order stated")


def _equivalent(
    left: Expr, right: Expr, approach: Approach, side: int, oracle: Coefficients
) -> Finding:
    """Whether both sides have the same leading term."""
    firsts = []
    for expr in (left, right):
        found = None
        for depth in DEPTHS:
            found = leading(expanded(approach.moved(expr, side), SMALL, oracle, depth), oracle)
            if found is not None:
                break
        if found is None:
            raise Undecided("an expansion that cancels to the order reached")
        firsts.append(found)
    (e, c), (f, d) = firsts
    if e != f:
        where = {approach.label: approach.text}
        shown = [Enclosure("", "", f"of order {order}") for order in (e, f)]
        reason = f"the sides are of different orders, {e} and {f}, in the distance to the limit"
        witness = Witness(where, "sim", shown[0], shown[1], exact=True, note=reason)
        return Finding("refuted", reason, "nowhere", METHOD, witness)
    outcome = oracle.frame.decide(with_values((), Rel("=", c, d)))
    finding = finding_of(outcome)
    if outcome.verdict == "proved":
        return replace(finding, reason="both sides have the same leading term", method=METHOD)
    if outcome.witness is not None:
        where = {approach.label: approach.text, **outcome.witness.point}
        note = "the leading coefficients of both sides"
        finding = replace(finding, witness=replace(outcome.witness, point=where, note=note))
    return replace(finding, reason=f"other leading terms: {outcome.reason}", method=METHOD)


ASYMPTOTICS = Kind(
    "asymptotics",
    "the left side is the right one up to a term of higher order, where the condition with an "
    r"arrow says; after `\approx` the error is smaller than each term of a sum that is printed on "
    r"the right, after `\sim` the ratio tends to 1",
    judge_asymptotics,
    own={"order": _order},
    own_words="`order` of the error, if `O(x^2)` is not printed",
    operators=frozenset(("=", "approx", "sim")),
    form=lacks_arrow,
)
