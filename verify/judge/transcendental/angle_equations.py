"""Sums of angles that numbers or points have: equations between them as equations of the points.

The angle of (x, y) is that of x + i y, the arc tangent of t that of 1 + i t, and angles add where
these are multiplied. A sum of angles less than a whole turn is 0 where the product is a positive
number.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from math import lcm

from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    div,
    mul,
    neg,
    number,
    power,
    walk,
)
from gainproof.verify.judge.exact.rational_points import failure_where
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.exact.total_expressions import is_total
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.reader.words import OF_CASES
from gainproof.verify.judge.transcendental.certificate import Decides, certificate_of
from gainproof.verify.judge.transcendental.domain_text import domain_text
from gainproof.verify.judge.transcendental.free_values import where_valued
from gainproof.verify.judge.transcendental.monomials import (
    Monomial,
    monomial_expr,
    monomials,
    ordered,
    terms_expr,
)
from gainproof.verify.judge.transcendental.pi import PARTS, PI, TURN, cosine_of

OF_POINTS = ("atan", "atan2")
MOST_MULTIPLE = 8
ZERO = number(0)
FULL = Fraction(2)

Pair = tuple[Expr, Expr]
Positive = Callable[[Expr], bool]


def point_of(angle: Expr) -> Pair:
    """x and y of the point whose angle it is."""
    if angle.name == "atan":
        return number(1), angle.parts[0]
    return angle.parts[1], angle.parts[0]


def turned(a: Pair, b: Pair) -> Pair:
    """The product of two points as complex numbers."""
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]


def multiple(point: Pair, times: int) -> Pair:
    """A power of a point whose absolute value is that of the point to the power of |times|."""
    total: Pair = (number(1), ZERO)
    for _ in range(abs(times)):
        total = turned(total, point)
    return total if times >= 0 else (total[0], neg(total[1]))


def angles_in(terms: Mapping[Monomial, Fraction]) -> dict[Expr, Fraction]:
    """The terms that are a number times an angle of a point."""
    found = {}
    for monomial, c in terms.items():
        if len(monomial) == 1:
            ((base, n),) = monomial
            if n == 1 and base.kind == "call" and base.name in OF_POINTS:
                found[base] = c
    return found


def without_angles(expr: Expr, is_positive: Positive) -> Expr:
    """Sines, cosines and tangents of sums with whole multiples of angles of points by those of the
    rest and of the points; the angle of (r cos t, r sin t) with a positive r by t.
    """

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        if node.kind != "call":
            return None
        if node.name == "atan2" and len(parts) == 2:
            found = _of_its_angle(*parts, is_positive) or _nearer(*parts, is_positive)
            # what is left out is still asked to have a value
            lost = [mul(ZERO, part) for part in parts if not is_total(part)]
            return add(found, *lost) if found is not None else None
        if node.name not in ("sin", "cos", "tan") or len(parts) != 1:
            return None
        try:
            terms = monomials(parts[0])
        except Undecided:
            return None
        angles = {a: c for a, c in angles_in(terms).items() if a.name == "atan2"}
        if not angles or any(c.denominator > 1 or abs(c) > MOST_MULTIPLE for c in angles.values()):
            return None
        rest = {m: c for m, c in terms.items() if m not in {frozenset([(a, 1)]) for a in angles}}
        unit: Pair = (number(1), ZERO)
        if rest:
            unit = (
                Expr("call", "cos", (terms_expr(rest),)),
                Expr("call", "sin", (terms_expr(rest),)),
            )
        for angle, c in angles.items():
            x, y = point_of(angle)
            radius = power(add(power(x, 2), power(y, 2)), Fraction(1, 2))
            unit = turned(unit, multiple((div(x, radius), div(y, radius)), int(c)))
        cosine, sine = unit
        return {"cos": cosine, "sin": sine}.get(node.name) or div(sine, cosine)

    return rebuilt(expr, change)


def _of_its_angle(y: Expr, x: Expr, is_positive: Positive) -> Expr | None:
    """t less the whole turns that leave it above -pi and at most pi."""
    try:
        above, right = monomials(y), monomials(x)
    except Undecided:
        return None
    if len(above) != 1 or len(right) != 1:
        return None
    ((m, a),), ((n, b),) = above.items(), right.items()
    for base, power_of in ordered(m):
        if base.kind != "call" or base.name != "sin" or power_of != 1 or a != b:
            continue
        cosine = Expr("call", "cos", base.parts)
        if m - {(base, 1)} == n - {(cosine, 1)} and (cosine, 1) in n:
            radius = number(a) * monomial_expr(m - {(base, 1)})
            if is_positive(radius):
                (t,) = base.parts
                turns = div(PI - t, 2 * PI)
                return t + 2 * PI * Expr("call", "floor", (turns,))
    return None


def _nearer(y: Expr, x: Expr, is_positive: Positive) -> Expr | None:
    """The angle of a point without a positive factor of both coordinates; None without one."""
    try:
        above, right = monomials(y), monomials(x)
    except Undecided:
        return None
    powers = [dict(ordered(m)) for m in (*above, *right)]
    shared = frozenset(
        (base, least)
        for base in (powers[0] if powers else {})
        if (least := min(p.get(base, 0) for p in powers)) and is_positive(base)
    )
    if not shared:
        return None
    factor = monomial_expr(shared)
    parts = (terms_expr(monomials(div(each, factor))) for each in (y, x))
    return Expr("call", "atan2", tuple(parts))


def by_points(
    statement: Statement,
    boxes: Boxes,
    parameter: str | None,
    labels: Mapping[str, str],
    decides: Decides,
) -> Outcome:
    """The verdict on equations between sums of angles, by their points. Raises Undecided."""

    def is_positive(expr: Expr) -> bool:
        return _is_proved(Rel(">", expr, ZERO))

    def _is_proved(rel: Rel) -> bool:
        try:
            found = decides(Statement((rel,), given=statement.domain), boxes, parameter, labels)
        except Undecided:
            return False
        return found.verdict == "proved"

    calls = (node for node in walk(*statement.exprs()) if node.kind == "call")
    if statement.connective != "if" or any(n.name.startswith(OF_CASES) for n in calls):
        raise Undecided("")
    relations: list[Rel] = []
    needed: list[Expr] = []
    for rel in statement.relations:
        made = _equation(rel, _is_proved) if rel.operator == "=" else None
        relations += [rel] if made is None else made[0]
        needed += [] if made is None else made[1]
    if relations == list(statement.relations):
        raise Undecided("")
    other = replace(
        statement, relations=tuple(relations), needed=(*statement.needed, *dict.fromkeys(needed))
    )
    found = decides(other, boxes, parameter, labels)
    certificate = certificate_of(statement, boxes, parameter, labels)
    method = f"angles by their points; {found.method}"
    if found.verdict == "proved":
        domain = domain_text(statement, boxes, labels)
        if any(not boxes.get(n, Box(stated=False)).stated for n in statement.symbols()):
            domain = where_valued(domain)
        return replace(found, domain=domain, method=method, certificate=certificate, region=())
    if (
        found.witness is not None
        and found.witness.left.undefined == found.witness.right.undefined is None
    ):
        fails = failure_where(found.witness, statement, boxes, labels)
        if fails is not None and found.verdict == "conditional":
            assert fails.witness is not None
            reason = f"fails {fails.witness.text()}; holds {found.domain}"
            return replace(
                found, witness=fails.witness, reason=reason, method=method, certificate=certificate
            )
        if fails is not None:
            return replace(fails, certificate=certificate)
    if found.witness is not None and found.verdict == "conditional":
        return replace(found, method=method, certificate=certificate)
    raise Undecided("angles of points that are not seen to be equal or not")


def _equation(rel: Rel, proved: Callable[[Rel], bool]) -> tuple[list[Rel], list[Expr]] | None:
    """What a sum of angles that is 0 says of the points, and what has to have values; None for any
    other equation, and where the sum may be a whole turn.
    """
    try:
        terms = monomials(rel.left - rel.right)
    except Undecided:
        return None
    angles = angles_in(terms)
    rest = set(terms) - {TURN} - {frozenset([(a, 1)]) for a in angles}
    if not angles or rest:
        return None
    scale = lcm(*(c.denominator for c in angles.values()))
    turns = terms.get(TURN, Fraction(0)) * scale
    whole = {angle: int(c * scale) for angle, c in angles.items()}
    twelfths = turns * PARTS
    if twelfths.denominator > 1 or sum(map(abs, whole.values())) > MOST_MULTIPLE:
        return None
    total: Pair = (cosine_of(int(twelfths)), cosine_of(int(twelfths) - PARTS // 2))
    for angle, times in whole.items():
        total = turned(total, multiple(point_of(angle), times))
    if not _is_below_a_turn(whole, turns, proved):
        return None
    needed = [each for side in (rel.left, rel.right) for each in _with_values(side)]
    return [Rel("=", total[1], ZERO), Rel(">", total[0], ZERO)], needed


def _with_values(side: Expr) -> list[Expr]:
    """What has to have values for a side to have one."""
    points = [n for n in walk(side) if n.kind == "call" and n.name in OF_POINTS]
    found = [rebuilt(side, lambda n, _: ZERO if n in points else None)]
    for node in points:
        x, y = point_of(node)
        found += [y] if node.name == "atan" else [div(number(1), add(power(x, 2), power(y, 2)))]
    return [each for each in found if not is_total(each)]


End = tuple[Fraction, bool]
"""A bound, over pi, and whether it is reached."""


def _is_below_a_turn(
    whole: Mapping[Expr, int], turns: Fraction, proved: Callable[[Rel], bool]
) -> bool:
    """Whether a sum of angles is seen to lie between -2 pi and 2 pi."""
    for narrow in (False, True):
        low, high = (turns, True), (turns, True)
        for angle, times in whole.items():
            first, last = _range(angle, proved if narrow else lambda _: False)
            ends = (first, last) if times > 0 else (last, first)
            low = low[0] + times * ends[0][0], low[1] and ends[0][1]
            high = high[0] + times * ends[1][0], high[1] and ends[1][1]
        if (low[0] > -FULL or low == (-FULL, False)) and (high[0] < FULL or high == (FULL, False)):
            return True
    return False


def _range(angle: Expr, proved: Callable[[Rel], bool]) -> tuple[End, End]:
    """Where an angle lies, by the signs of its point that are known."""
    half = Fraction(1, 2)
    x, y = point_of(angle)
    if angle.name == "atan" or proved(Rel(">", x, ZERO)):
        low, high = (-half, False), (half, False)
    elif proved(Rel("!=", y, ZERO)):
        low, high = (Fraction(-1), False), (Fraction(1), False)
    else:
        low, high = (Fraction(-1), False), (Fraction(1), True)
    if proved(Rel(">", y, ZERO)):
        return (Fraction(0), False), high
    if proved(Rel(">=", y, ZERO)):
        return (Fraction(0), True), high
    if proved(Rel("<", y, ZERO)):
        return low, (Fraction(0), False)
    if angle.name == "atan" and proved(Rel("<=", y, ZERO)):
        return low, (Fraction(0), True)
    return low, high
