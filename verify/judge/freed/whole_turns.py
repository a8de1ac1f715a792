"""Angles with whole multiples of pi in them: cos(k pi + x) is (-1)^k cos x for a whole number k."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import Expr, mul, number
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.total import is_total
from gainproof.verify.judge.freed.atoms import ANGLES, MINUS
from gainproof.verify.judge.freed.circle import PI
from gainproof.verify.judge.freed.monomials import Monomial, monomial_expr, monomials, terms_expr
from gainproof.verify.judge.meaning.domains import is_whole


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
