"""Sums: written out, in closed form for polynomials and geometric series, else kept. Products:
written out or kept.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    mul,
    neg,
    number,
    power,
    symbol,
    symbols_of,
    walk,
)
from gainproof.verify.judge.exact.expression_text import TERM
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.meaning.evaluation import general_power
from gainproof.verify.judge.meaning.expansion import coefficients, products
from gainproof.verify.judge.setting.growing_memory import power_sum

MOST_TERMS = 200
MOST_POLYNOMIAL = 12
MOST_SHIFT = 6
INFINITE = symbol("infinity")
ENTIRE = ("exp", "sin", "cos", "atan", "erf")
"""Functions that have a value everywhere."""
EULERIAN = ((1,), (0, 1), (0, 1, 1), (0, 1, 4, 1))
"""Sum of j^m c^j over j >= 0 is this polynomial of c over (1 - c)^(m + 1)."""


def sum_of(summand: Expr, index: str, low: Expr, high: Expr) -> tuple[Expr, tuple[Rel, ...]]:
    """A sum over the bound symbol `index`, and what must hold for it: bounds in order, convergence.

    A sum without a closed form here is kept as a call. Raises Undecided.
    """
    if low == INFINITE:
        raise Undecided("a sum that begins at infinity")
    if high == INFINITE:
        return _endless(summand, index, low)
    first, last = constant_value(low), constant_value(high)
    if first is not None and last is not None:
        terms = [powers_put_in(summand, {index: n}) for n in range_of(low, high)]
        return (add(*terms) if terms else number(0)), ()
    ordered = (Rel(">=", high - low, number(-1)), Rel(">=", _apart(high)[0] - low, number(-1)))
    known = coefficients(summand, index)
    if known is None or max(known, default=0) > MOST_POLYNOMIAL:
        return _kept(summand, index, low, high), ordered
    terms = [
        mul(c, add(_power_sum(m, high), neg(_power_sum(m, low - 1)))) for m, c in known.items()
    ]
    return (add(*terms) if terms else number(0)), ordered


def product_of(factor: Expr, index: str, low: Expr, high: Expr) -> tuple[Expr, tuple[Rel, ...]]:
    """The same of a product. Raises Undecided."""
    if high == INFINITE:
        raise Undecided("a product to infinity")
    if constant_value(low) is not None and constant_value(high) is not None:
        factors = [powers_put_in(factor, {index: n}) for n in range_of(low, high)]
        return (mul(*factors) if factors else number(1)), ()
    ordered = (Rel(">=", high - low, number(-1)),)
    if index not in symbols_of(factor):
        return general_power(factor, high - low + 1), ordered
    return Expr("call", "product", (factor, symbol(index), low, high)), ordered


def series_of(name: str, parts: Sequence[Expr]) -> tuple[Expr, tuple[Rel, ...]]:
    """A sum or product of the parts of its call. Raises Undecided."""
    body, index, low, high = parts
    return (sum_of if name == "sum" else product_of)(body, index.name, low, high)


def _kept(summand: Expr, index: str, low: Expr, high: Expr) -> Expr:
    """A sum up to k + c as the one up to k, with the terms between added or taken away.

    So that sums with neighbouring bounds share one call. The bounds must be in order for both.
    What is taken away has to have a value: of x^(k - 1 - j) up to k - 1 the next term is 1/x.
    """
    upper, offset = _apart(high)
    if offset < 0 and not _goes_on(summand, index):
        upper, offset = high, 0
    whole = Expr("call", "sum", (summand, symbol(index), low, upper))
    steps = range(1, offset + 1) if offset > 0 else range(offset + 1, 1)
    between = [substituted(summand, {index: upper + j if j else upper}) for j in steps]
    if not between:
        return whole
    return add(whole, *between) if offset > 0 else add(whole, *[neg(t) for t in between])


def _goes_on(summand: Expr, index: str) -> bool:
    """Whether the terms that follow have values where those before them have, at a glance: the
    index stands in no divisor, root or logarithm, and no exponent falls with it.
    """
    for node in walk(summand):
        if index not in symbols_of(node) or node.kind in ("symbol", "add", "mul", "neg"):
            continue
        if node.kind == "call" and node.name == "power":
            known = coefficients(node.parts[1], index)
            slope = None if known is None else constant_value(known.get(1, number(0)))
            line = known is not None and set(known) <= {0, 1}
            if not line or slope is None or slope < 0 or index in symbols_of(node.parts[0]):
                return False
        elif (node.kind == "div" and index not in symbols_of(node.parts[1])) or (
            node.kind == "pow" and node.fraction > 0 and node.fraction.denominator == 1
        ):
            continue
        elif node.kind != "call" or not (node.name.startswith(TERM) or node.name in ENTIRE):
            return False
    return True


def _apart(high: Expr) -> tuple[Expr, int]:
    """A bound k + c as k and c, for small c; else the whole bound and 0."""
    names = symbols_of(high)
    if len(names) != 1:
        return high, 0
    base = symbol(next(iter(names)))
    offset = constant_value(substituted(high, {base.name: number(0)}))
    following = constant_value(substituted(high, {base.name: number(1)}))
    linear = all(n.kind in ("add", "neg", "symbol", "number") for n in walk(high))
    if not linear or offset is None or following is None or following - offset != 1:
        return high, 0
    return (base, int(offset)) if abs(offset) <= MOST_SHIFT else (high, 0)


def range_of(low: Expr, high: Expr) -> list[Expr]:
    """The whole numbers from one bound to the other. Raises Undecided."""
    first, last = constant_value(low), constant_value(high)
    if first is None or last is None or first.denominator != 1 or last.denominator != 1:
        raise Undecided("a sum or product whose bounds are not whole numbers")
    if not -1 <= last - first < MOST_TERMS:
        raise Undecided(f"a sum of more than {MOST_TERMS} terms, or with its bounds turned round")
    return [number(n) for n in range(int(first), int(last) + 1)]


def powers_put_in(expr: Expr, values: Mapping[str, Expr]) -> Expr:
    """Symbols replaced by expressions, and algebraic powers where an exponent is a number then."""

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        return general_power(*parts) if node.kind == "call" and node.name == "power" else None

    return rebuilt(substituted(expr, values), change)


def _power_sum(m: int, upper: Expr) -> Expr:
    """Sum of j^m for j = 0..upper, a polynomial that is 0 for upper = -1."""
    terms = [
        mul(number(c), power(upper, k)) if k else number(c) for k, c in enumerate(power_sum(m)) if c
    ]
    return add(*terms)


def _endless(summand: Expr, index: str, low: Expr) -> tuple[Expr, tuple[Rel, ...]]:
    """A geometric series, whose terms may have a polynomial of the index as factor."""
    terms: list[Expr] = []
    needed: list[Rel] = []
    for product in products(summand, [index]):
        outside: list[Expr] = []
        ratio: list[Expr] = []
        inside: list[Expr] = []
        for factor in product:
            if index not in symbols_of(factor):
                outside.append(factor)
            elif factor.kind == "call" and factor.name == "power":
                first, slope = _geometric(factor, index, low)
                outside.append(first)
                ratio.append(power(factor.parts[0], slope))
            else:
                inside.append(factor)
        if not ratio:
            raise Undecided("a sum to infinity that is no geometric series")
        c = mul(*ratio)
        needed.append(Rel("<", power(c, 2), number(1)))
        # from j = 0 on, with index = low + j
        shifted = substituted(mul(*inside), {index: low + symbol(index)}) if inside else number(1)
        known = coefficients(shifted, index)
        if known is None or max(known) >= len(EULERIAN):
            raise Undecided("a geometric series with such a factor")
        for m, coefficient in known.items():
            top = add(
                *[
                    number(e) * power(c, k) if k else number(e)
                    for k, e in enumerate(EULERIAN[m])
                    if e
                ]
            )
            whole = top / power(1 - c, m + 1)
            terms.append(mul(coefficient, *outside, whole))
    return add(*terms), tuple(needed)


def _geometric(factor: Expr, index: str, low: Expr) -> tuple[Expr, int]:
    """base^(a + b index) at the first index, and b. In one power: base^a alone may be a quotient,
    where the first term of x^(j - 1) from 1 on is x^0.
    """
    base, exponent = factor.parts
    known = coefficients(exponent, index)
    if index in symbols_of(base) or known is None or not set(known) <= {0, 1}:
        raise Undecided("a sum to infinity that is no geometric series")
    slope = constant_value(known.get(1, number(0)))
    if slope is None or slope.denominator != 1:
        raise Undecided("a geometric series whose exponent is not a whole multiple of its index")
    first = known.get(0, number(0)) + number(slope) * low
    value = constant_value(first)
    if value is None:
        return Expr("call", "power", (base, first)), int(slope)
    return (power(base, value) if value else number(1)), int(slope)
