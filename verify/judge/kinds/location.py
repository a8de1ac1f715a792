"""Where the roots of a polynomial lie, for all its parameters; and lists of its roots."""

from __future__ import annotations

from math import comb

from gainproof.verify.judge.claim.record import Claim, OwnField
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, add, mul, neg, number, power, symbols_of
from gainproof.verify.judge.exact.free_names import is_free
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Graph, Reading
from gainproof.verify.judge.kinds.claim_domain import framed
from gainproof.verify.judge.kinds.identity import resolved
from gainproof.verify.judge.kinds.kind import (
    EQUATION,
    Kind,
    OwnFields,
    expression,
    one_of,
    one_symbol,
)
from gainproof.verify.judge.meaning.evaluation import number_of
from gainproof.verify.judge.meaning.expansion import coefficients
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.stability_conditions import circle_moved, left_half_plane
from gainproof.verify.judge.verdict import Finding, finding_of

LOCATIONS = ("inside the unit circle", "left half plane", "real", "complex", "equal")
"""Where roots lie; `equal`: all in one place."""


def _polynomial(claim: OwnFields, name: str) -> OwnField | None:
    """None for a formula that lists the roots."""
    if not claim.fields.has(name) and not claim.has_formula:
        raise claim.fields.fail(name, "wanted: a polynomial, or a formula that lists the roots")
    if claim.fields.has(name) != claim.fields.has("variable"):
        problem = "a polynomial and its variable are wanted together"
        raise claim.fields.fail("variable", problem)
    return expression("the polynomial")(claim, name) if claim.fields.has(name) else None


def _variable(claim: OwnFields, name: str) -> OwnField | None:
    return one_symbol(claim, name) if claim.fields.has(name) else None


def _where(claim: OwnFields, name: str) -> OwnField | None:
    """None where polynomial and formula say where the roots lie."""
    if claim.fields.has(name):
        return one_of(LOCATIONS)(claim, name)
    if claim.has_formula and claim.fields.has("polynomial"):
        return None
    raise claim.fields.fail(name, f"this field is missing: one of {', '.join(LOCATIONS)}")


def judge_location(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether the roots lie where the claim says; roots that are listed must be all of them."""
    conditions = resolved(reading.conditions, scope)
    relations: list[Rel] = []
    listed = [scope.expression(r.right) for r in reading.relations]
    known: list[Expr] | None = None
    if "polynomial" in claim.own:
        polynomial = claim.own["polynomial"].expression
        known = _coefficients(polynomial, claim.own["variable"].symbol, scope)
    for relation, root in zip(reading.relations, listed, strict=True):
        left = scope.expression(relation.left)
        if relation.operator != "=" or not _is_name(left, [*listed, *(known or [])]):
            relations.append(Rel(relation.operator, left, root))
    if known is not None and listed:
        relations += _all_roots(known, listed)
    elif known is None and not listed:
        raise Undecided("neither a polynomial nor its roots are given")
    if "where" in claim.own:
        whole = known if known is not None else _from_roots(listed)
        relations += located(whole, claim.own["where"].word)
    frame = framed(claim, scope, conditions)
    return finding_of(frame.decide(Statement(tuple(relations), (), "if", tuple(scope.needed))))


def _is_name(left: Expr, used: list[Expr]) -> bool:
    """Whether the left side only names a root: a free symbol that nothing else speaks of."""
    return is_free(left) and left.name not in symbols_of(*used)


def _coefficients(polynomial: Graph, token: str, scope: Scope) -> list[Expr]:
    """From power 0 up; the highest is not asked to differ from zero here."""
    variable, expr = number_of(scope.symbol(token)), scope.expression(polynomial)
    if variable.kind != "symbol":
        raise Undecided(f"{token} is no free symbol")
    known = coefficients(expr, variable.name)
    if known is None or not known or max(known) == 0:
        raise Undecided(f"no polynomial in {token}")
    return [known.get(k, number(0)) for k in range(max(known) + 1)]


def _from_roots(roots: list[Expr]) -> list[Expr]:
    """The polynomial with these roots and leading coefficient 1."""
    found = [number(1)]
    for root in roots:
        shifted = [number(0), *found]
        lowered = [*(mul(neg(root), c) for c in found), number(0)]
        found = [add(a, b) for a, b in zip(shifted, lowered, strict=True)]
    return found


def _all_roots(known: list[Expr], roots: list[Expr]) -> list[Rel]:
    """The polynomial is its leading coefficient times the product of z - root."""
    if len(roots) != len(known) - 1:
        raise Undecided(
            f"a polynomial of degree {len(known) - 1} has as many roots; {len(roots)} are listed"
        )
    made = _from_roots(roots)
    pairs = zip(known, made, strict=True)
    return [Rel("!=", known[-1], number(0)), *(Rel("=", a, known[-1] * b) for a, b in pairs)]


def located(known: list[Expr], where: str) -> list[Rel]:
    """Conditions on the coefficients (from power 0 up) that are true exactly where the roots lie
    there. Raises Undecided beyond the degrees covered.
    """
    lead = known[-1]
    positive = [mul(lead, c) for c in known]
    # with a leading coefficient zero all of these are zero, and none of the conditions holds
    if where == "inside the unit circle":
        return left_half_plane(circle_moved(positive))
    if where == "left half plane":
        return left_half_plane(positive)
    proper = [] if constant_value(lead) else [Rel("!=", lead, number(0))]
    degree = len(known) - 1
    if where == "equal":
        return [*proper, *_equal_roots(known)]
    operator = {"real": ">=", "complex": "<"}[where]
    if degree == 1 and where == "real":
        return [*proper, *_with_values(known)]
    if degree == 2:
        return [*proper, Rel(operator, _discriminant(known), number(0))]
    if degree == 3 and where == "real":
        return [*proper, Rel(operator, _cubic_discriminant(known), number(0))]
    raise Undecided(f"roots of a polynomial of degree {degree} that are {where}: not covered")


def _equal_roots(known: list[Expr]) -> list[Rel]:
    """That the polynomial is its leading coefficient times a power of z - m: then m is fixed by its
    second coefficient, -n m times the first.
    """
    degree, lead, second = len(known) - 1, known[-1], known[-2]
    found = []
    for k in range(degree - 1):
        n = degree - k
        left = mul(number(degree**n), known[k], power(lead, n - 1))
        found.append(Rel("=", left, mul(number(comb(degree, k)), power(second, n))))
    return found or _with_values(known)


def _with_values(known: list[Expr]) -> list[Rel]:
    """That the coefficients have values: of one root nothing else is asked."""
    return [Rel("=", c, c) for c in known]


def _discriminant(known: list[Expr]) -> Expr:
    c, b, a = known
    return power(b, 2) - 4 * a * c


def _cubic_discriminant(known: list[Expr]) -> Expr:
    d, c, b, a = known
    return add(
        mul(number(18), a, b, c, d),
        neg(mul(number(4), power(b, 3), d)),
        mul(power(b, 2), power(c, 2)),
        neg(mul(number(4), a, power(c, 3))),
        neg(mul(number(27), power(a, 2), power(d, 2))),
    )


LOCATION = Kind(
    "location",
    "roots lie where it is said",
    judge_location,
    own={"polynomial": _polynomial, "variable": _variable, "where": _where},
    own_words="`polynomial` and its `variable`, or a formula that lists the roots; `where`: "
    "`inside the unit circle`, `left half plane`, `real`, `complex` or `equal`",
    operators=EQUATION,
    needs_formula=False,
)
