"""Limits: of algebraic expressions in one variable, and by expansion in several."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.domain import box_conditions
from gainproof.verify.judge.exact.box import Box, bounds_text
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of, walk
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.limit import decide_limit
from gainproof.verify.judge.exact.limit_value import NoValueNear
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.statement import Enclosure, Outcome, Rel, Statement, Witness
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.claim_domain import Frame, framed
from gainproof.verify.judge.kinds.conditions_for_values import where_valued
from gainproof.verify.judge.kinds.identity import resolved
from gainproof.verify.judge.kinds.kind import Kind
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
    End,
    approach_of,
    arrow_of,
    end_of,
    lacks_arrow,
    refuse_real_powers,
)
from gainproof.verify.judge.kinds.monotone_quantities import is_one_way
from gainproof.verify.judge.reader.latex_printer import graph_to_latex
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.series.expression_series import expanded
from gainproof.verify.judge.series.logarithmic import WithLogarithms, by_powers
from gainproof.verify.judge.series.series import Series, leading
from gainproof.verify.judge.setting.environment import INDEX, POSITIVE
from gainproof.verify.judge.verdict import Finding, finding_of, of_parts

DEPTHS = (Fraction(3), Fraction(8), Fraction(16))
OPEN = {">=": ">"}
"""Where a root stays one nearby."""


def judge_limit(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether the left side tends to the right one where the arrow says."""
    arrow, others = arrow_of(reading)
    relation = reading.relations[0]
    if relation.operator not in ("->", "="):
        raise Undecided(f"the relation {relation.operator} in a limit is not covered")
    variable, point = scope.expression(arrow.left), end_of(arrow.right, scope)
    expr, claimed = scope.expression(relation.left), end_of(relation.right, scope)
    used = [expr] if isinstance(claimed, str) else [expr, claimed]
    frame = framed(claim, scope, resolved(others, scope))
    is_pair = bool(scope.environment.pair) and variable.kind == "symbol"
    if is_pair and scope.is_shared(variable.name, *used):
        expr, claimed, frame = _unfolded(expr, claimed, frame, scope)
    else:
        scope.refuse_moving(variable, *used)
    try:
        return _near(expr, claimed, variable, point, frame)
    except Undecided as reason:
        if is_pair or isinstance(point, str) or isinstance(claimed, str):
            raise
        label = graph_to_latex(arrow.left)
        try:
            return _by_value(expr, claimed, variable, point, frame, label)
        except Undecided:
            raise reason from None


def _near(expr: Expr, claimed: End, variable: Expr, point: End, frame: Frame) -> Finding:
    """By what the expression is near the point. Raises Undecided."""
    approach = approach_of(variable, point, frame)
    if not isinstance(claimed, str) and approach.name in symbols_of(claimed):
        raise Undecided("a limit that holds the variable itself: say it as asymptotics")
    single = symbols_of(expr) <= {approach.name} and not frame.conditions
    if single and (isinstance(claimed, str) or not symbols_of(claimed)):
        try:
            return finding_of(_algebraic(expr, approach, claimed))
        except Undecided as reason:
            if isinstance(reason, NoValueNear) or not _has_calls(expr):
                raise
    return _by_expansion(expr, approach, claimed, frame)


def _by_value(
    expr: Expr, claimed: Expr, variable: Expr, point: Expr, frame: Frame, label: str
) -> Finding:
    """By the value at the point, which the limit is where no divisor and nothing under a root is
    zero there. The variable, or the tracking index if it is the intensity of the noise, rises or
    falls with one base variable throughout, while all others stay. Raises Undecided.
    """
    environment = frame.environment
    is_noise = environment.intensity and variable == environment.assigned[environment.intensity]
    moving = tidied(environment.quantities[INDEX] if is_noise else variable)
    names = symbols_of(moving)
    others = symbols_of(claimed, point, *(s for c in frame.conditions for s in (c.left, c.right)))
    if len(names) != 1 or names & others or frame.boxes[min(names)].integer or _has_calls(expr):
        raise Undecided("more than one variable, or a function that is not continuous at a glance")
    if not is_one_way(moving, names, frame):
        raise Undecided("a variable that does not rise or fall with one other throughout")
    if symbols_of(point):
        # else nothing would be said where the point is not in the domain
        positive = (Rel(">", point, number(0)),) if is_noise else ()
        if not is_noise and moving.kind != "symbol":
            raise Undecided("a point that is not fixed, of a quantity")
        inside = positive or box_conditions(moving.name, point, frame.boxes[moving.name])
        if inside and not frame.holds(*inside):
            raise Undecided("a point that may lie outside of the domain")
    there = replace(frame, conditions=(*frame.conditions, Rel("=", variable, point)))
    needed = [replace(r, operator=OPEN.get(r.operator, r.operator)) for r in where_valued(expr)]
    if not there.holds(*needed, Rel("=", variable, variable)):
        raise Undecided("not seen to be continuous at the point")
    found = finding_of(there.decide(Statement((Rel("=", expr, claimed),))))
    end = f"-> {labelled(point, frame.labels)}"
    method = f"value at the point; {found.method}"
    if found.verdict == "proved":
        stay = _where_others_stay(symbols_of(expr, claimed, point) - names, frame)
        reason, domain = "the limit is the claimed one", f"as {label} {end}{stay}"
        return replace(found, reason=reason, domain=domain, method=method)
    return replace(_on_the_way(found, label, end), method=method)


def _where_others_stay(names: Iterable[str], frame: Frame) -> str:
    """What is stated of all but the variable, in words after the arrow."""
    own = frame.environment.boxes
    conditions = [c for c in frame.conditions if c not in frame.natural]
    told = {*names, *symbols_of(*(s for c in conditions for s in (c.left, c.right)))}
    boxes = {n: b for n, b in sorted(frame.boxes.items()) if n in told and b != own.get(n)}
    words = bounds_text(boxes, frame.labels)
    for c in conditions:
        left, right = (labelled(side, frame.labels) for side in (c.left, c.right))
        words.append(f"{left} {c.operator} {right}")
    return f", for {', '.join(words)}" if words else ""


def _on_the_way(found: Finding, label: str, end: str) -> Finding:
    """The finding with a witness that says where the variable goes, in its reason too."""
    if found.witness is None:
        return found
    point = {label: end, **{n: at for n, at in found.witness.point.items() if n != label}}
    witness = replace(found.witness, point=point, operator="->")
    reason = found.reason.replace(found.witness.text(), witness.text())
    return replace(found, witness=witness, reason=reason)


def _unfolded(expr: Expr, claimed: End, frame: Frame, scope: Scope) -> tuple[Expr, End, Frame]:
    """With two parameters of a model written in T, the deviation and two symbols that stay, all of
    which take all positive values.
    """
    pair = scope.pair()
    names = {free_name(token): token for token in pair.tokens}

    def moved(side: Expr) -> Expr:
        return tidied(substituted(side, pair.unfolded))

    conditions = tuple(Rel(c.operator, moved(c.left), moved(c.right)) for c in frame.conditions)
    boxes = {**frame.boxes, **dict.fromkeys(names, POSITIVE)}
    found = replace(frame, boxes=boxes, conditions=conditions, labels={**frame.labels, **names})
    return moved(expr), claimed if isinstance(claimed, str) else moved(claimed), found


def _has_calls(expr: Expr) -> bool:
    return any(node.kind == "call" for node in walk(expr))


def _algebraic(expr: Expr, approach: Approach, claimed: End) -> Outcome:
    """In one variable; where nothing was said of it, a side without values does not count."""
    point = approach.point
    value = point if isinstance(point, str) else constant_value(point)
    if value is None:
        raise Undecided(
            "at a point that is no rational number a limit is seen only where it is the value"
        )
    box = approach.box
    try:
        return decide_limit(expr, approach.name, box, value, claimed, approach.label)
    except NoValueNear:
        if box.stated or isinstance(value, str):
            raise
    for side in (Box(lower=value), Box(upper=value)):
        try:
            return decide_limit(expr, approach.name, side, value, claimed, approach.label)
        except NoValueNear:
            continue
    raise NoValueNear("the expression has no value near the limit")


def _by_expansion(expr: Expr, approach: Approach, claimed: End, frame: Frame) -> Finding:
    refuse_real_powers(expr, frame)
    around, dropped = others_frame(frame, approach)
    needed = constant_parts(approach.name, expr)
    findings: list[Finding] = []
    for side in open_sides(approach, frame, around):
        found = limit_by_expansion(approach.moved(expr, side), around)
        findings.append(_compared(found, claimed, needed, approach, around))
        if findings[-1].verdict == "refuted":
            break
    if not findings:
        raise Undecided("the point is not in the domain")
    against = of_parts(findings)
    if against is not None and dropped:
        raise Undecided("a limit under conditions on its variable that fails without them")
    return against or findings[-1]


def limit_by_expansion(expr: Expr, around: Frame) -> End:
    """The limit as the small distance goes to zero from above. Raises Undecided."""
    oracle = WithLogarithms(Coefficients(around))
    for depth in DEPTHS:
        series = expanded(expr, SMALL, oracle, depth)
        growing = Series({e: c for e, c in series.terms.items() if e < 0}, series.order)
        first = leading(growing, oracle)
        if first is not None:
            if oracle.is_positive(first[1]):
                return "infinity"
            if oracle.is_positive(-first[1]):
                return "-infinity"
            raise Undecided("a limit that is infinite, of a sign that is not known")
        if series.order > 0:
            return _constant_term(series.terms.get(Fraction(0), number(0)), oracle)
    raise Undecided("an expansion that cancels to the order reached")


def _constant_term(coefficient: Expr, oracle: WithLogarithms) -> End:
    """The limit of what is left: of its powers of the logarithm of the small number."""
    powers = by_powers(coefficient)
    if all(times <= 0 for times in powers):
        return powers.get(0, number(0))
    first = oracle.first(coefficient)
    if first is None or first[0] <= 0:
        return powers.get(0, number(0))
    if oracle.is_positive(coefficient):
        return "infinity"
    if oracle.is_positive(-coefficient):
        return "-infinity"
    raise Undecided("a limit that is infinite, of a sign that is not known")


def _compared(
    found: End, claimed: End, needed: tuple[Expr, ...], approach: Approach, around: Frame
) -> Finding:
    where = {approach.label: approach.text}
    method = "expansion near the limit"
    if isinstance(found, str) or isinstance(claimed, str):
        if found == claimed:
            return _said(around.decide(with_values(needed)), approach, method)
        left, right = (_shown(end) for end in (found, claimed))
        witness = Witness(
            where, "->", left, right, exact=True, note=f"the limit is {left.undefined}"
        )
        return Finding("refuted", witness.note, "nowhere", method, witness)
    outcome = around.decide(with_values(needed, Rel("=", found, claimed)))
    return _said(outcome, approach, f"{method}; {outcome.method}")


def _said(outcome: Outcome, approach: Approach, method: str) -> Finding:
    if outcome.verdict == "proved":
        domain = f"as {approach.label} {approach.text}, {outcome.domain}"
        return replace(
            finding_of(outcome),
            reason="the limit is the claimed one",
            domain=domain.removesuffix(", everywhere"),
            method=method,
        )
    found = _on_the_way(finding_of(outcome), approach.label, approach.text)
    if found.verdict != "refuted":
        return found
    return replace(found, reason=f"the limit is another: {found.reason}")


def _shown(end: End) -> Enclosure:
    if isinstance(end, str):
        return Enclosure("", "", {"-infinity": "minus infinity"}.get(end, end))
    value = constant_value(end)
    return Enclosure("", "", "finite") if value is None else Enclosure("", "", str(value))


LIMIT = Kind(
    "limit",
    "the left side tends to the right one where the condition with an arrow says",
    judge_limit,
    operators=frozenset(("->", "=")),
    form=lacks_arrow,
)
