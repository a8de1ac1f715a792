"""Expectations of polynomials of independent noises with mean zero and declared variances; where
noises are normal, of sines and cosines of them too.
"""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import dataclass

from gainproof.verify.judge.exact.expression import Expr, add, mul, number, symbols_of
from gainproof.verify.judge.exact.total_expressions import is_total
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.meaning.expansion import products
from gainproof.verify.judge.meaning.normal_moments import Turn, linear_parts, moments

TURNS = ("cos", "sin")


def expectation_of(
    expr: Expr, variances: Mapping[str, Expr], normal: Set[str], needed: list[Expr]
) -> Expr:
    """The expectation; symbols without a variance are no random variables. Raises Undecided.

    Noises are independent of one another: E[v w] = 0. Only first and second moments are known but
    of those that are `normal`. What has to have a value although its term is 0 is added to
    `needed`: E[v/x] has none at x = 0.
    """
    if not symbols_of(expr) & set(variances):
        raise Undecided("an expectation of something in which no symbol is declared a noise")
    terms: list[Expr] = []
    for product in products(expr, variances):
        sorted_out = _sorted_out(product, variances, normal)
        needed += sorted_out.needed(variances)
        terms += sorted_out.expectation(variances, normal)
    return add(*terms) if terms else number(0)


@dataclass(frozen=True)
class _Product:
    """Factors without noise, powers of noises, sines and cosines of normal noises."""

    rest: tuple[Expr, ...]
    powers: Mapping[str, int]
    turns: tuple[Turn, ...]

    def needed(self, variances: Mapping[str, Expr]) -> list[Expr]:
        """What may have no value, of all that has no noise."""
        parts = [
            *self.rest,
            *(p for _, angle in self.turns for p in linear_parts(angle, variances)),
        ]
        return [part for part in parts if not is_total(part)]

    def expectation(self, variances: Mapping[str, Expr], normal: Set[str]) -> list[Expr]:
        """Its terms; none if it is zero."""
        others = {name: power for name, power in self.powers.items() if name not in normal}
        if 1 in others.values():
            return []
        if any(power > 2 for power in others.values()):
            raise Undecided("a moment of a noise beyond its variance")
        known = [*self.rest, *(variances[name] for name in others)]
        powers = {name: power for name, power in self.powers.items() if name in normal}
        if not powers and not self.turns:
            return [mul(*known) if known else number(1)]
        deviations = {name: variances[name] for name in normal}
        return [mul(*known, term) for term in moments(powers, self.turns, deviations)]


def _sorted_out(
    product: tuple[Expr, ...], variances: Mapping[str, Expr], normal: Set[str]
) -> _Product:
    rest: list[Expr] = []
    powers: dict[str, int] = {}
    turns: list[Turn] = []
    for factor in product:
        noises = symbols_of(factor) & set(variances)
        if not noises:
            rest.append(factor)
        elif factor.kind == "symbol":
            powers[factor.name] = powers.get(factor.name, 0) + 1
        elif factor.kind == "call" and factor.name in TURNS and noises <= normal:
            turns.append((factor.name, factor.parts[0]))
        elif factor.kind == "call" and factor.name in TURNS:
            raise Undecided(
                "an expectation of a sine or cosine of a noise that is not declared normal "
                '(distribution = "normal")'
            )
        else:
            raise Undecided(
                "an expectation of something that is no polynomial of the noises, nor one of them "
                "with sines and cosines of normal noises"
            )
    return _Product(tuple(rest), powers, tuple(turns))
