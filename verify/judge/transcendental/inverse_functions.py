"""Relations of a function value to something else, as relations of its argument to that.

log a > b where a > 0 and a > exp b, log a > log b where a > b > 0; exp a > b if b > 0 and
a > log b. What is written so implies the relation, and follows from it as a condition: exp a > b
says nothing of a where b is negative.
"""

from __future__ import annotations

from collections.abc import Iterator

from gainproof.verify.judge.exact.expression import Expr, mul, number, symbols_of
from gainproof.verify.judge.exact.rational_points import is_seen
from gainproof.verify.judge.exact.statement import TURNED, Rel
from gainproof.verify.judge.transcendental.monomials import Monomial, monomial_expr, monomials

WITH_EQUAL = {**TURNED, "=": "="}


def unwrapped(rel: Rel, *, condition: bool) -> list[Rel] | None:
    """Relations that all together imply this one, or as a `condition` follow from it; None where no
    side is a number times an exponential, a power of a number or a logarithm.
    """
    if rel.operator not in WITH_EQUAL:
        return None
    for side, other, operator in (
        (rel.left, rel.right, rel.operator),
        (rel.right, rel.left, WITH_EQUAL[rel.operator]),
    ):
        found = _function(side)
        if found is None:
            continue
        call, factor = found
        sign = _sign(factor)
        if sign == 0:
            continue
        towards = operator if sign > 0 else WITH_EQUAL[operator]
        made = _argument(call, towards, other / factor, condition=condition)
        if made is not None:
            # what is said of numbers alone adds nothing to a condition
            return [made[0], *(r for r in made[1:] if not condition or symbols_of(r.left))]
    return None


def _argument(call: Expr, operator: str, other: Expr, *, condition: bool) -> list[Rel] | None:
    zero = number(0)
    if call.name == "log":
        inner, beside = call.parts[0], _function(other)
        if beside is not None and beside[0].name == "log" and beside[1] == number(1):
            (bound,) = beside[0].parts
            return [Rel(operator, inner, bound), Rel(">", inner, zero), Rel(">", bound, zero)]
        return [Rel(operator, inner, Expr("call", "exp", (other,))), Rel(">", inner, zero)]
    positive = Rel(">", other, zero)
    if condition and operator in (">", ">=") and (symbols_of(other) or not is_seen(positive)):
        return None
    logarithm = Expr("call", "log", (other,))
    if call.name == "exp":
        return [Rel(operator, call.parts[0], logarithm), positive]
    base, exponent = call.parts
    rate = Expr("call", "log", (base,))
    return [Rel(operator, mul(exponent, rate), logarithm), positive]


def _function(side: Expr) -> tuple[Expr, Expr] | None:
    """The one exponential, power of a number or logarithm with symbols in a product, and what it is
    multiplied by, which has none. None where something cancels: it may be zero.
    """
    if not _is_product(side):
        return None
    calls = list(_calls(side, divided=False))
    if len(dict(calls)) < len(calls) or any(below and symbols_of(call) for call, below in calls):
        return None
    terms = monomials(side)
    if len(terms) != 1:
        return None
    ((monomial, c),) = terms.items()
    own = [(base, n) for base, n in monomial if symbols_of(base)]
    if len(own) != 1 or own[0][1] != 1 or own[0][0].kind != "call":
        return None
    call = own[0][0]
    base = call.parts[0]
    of_number = call.name == "power" and base.kind == "number" and base.fraction > 0
    if call.name not in ("exp", "log") and not of_number:
        return None
    rest: Monomial = monomial - {own[0]}
    return call, mul(number(c), monomial_expr(rest)) if rest else number(c)


def _is_product(side: Expr) -> bool:
    if side.kind in ("mul", "div", "neg"):
        return all(map(_is_product, side.parts))
    return side.kind in ("number", "call")


def _calls(side: Expr, *, divided: bool) -> Iterator[tuple[Expr, bool]]:
    """The function values of a product, each with whether it is divided by."""
    if side.kind == "call":
        yield side, divided
        return
    for place, part in enumerate(side.parts):
        yield from _calls(part, divided=divided or (side.kind == "div" and place == 1))


def _sign(factor: Expr) -> int:
    """Of a number; 0 where balls do not tell."""
    if is_seen(Rel(">", factor, number(0))):
        return 1
    return -1 if is_seen(Rel("<", factor, number(0))) else 0
