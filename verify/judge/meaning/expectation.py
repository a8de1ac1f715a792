"""Expectations of polynomials of independent noises with mean zero and declared variances."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.exact.expression import Expr, add, mul, number, symbols_of
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.meaning.expansion import products


def expectation_of(expr: Expr, variances: Mapping[str, Expr]) -> Expr:
    """The expectation; symbols without a variance are no random variables. Raises Undecided.

    Noises are independent of one another: E[v w] = 0. Only first and second moments are known.
    """
    if not symbols_of(expr) & set(variances):
        raise Undecided("an expectation of something in which no symbol is declared a noise")
    terms = []
    for product in products(expr, variances):
        powers: dict[str, int] = {}
        rest = []
        for factor in product:
            name = next(iter(symbols_of(factor) & set(variances)), None)
            if name is None:
                rest.append(factor)
            elif factor.kind == "symbol":
                powers[name] = powers.get(name, 0) + 1
            else:
                raise Undecided("an expectation of something that is no polynomial of the noises")
        if 1 in powers.values():
            continue
        if any(p > 2 for p in powers.values()):
            raise Undecided("a moment of a noise beyond its variance")
        terms.append(mul(*rest, *[variances[n] for n in powers]) if rest or powers else number(1))
    return add(*terms) if terms else number(0)
