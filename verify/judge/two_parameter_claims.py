"""Claims about settings with two parameters: decided over a chart, with witnesses in the source's
parameters.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import permutations

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.exact.ball_text import value_shown
from gainproof.verify.judge.exact.balls import Balls, enclosed
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, symbol, symbols_of, walk
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.polynomial import Poly, fraction, rational, univariate
from gainproof.verify.judge.exact.rational_points import try_points
from gainproof.verify.judge.exact.simplification import expression_of
from gainproof.verify.judge.exact.statement import (
    NOT_EVALUATED,
    STRICT,
    Enclosure,
    Outcome,
    Statement,
    Witness,
)
from gainproof.verify.judge.exact.total_expressions import divisors
from gainproof.verify.judge.exact.tower_building import build_tower
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.fixed_gain.decision import judge_free
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.catalogue import judge_reading
from gainproof.verify.judge.meaning.symbols import UndefinedSymbol
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.chart_decision import EQUAL
from gainproof.verify.judge.setting.environment import Environment, NotEstablished
from gainproof.verify.judge.verdict import Finding
from gainproof.verify.judge.verdict_words import LACKS_VALUE

KINDS = ("identity", "inequality", "monotone", "recursion")
"""What a chart helps to decide; limits are taken in the parameters themselves."""
BITS = 128
TRIED = tuple(
    sorted(
        {Fraction(p, q) for q in range(1, 5) for p in range(1, 13)},
        key=lambda x: (x.numerator + x.denominator, x),
    )
)


def judge_in(
    claim: Claim, reading: Reading | None, setting: Setting, environment: Environment
) -> Finding:
    """The finding on one reading. Raises Undecided, UndefinedSymbol, Malformed."""
    if environment.region is not None:
        return judge_free(claim, reading, setting, environment)
    chart = environment.chart
    if chart is None or claim.kind not in KINDS:
        return judge_reading(claim, reading, Scope(setting, environment, held=claim.held))
    try:
        scope = Scope(setting, chart, held=claim.held, plain=environment)
        found = judge_reading(claim, reading, scope)
    except Undecided:
        return judge_reading(claim, reading, Scope(setting, environment, held=claim.held))
    if found.verdict == "proved":
        return found
    at_points = replace(environment, chart=None, decide=_by_points)
    scope = Scope(setting, at_points, held=claim.held)
    at_points = replace(at_points, decide=partial(_by_points, named=partial(_named, scope)))
    seen = judge_reading(claim, reading, Scope(setting, at_points, held=claim.held))
    if seen.witness is None and found.reason == EQUAL:
        at_points = replace(at_points, decide=_as_equal)
        seen = judge_reading(claim, reading, Scope(setting, at_points, held=claim.held))
    if seen.witness is None:
        raise Undecided("false on a chart, but no rational point that shows it was found")
    reason = f"fails {seen.witness.text()}"
    if found.verdict == "conditional":
        reason += f"; holds exactly {seen.domain}"
        found = replace(found, domain=seen.domain)
    return replace(found, reason=reason, witness=seen.witness, reach=seen.reach)


def _named(scope: Scope, factor: Expr) -> str | None:
    """The symbol of the source that is zero where a factor is, if there is one."""
    for token, entry in scope.setting.symbols.items():
        if entry.definition is None or entry.shape is not None:
            continue
        graph = {"nodes": [["symbol", token]], "outputs": {"value": 0}}
        try:
            value = scope.expression(graph)
        except (Undecided, Malformed, UndefinedSymbol, NotEstablished):
            continue
        if is_zero_where(value, factor, scope.boxes()):
            return token
    return None


def _by_points(
    statement: Statement,
    boxes: Mapping[str, Box],
    labels: Mapping[str, str],
    named: Callable[[Expr], str | None] = lambda _: None,
) -> Outcome:
    """`refuted` at a point where it fails, else where a divisor is zero; without evidence `proved`:
    only what is known to be false is asked for.
    """
    found = try_points(statement, boxes, labels)
    if found is not None and found.witness is not None:
        return found
    exprs = [e for r in statement.relations for e in (r.left, r.right)]
    factors = list(divisor_factors(*exprs))
    for factor in factors:
        point = rational_zero(factor, boxes)
        witness = None if point is None else _without_value(statement, point, labels)
        if witness is not None:
            positive = ", ".join(f"{labels.get(n, n)} > 0" for n in sorted(point or {}))
            divisor = named(factor) or labelled(factor, labels)
            domain = f"for {positive}, where {divisor} is not zero"
            return Outcome("refuted", domain, "", "", witness)
    return Outcome("proved", "", "", "")


def _as_equal(statement: Statement, boxes: Mapping[str, Box], labels: Mapping[str, str]) -> Outcome:
    """The same for one relation that excludes equality, of sides that are known to be equal."""
    found = _by_points(statement, boxes, labels)
    strict = [rel for rel in statement.relations if rel.operator in STRICT]
    known = {name: box for name, box in boxes.items() if name in statement.symbols()}
    inside = all(box.holds(Fraction(1)) for box in known.values())
    if found.witness is not None or len(strict) != 1 or statement.domain or not inside:
        return found
    (rel,) = strict
    point = dict.fromkeys(sorted(known), Fraction(1))
    gap = enclosed(rel.left - rel.right, point, BITS)
    if not gap.contains(0):
        return found
    left, right = (_side(expr, point) for expr in (rel.left, rel.right))
    where = {labels.get(name, name): "1" for name in point}
    note = "the sides are equal, as they are everywhere"
    witness = Witness(where, rel.operator, left, right, exact=True, note=note)
    return Outcome("refuted", "", "", "", witness)


def _without_value(
    statement: Statement, point: Mapping[str, Fraction], labels: Mapping[str, str]
) -> Witness | None:
    for rel in statement.relations:
        left, right = (_side(expr, point) for expr in (rel.left, rel.right))
        if left.undefined or right.undefined:
            where = {labels.get(name, name): str(value) for name, value in point.items()}
            return Witness(where, rel.operator, left, right, note=LACKS_VALUE)
    return None


def _side(expr: Expr, point: Mapping[str, Fraction]) -> Enclosure:
    whole = dict.fromkeys(symbols_of(expr), Fraction(1)) | dict(point)
    found = value_shown(expr, Balls(whole, BITS))
    unknown = found.undefined == NOT_EVALUATED
    return replace(found, undefined="a divisor is zero") if unknown else found


def divisor_factors(*exprs: Expr) -> Iterator[Expr]:
    """Irreducible factors, polynomials in two symbols, of the divisors without roots."""
    seen: set[str] = set()
    for divisor in divisors(*exprs):
        if any(n.kind == "pow" and n.fraction.denominator != 1 for n in walk(divisor)):
            continue
        names = tuple(sorted(symbols_of(divisor)))
        try:
            element = build_tower([divisor], None, names, frozenset()).element(divisor)
        except Undecided:
            continue
        for factor, _ in element.num.factor()[1]:
            found = expression_of(factor, names)
            if len(symbols_of(found)) == 2 and str(factor) not in seen:
                seen.add(str(factor))
                yield found


def rational_zero(factor: Expr, boxes: Mapping[str, Box]) -> dict[str, Fraction] | None:
    """A point of the boxes with small numbers at which a polynomial in two symbols is zero."""
    for fixed, other in permutations(sorted(symbols_of(factor))):
        names = (fixed, other)
        p: Poly = build_tower([factor], None, names, frozenset()).element(factor).num
        for value in TRIED:
            if not boxes.get(fixed, Box()).holds(value):
                continue
            here = univariate(p.subs({p.context().names()[0]: rational(value)}), 1)
            for part, _ in here.factor()[1]:
                if part.degree() != 1:
                    continue
                root = -fraction(part[0]) / fraction(part[1])
                if boxes.get(other, Box()).holds(root):
                    return {fixed: value, other: root}
    return None


def is_zero_where(value: Expr, factor: Expr, boxes: Mapping[str, Box]) -> bool:
    """Whether an expression without roots is known to be zero where an irreducible factor is, and
    nowhere else in the boxes.
    """
    names = tuple(sorted(symbols_of(value, factor)))
    if any(n.kind == "pow" and n.fraction.denominator != 1 for n in walk(value)):
        return False
    try:
        tower = build_tower([value, factor], None, names, frozenset())
        factors = [part for part, _ in tower.element(value).num.factor()[1]]
        (wanted,) = (part for part, _ in tower.element(factor).num.factor()[1])
    except (Undecided, ValueError):
        return False
    others = [expression_of(part, names) for part in factors if part != wanted]
    own = [name for name in names if not boxes.get(name, Box()).holds(Fraction(0))]
    return len(others) < len(factors) and all(other in map(symbol, own) for other in others)
