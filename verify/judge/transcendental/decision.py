"""Decides statements that may hold exponentials, angles, symbolic powers and open sums.

Of angles with whole multiples of pi in them cos(k pi + x) is (-1)^k cos x for a whole number k.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from functools import partial

from gainproof.verify.judge.domain import bounded
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import Expr, mul, number, symbols_of, walk
from gainproof.verify.judge.exact.free_names import with_tokens
from gainproof.verify.judge.exact.rational_points import (
    failure_where,
    try_points,
    with_values,
    without_value,
)
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.exact.total_expressions import is_total
from gainproof.verify.judge.exact.work_limits import Nowhere, Undecided
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.meaning.base_variables import is_whole
from gainproof.verify.judge.transcendental import sign_changes, special_points
from gainproof.verify.judge.transcendental.absolute_values import by_sizes
from gainproof.verify.judge.transcendental.algebraic_form import bound_names, has_functions
from gainproof.verify.judge.transcendental.angle_equations import by_points, without_angles
from gainproof.verify.judge.transcendental.certificate import certificate_of
from gainproof.verify.judge.transcendental.changes_of_variable import in_other_variables
from gainproof.verify.judge.transcendental.domain_text import domain_text
from gainproof.verify.judge.transcendental.domain_with_values import (
    but_where_it_has,
    but_where_they_differ,
)
from gainproof.verify.judge.transcendental.free_values import (
    VALUED,
    freely,
    refuse_without_value,
    where_valued,
)
from gainproof.verify.judge.transcendental.function_variables import ANGLES, MINUS
from gainproof.verify.judge.transcendental.implications import put_in, restated
from gainproof.verify.judge.transcendental.induction import open_sums
from gainproof.verify.judge.transcendental.inequalities import rising
from gainproof.verify.judge.transcendental.monomials import (
    UNIT,
    Monomial,
    monomial_expr,
    monomials,
    terms_expr,
)
from gainproof.verify.judge.transcendental.pi import PI
from gainproof.verify.judge.transcendental.piecewise_decision import by_parts, jumps
from gainproof.verify.judge.transcendental.symbols_over_pi import scaled
from gainproof.verify.judge.transcendental.whole_numbers import (
    between_numbers,
    for_numbers,
    inductively,
)

NOWHERE = (special_points.without_value, sign_changes.without_value)
"""Searches for a point of stated domains where a side has no value."""
FURTHER = (sign_changes.fails_on_lines, special_points.equal_sides, sign_changes.equal_sides)
"""Searches for a point at which a statement fails, where it is not proved."""


def decided(
    statement: Statement,
    boxes: Mapping[str, Box],
    parameter: str | None,
    labels: Mapping[str, str],
    *,
    as_others: bool = True,
) -> Outcome:
    """The verdict on a statement. Raises Undecided. `as_others`: also by statements from which it
    follows.

    With functions in it: proved if it holds for whatever values these take, or by induction;
    refuted by balls at an exact point, or by the algebraic statement for one whole number.
    """
    labels = with_tokens(labels, statement.symbols())
    if not has_functions(statement):
        return settle(statement, boxes, parameter, labels)
    shown = between_numbers(statement, labels)
    if shown is not None:
        return shown
    if jumps(statement):
        return _without_jumps(statement, boxes, parameter, labels)
    statement = statement.mapped(lambda e: without_whole_turns(e, boxes))
    narrowed, where, more = valued(statement, boxes)
    found = _with_functions(narrowed, where, parameter, labels, as_others)
    if found.verdict == "proved" and (narrowed, where) != (statement, boxes):
        refuse_without_value(narrowed, where, parameter, labels)
    if more and found.verdict in ("proved", "conditional"):
        return replace(found, domain=where_valued(found.domain))
    return found


def _without_jumps(
    statement: Statement, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> Outcome:
    """Angles of points by these, and all else part by part. Raises Undecided."""

    def is_positive(expr: Expr) -> bool:
        try:
            rel = Rel(">", expr, number(0))
            return settle(Statement((rel,)), boxes, parameter, labels).verdict == "proved"
        except Undecided:
            return False

    plainer = statement.mapped(lambda e: without_angles(e, is_positive))
    if plainer != statement:
        found = decided(plainer, boxes, parameter, labels)
        return replace(found, certificate=certificate_of(statement, boxes, parameter, labels))
    try:
        return by_points(statement, boxes, parameter, labels, decided)
    except Undecided:
        return by_parts(statement, boxes, parameter, labels, decided)


def _with_functions(
    statement: Statement,
    boxes: Mapping[str, Box],
    parameter: str | None,
    labels: Mapping[str, str],
    as_others: bool,
) -> Outcome:
    reasons: list[str] = []
    stopped: type[Undecided] = Undecided
    tried: list[Outcome] = []
    sums = open_sums(statement)
    ways = [freely] if all(is_total(s.parts[0]) for s in sums) else []
    ways += [inductively] if sums else [partial(_restated, tried=tried)] if as_others else []
    ways.append(for_numbers)
    for attempt in ways:
        try:
            return attempt(statement, boxes, parameter, labels)
        except Undecided as reason:
            # the hypotheses of an induction and of other statements are their own
            stopped = Nowhere if attempt is freely and isinstance(reason, Nowhere) else stopped
            reasons.append(str(reason))
    # without conditions slopes tell more of a strict relation that is an equality at a point
    exactly = bool(statement.domain)
    nowhere = without_value(statement, boxes, labels)
    for search in NOWHERE if as_others else ():
        nowhere = nowhere or search(statement, boxes, labels)
    if nowhere is not None and as_others:
        as_it_stands = partial(decided, as_others=False)
        return but_where_it_has(nowhere, statement, boxes, parameter, labels, decided, as_it_stands)
    if nowhere is not None:
        return nowhere
    points = try_points(statement, boxes, labels, exactly=exactly)
    if points is None and (turned := scaled(statement, boxes, labels)).words:
        points = try_points(turned.statement, turned.boxes, turned.labels)
    if not sums and (points is None or points.verdict == "held"):
        try:
            return rising(statement, boxes, parameter, labels, freely)
        except Undecided as reason:
            reasons.append(str(reason))
    if points is None or points.verdict == "held":
        proved = _in_other_variables(statement, boxes, parameter, labels) if as_others else None
        proved = proved or by_sizes(statement, boxes, parameter, labels, decided)
        if proved is not None:
            return proved
        for witness in filter(None, (other.witness for other in tried)):
            if (fails := failure_where(witness, statement, boxes, labels)) is not None:
                return fails
        for search in FURTHER if as_others else ():
            if (fails := search(statement, boxes, labels)) is not None:
                return but_where_they_differ(fails, statement, boxes, parameter, labels, decided)
    if points is None:
        raise stopped("; ".join(dict.fromkeys(r for r in reasons if r)))
    return points


def _in_other_variables(
    statement: Statement, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> Outcome | None:
    def proves(other: Statement, where: Mapping[str, Box]) -> bool:
        try:
            return freely(other, where, parameter, labels).verdict == "proved"
        except Undecided:
            return False

    for other, where in in_other_variables(statement, boxes, proves):
        try:
            found = decided(other, where, parameter, labels, as_others=False)
        except Undecided:
            continue
        if found.verdict == "proved" and VALUED not in found.domain:
            return replace(
                found,
                domain=domain_text(statement, boxes, labels),
                method=f"in another variable; {found.method}",
                certificate=certificate_of(statement, boxes, parameter, labels, found.certificate),
                region=(),
            )
    return None


def _restated(
    statement: Statement,
    boxes: Mapping[str, Box],
    parameter: str | None,
    labels: Mapping[str, str],
    tried: list[Outcome],
) -> Outcome:
    """An implication by another statement from which it follows. Raises Undecided; what else came
    of such statements is added to those `tried`.
    """
    for other, where in restated(statement, boxes):
        try:
            found = decided(other, where, parameter, labels, as_others=False)
        except Undecided:
            continue
        if found.verdict == "proved":
            own = domain_text(statement, boxes, labels)
            certificate = certificate_of(statement, boxes, parameter, labels, found.certificate)
            domain = where_valued(own) if VALUED in found.domain else own
            return replace(found, domain=domain, certificate=certificate, region=())
        tried.append(found)
    put = put_in(statement, boxes)
    fails = None if put is None else try_points(put.within, boxes, labels, exactly=True)
    if put is None or fails is None or fails.verdict != "refuted" or fails.witness is None:
        raise Undecided("")
    values = {labels.get(name, name): value for name, value in put.values.items()}
    return replace(fails, witness=with_values(fails.witness, values, labels))


def without_whole_turns(expr: Expr, boxes: Mapping[str, Box]) -> Expr:
    """The same value, with signs in the place of half turns as often as a whole number says."""

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        if node.kind != "call" or node.name not in ANGLES or not is_total(parts[0]):
            return None
        try:
            terms = monomials(parts[0])
        except Undecided:
            return None
        whole = {m: c for m, c in terms.items() if c.denominator == 1 and _is_whole(m, boxes)}
        if not whole:
            return None
        left = {m: c for m, c in terms.items() if m not in whole}
        rest = Expr("call", node.name, (terms_expr(left) if left else number(0),))
        signs = [_sign(m) for m, c in whole.items() if c.numerator % 2 and node.name != "tan"]
        return mul(*signs, rest)

    return rebuilt(expr, change)


def _is_whole(monomial: Monomial, boxes: Mapping[str, Box]) -> bool:
    """Whether it is pi times what is a whole number."""
    rest = _without_pi(monomial)
    return (PI, 1) in monomial and bool(rest) and is_whole(monomial_expr(rest), boxes)


def _sign(monomial: Monomial) -> Expr:
    """(-1) to the whole number."""
    return Expr("call", "power", (MINUS, monomial_expr(_without_pi(monomial))))


def _without_pi(monomial: Monomial) -> Monomial:
    return frozenset(factor for factor in monomial if factor[0] != PI)


def valued(
    statement: Statement, boxes: Mapping[str, Box]
) -> tuple[Statement, Mapping[str, Box], bool]:
    """The statement where the arguments of its logarithms are positive, and whether that takes more
    than bounds of symbols to say.

    Of symbols that are in no stated domain a statement speaks only where every part has a value,
    so that it says the same as before.
    """
    calls = (node for node in walk(*statement.exprs()) if node.kind == "call")
    logarithms = [node for node in calls if node.name == "log"]
    if statement.connective != "if" or not logarithms:
        return statement, boxes, False
    over = bound_names(statement)
    wanted: list[Rel] = []
    where = dict(boxes)
    for (argument,) in dict.fromkeys(node.parts for node in logarithms):
        names = symbols_of(argument)
        unsaid = [n for n in names if not boxes.get(n, Box(stated=False)).stated]
        plain = not any(node.kind == "call" for node in walk(argument))
        if names and len(unsaid) == len(names) and plain and not names & over:
            where |= {n: boxes.get(n, Box(stated=False)) for n in names}
            wanted.append(_positive(argument))
    narrowed, left = bounded(where, wanted)
    if any(box.is_empty for box in narrowed.values()):
        return statement, boxes, False
    kept = {n: replace(box, stated=where[n].stated) for n, box in narrowed.items()}
    return replace(statement, given=(*statement.given, *left)), kept, bool(left)


def _positive(argument: Expr) -> Rel:
    """That it is positive; of a x + b as a bound of x."""
    plain = Rel(">", argument, number(0))
    try:
        terms = dict(monomials(argument))
    except Undecided:
        return plain
    rest = terms.pop(UNIT, Fraction(0))
    if len(terms) != 1:
        return plain
    ((monomial, factor),) = terms.items()
    if len(monomial) != 1:
        return plain
    ((base, exponent),) = monomial
    if base.kind != "symbol" or exponent != 1:
        return plain
    return Rel(">" if factor > 0 else "<", base, number(-rest / factor))
