"""Growth and fall of an expression with a symbol, or from each sample to the next."""

from __future__ import annotations

from dataclasses import replace

from gainproof.verify.judge.claim.record import Claim, OwnField
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of, walk
from gainproof.verify.judge.exact.formula_tree import read_tree
from gainproof.verify.judge.exact.functions import refuse_jumps
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.truth import NO_VALUE
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.claim_domain import Frame, framed
from gainproof.verify.judge.kinds.identity import judge_identity, resolved
from gainproof.verify.judge.kinds.kind import Kind, OwnFields, one_of
from gainproof.verify.judge.kinds.monotone_quantities import is_one_way
from gainproof.verify.judge.meaning.evaluation import number_of
from gainproof.verify.judge.meaning.expansion import coefficients
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import DEVIATION, SAMPLE
from gainproof.verify.judge.transcendental.monomials import monomials
from gainproof.verify.judge.verdict import Finding, finding_of
from gainproof.verify.judge.verdict_words import Shown

SIGNS = {"increasing": ">", "decreasing": "<", "nondecreasing": ">=", "nonincreasing": "<="}


def _about(claim: OwnFields, name: str) -> OwnField:
    """What changes, and the symbol with which it does."""
    about = claim.fields.texts(name, 2)
    if len(about) != 2:
        raise claim.fields.fail(name, "wanted: what changes, and the symbol with which it does")
    token = claim.token(name, about[1])
    return OwnField((token,), (claim.graph(name, about[0]),), place="what changes")


def judge_monotone(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether the subject changes as the trend says, over the whole domain of its variable."""
    said = judge_identity(claim, reading, scope) if reading.relations else None
    if said is not None and said.verdict == "conditional":
        raise Undecided(f"a trend of what holds on a part of the domain: {said.reason}")
    if said is not None and said.verdict != "proved":
        return said
    stated = resolved(reading.conditions, scope)
    graph, token = claim.own["about"].expression, claim.own["about"].symbol
    scope.refuse_free_index(read_tree(graph), token)
    subject = scope.expression(graph)
    variable = number_of(scope.symbol(token))
    operator = SIGNS[claim.own["trend"].word]
    if variable.kind == "symbol" and scope.boxes().get(variable.name, Box()).integer:
        return _from_sample_to_sample(claim, subject, variable, operator, scope, stated)
    refuse_jumps(subject, variable)
    slope = number_of(scope.derivative(subject, token, scope.root))
    # where the rules give no slope is looked at here: the subject has a value there
    frame = replace(framed(claim, scope, stated), slopes=())
    if not scope.environment.is_coordinate(variable):
        variable = tidied(variable)
    names = symbols_of(variable)
    _refuse_gaps(frame, names)
    is_moving = variable.kind == "symbol" and scope.is_shared(variable.name, subject)
    if is_moving:
        _refuse_winding(frame, scope)
    if token == scope.environment.intensity:
        names = {scope.environment.parameter or ""}
    is_own = variable.kind == "symbol" or scope.environment.is_coordinate(variable)
    is_own |= token in scope.environment.fixing
    if not is_own and not _is_one_way(token, variable, names, frame, scope):
        raise Undecided(f"{token} is not strictly monotone itself")
    # defined everywhere, hence continuous; where it has corners its slope is not asked for
    without, unknown = _without_value(subject, names, frame)
    rises = Statement((Rel(operator, slope, number(0)),), needed=(subject,))
    if without is not None:
        return _between_gaps(without, rises, frame)
    within = {n: _opened(b) if n in names else b for n, b in frame.boxes.items()}
    inside = replace(frame, boxes=within)
    unknown = unknown or _unknown_slopes(slope, inside)
    finding = finding_of(inside.decide(rises))
    if unknown is not None and finding.verdict != "refuted":
        raise Undecided(unknown)
    if finding.verdict == "proved" or operator not in "<>" or is_moving:
        pass  # zeros of a slope are looked for with the other variables kept
    elif _nearly(operator, slope, names, inside):
        weak = Rel(f"{operator}=", slope, number(0))
        finding = finding_of(inside.decide(replace(rises, relations=(weak,))))
    witness = finding.witness and replace(finding.witness, shows=Shown.SLOPE)
    return replace(finding, method=f"sign of the derivative; {finding.method}", witness=witness)


def _is_one_way(token: str, variable: Expr, names: set[str], frame: Frame, scope: Scope) -> bool:
    """Whether the variable rises or falls with one base variable throughout; over a chart, with one
    of the parameters of which it is a chart.
    """
    if scope.plain is None:
        return is_one_way(variable, names, frame)
    plain = tidied(scope.plain_value(token))
    inside = replace(frame, environment=scope.plain)
    return is_one_way(plain, symbols_of(plain), inside)


def _without_value(
    subject: Expr, names: set[str], frame: Frame
) -> tuple[Finding | None, str | None]:
    """The finding where the subject lacks a value between the ends of the domain, else None; and
    why nothing is proved, where it is seen to have values at points only.
    """
    boxes = {n: replace(b, stated=b.stated or n in names) for n, b in frame.boxes.items()}
    defined = replace(frame, boxes=boxes).decide(Statement((Rel("=", subject, subject),)))
    if defined.verdict == "held":
        return None, "it may have no value somewhere between the ends of the domain"
    if defined.verdict == "proved":
        return None, None
    reason = f"no value everywhere between the ends of the domain: {defined.reason}"
    return replace(finding_of(defined), reason=reason), None


def _between_gaps(without: Finding, rises: Statement, frame: Frame) -> Finding:
    """What is told where the subject lacks a value somewhere: `conditional` only if it goes as is
    claimed wherever it has one. Raises Undecided.
    """
    if without.verdict != "conditional":
        return without
    loose = {name: replace(box, stated=False) for name, box in frame.boxes.items()}
    found = replace(frame, boxes=loose).decide(rises)
    if found.verdict == "proved":
        reason = f"{without.reason}; where it has values without a gap the trend is this one"
        return without.told_as("conditional", reason, without.domain)
    if found.verdict == "refuted":
        return without.told_as("refuted", without.reason)
    raise Undecided(without.reason)


def _unknown_slopes(slope: Expr, inside: Frame) -> str | None:
    """Why nothing is proved, unless the slope has a value everywhere but at single points."""
    everywhere = {n: replace(b, stated=True) for n, b in inside.boxes.items()}
    found = replace(inside, boxes=everywhere).decide(Statement((Rel("=", slope, slope),)))
    if found.verdict == "proved":
        return None
    places = found.certificate.get("places", [{"place": "", "found": NO_VALUE}])
    without = [p["place"] for p in places if p["found"] == NO_VALUE]
    if not all(" = " in place for place in without):
        return "the derivative has no value on a whole interval"
    return None


def _refuse_gaps(frame: Frame, names: set[str]) -> None:
    """Raises Undecided unless the variable runs through an interval: conditions linear in it."""
    for rel in frame.conditions:
        for name in symbols_of(rel.left, rel.right) & names:
            known = coefficients(rel.left - rel.right, name)
            if known is None or max(known, default=0) > 1 or rel.operator in ("=", "!="):
                raise Undecided("a domain that may be no interval of the variable")


def _refuse_winding(frame: Frame, scope: Scope) -> None:
    """Raises Undecided unless the parameter runs through an interval with the variable: what stays
    is one product of powers, and no condition speaks of the parameter.
    """
    own = scope.environment.own_variables()
    if any(not own.isdisjoint(symbols_of(c.left, c.right)) for c in frame.conditions):
        raise Undecided("a condition on the tracking index, which changes with the variable")
    if scope.environment.pair:
        return  # powers of the variable, which run through all positive numbers with it
    fixing = [e for e in scope.staying().values() if not own.isdisjoint(symbols_of(e))]
    if not all(_is_product(e) for e in fixing):
        raise Undecided("what stays does not fix the tracking index in a simple way")


def _is_product(expr: Expr) -> bool:
    """Whether it is a number times powers of symbols."""
    terms = monomials(expr)
    bases = [base for monomial in terms for base, _ in monomial]
    roots = [base.parts[0] if base.kind == "pow" else base for base in bases]
    return len(terms) == 1 and all(base.kind in ("symbol", "number") for base in roots)


def _opened(box: Box) -> Box:
    """The inside of a domain; a point without slope is left out, the subject has a value there."""
    return replace(box, lower_open=True, upper_open=True, stated=False)


def _nearly(operator: str, slope: Expr, names: set[str], frame: Frame) -> bool:
    """Whether a slope never has the other sign and is zero at isolated points only, for all values
    of the other symbols. Raises Undecided where only the latter is not known.
    """
    if len(names) != 1 or not names <= symbols_of(slope):
        return False
    if not frame.holds(Rel(f"{operator}=", slope, number(0))):
        return False
    if frame.holds(Rel("=", slope, number(0))):
        return False
    if symbols_of(slope) == names:
        found = frame.decide(Statement((Rel("=", slope, number(0)),)))
        # seen at points only, it may be zero on an interval, unless it is analytic
        return found.verdict == "refuted" and (bool(found.domain) or not _has_roots(slope))
    known = coefficients(slope, next(iter(names))) or {}
    if any(frame.holds(Rel("!=", c, number(0))) for c in known.values()):
        return True
    raise Undecided("a slope that may be zero on an interval for some values of the other symbols")


def _has_roots(expr: Expr) -> bool:
    """Whether there are roots in it, absolute values among them: all else is analytic."""
    return any(n.kind == "pow" and n.fraction.denominator != 1 for n in walk(expr))


def _refuse_other_samples(subject: Expr, variable: str) -> None:
    """Raises Undecided if something else changes from each sample to the next."""
    moving = [n for n in symbols_of(subject) if n.startswith(("measurement", "previous_state"))]
    if variable == SAMPLE and any(n != DEVIATION for n in moving):
        raise Undecided("a trend of something that depends on measurements")


def _from_sample_to_sample(
    claim: Claim,
    subject: Expr,
    variable: Expr,
    operator: str,
    scope: Scope,
    stated: tuple[Rel, ...],
) -> Finding:
    frame = framed(claim, scope, stated)
    name = variable.name
    _refuse_gaps(frame, {name})
    _refuse_other_samples(subject, name)
    without, unknown = _without_value(subject, {name}, frame)
    if without is not None and without.verdict == "conditional":
        raise Undecided(without.reason)
    if without is not None:
        return without
    if unknown is not None:
        raise Undecided(unknown)
    box = frame.boxes[name]
    if box.upper is not None:
        frame = replace(frame, boxes={**frame.boxes, name: replace(box, upper=box.upper - 1)})
    later = {name: symbol(name) + 1}
    following = substituted(subject, later)
    both = Statement((), frame.conditions).mapped(lambda e: substituted(e, later)).conditions
    frame = replace(frame, conditions=tuple(dict.fromkeys((*frame.conditions, *both))))
    outcome = frame.decide(Statement((Rel(operator, following, subject),)))
    return replace(finding_of(outcome), method="from each sample to the next")


MONOTONE = Kind(
    "monotone",
    "an expression rises or falls with a symbol",
    judge_monotone,
    own={"about": _about, "trend": one_of(SIGNS)},
    own_words="`about`: the two; `trend`: `increasing`, `decreasing`, `nondecreasing` or "
    "`nonincreasing`",
    needs_formula=False,
)
