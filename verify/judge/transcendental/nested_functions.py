"""Powers of exponentials, exponentials of logarithms, functions of arc tangents written without the
inner function, logarithms of products as sums.

exp(a log b) = b^a and (b^a)^c = b^(a c) for positive b, exp(a)^c = exp(a c); log(b^a c) = a log b +
log c for positive b and c, numbers by their primes, log exp a = a; sin atan x = x (1 + x^2)^(-1/2),
cos atan x = (1 + x^2)^(-1/2), tan atan x = x, and of twice the arc tangent 2 x/(1 + x^2), (1 -
x^2)/(1 + x^2) and their ratio.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import Expr, add, mul, neg, number, power
from gainproof.verify.judge.meaning.evaluation import general_power
from gainproof.verify.judge.transcendental.monomials import (
    Monomial,
    monomial_expr,
    monomials,
    ordered,
    terms_expr,
)
from gainproof.verify.judge.transcendental.power_bases import bases_of
from gainproof.verify.judge.transcendental.variable_ranges import Positive

Factor = tuple[Expr, Expr]
"""A base and its exponent."""


def flattened(expr: Expr, is_positive: Positive) -> Expr:
    """An equal expression, flat where this is known to be allowed."""

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        if node.kind == "call" and node.name == "exp":
            return _exponential(parts[0], is_positive)
        if node.kind == "call" and node.name == "power":
            found = _of_its_logarithms(node.parts[0], node.parts[1], is_positive)
            if found is not None:
                return flattened(found, is_positive)
            return _power(parts[0], parts[1], is_positive)
        if node.kind == "call" and node.name == "log":
            return sum_of_logarithms(parts[0], is_positive)
        if node.kind == "call" and node.name in ("atan", "erf"):
            return _odd(node.name, parts[0])
        if node.kind == "call" and len(parts) == 1:
            return of_arc_tangent(node.name, parts[0])
        if node.kind == "pow" and parts[0].kind == "call":
            return _power(parts[0], number(node.fraction), is_positive)
        return None

    return rebuilt(expr, change)


def _odd(name: str, argument: Expr) -> Expr | None:
    """f(-a) = -f(a), of both the one whose first term is positive; None if it is this."""
    terms = monomials(argument)
    first = min(terms, key=lambda m: monomial_expr(m).key, default=None)
    if first is None or terms[first] > 0:
        return None
    return neg(Expr("call", name, (terms_expr({m: -c for m, c in terms.items()}),)))


def _exponential(exponent: Expr, is_positive: Positive) -> Expr | None:
    """exp of a sum, the terms with one logarithm as powers; None if there are none."""
    factors: list[Expr] = []
    rest: list[Expr] = []
    for monomial, c in monomials(without_roots(exponent)).items():
        logs = [base for base, n in monomial if n == 1 and _is(base, "log")]
        if len(logs) == 1 and is_positive(logs[0].parts[0]):
            times = _scaled(monomial - {(logs[0], 1)}, c)
            factors.append(general_power(logs[0].parts[0], times))
        else:
            rest.append(_scaled(monomial, c))
    if not factors:
        return None
    if rest:
        factors.append(Expr("call", "exp", (add(*rest),)))
    return mul(*factors)


def without_roots(expr: Expr) -> Expr:
    """The same wherever it has a value, whole powers of roots as powers of what is under them."""
    terms = []
    for monomial, c in monomials(expr).items():
        factors = [number(c)]
        for base, n in ordered(monomial):
            order = base.fraction.denominator if base.kind == "pow" else 1
            if order > 1 and n % order == 0:
                factors.append(power(base.parts[0], base.fraction * n))
            else:
                factors.append(monomial_expr(frozenset(((base, n),))))
        terms.append(mul(*factors) if len(factors) > 1 else factors[0])
    return add(*terms) if terms else number(0)


def _of_its_logarithms(base: Expr, exponent: Expr, is_positive: Positive) -> Expr | None:
    """b^(a log c/log b + d) as c^a b^d; None if there is no such logarithm. That log b has a value
    and is not zero is asked for by itself.
    """
    own = Expr("call", "log", (base,))
    factors: list[Expr] = []
    rest: list[Expr] = []
    for monomial, c in monomials(exponent).items():
        logs = [each for each, n in monomial if n == 1 and _is(each, "log") and each != own]
        if len(logs) == 1 and (own, -1) in monomial and is_positive(logs[0].parts[0]):
            times = _scaled(monomial - {(logs[0], 1), (own, -1)}, c)
            factors.append(general_power(logs[0].parts[0], times))
        else:
            rest.append(_scaled(monomial, c))
    if not factors:
        return None
    return mul(*factors, general_power(base, add(*rest))) if rest else mul(*factors)


def _power(base: Expr, exponent: Expr, is_positive: Positive) -> Expr | None:
    """A power of a product of powers and exponentials; None if the base is something else."""
    terms = monomials(base)
    if len(terms) != 1:
        return None
    ((monomial, c),) = terms.items()
    if c != 1 or not monomial or not all(_is_flat(each, is_positive) for each, _ in monomial):
        return None
    factors = []
    for each, n in ordered(monomial):
        times = mul(number(n), exponent, each.parts[-1])
        if each.name == "exp":
            factors.append(Expr("call", "exp", (times,)))
        else:
            simple = [_scaled(*term) for term in monomials(times).items()] or [number(0)]
            whole = simple[0] if len(simple) == 1 else times
            factors.append(general_power(each.parts[0], whole))
    return mul(*factors)


def _is_flat(base: Expr, is_positive: Positive) -> bool:
    return _is(base, "exp") or (_is(base, "power") and is_positive(base.parts[0]))


def _is(expr: Expr, name: str) -> bool:
    return expr.kind == "call" and expr.name == name


def _scaled(monomial: Monomial, c: Fraction) -> Expr:
    if not monomial:
        return number(c)
    written = monomial_expr(monomial)
    return written if c == 1 else number(c) * written


def sum_of_logarithms(argument: Expr, is_positive: Positive) -> Expr | None:
    """The logarithm as a sum; None if it is of no product, or of one whose factors are not known to
    be positive.
    """
    terms = list[Expr]()
    for base, exponent in _factors(argument, number(1)):
        if base.kind == "call" and base.name == "exp":
            terms.append(mul(exponent, base.parts[0]))
        elif not is_positive(base):
            return None
        elif base != number(1):
            terms.append(mul(exponent, Expr("call", "log", (base,))))
    found = add(*terms) if terms else number(0)
    return None if found == Expr("call", "log", (argument,)) else found


def _factors(expr: Expr, exponent: Expr) -> Iterator[Factor]:
    """Of a product of powers; a power of what may be negative is a base of its own."""
    match expr.kind:
        case "number":
            for base, times in bases_of(expr).items():
                yield base, mul(number(times), exponent)
        case "mul":
            for part in expr.parts:
                yield from _factors(part, exponent)
        case "div":
            yield from _factors(expr.parts[0], exponent)
            yield from _factors(expr.parts[1], mul(number(-1), exponent))
        case "pow":
            yield from _factors(expr.parts[0], mul(number(expr.fraction), exponent))
        case "call" if expr.name == "power":
            yield from _factors(expr.parts[0], mul(expr.parts[1], exponent))
        case _:
            yield expr, exponent


def of_arc_tangent(name: str, argument: Expr) -> Expr | None:
    """A sine, cosine or tangent of an arc tangent, or of twice one, of either sign; None if it is
    of anything else.
    """
    found = _arc_tangent(argument)
    if found is None or name not in ("sin", "cos", "tan"):
        return None
    x, times = found
    square = add(number(1), power(x, 2))
    if abs(times) == 1:
        below = power(square, Fraction(1, 2))
        sine, cosine = x / below, 1 / below
    else:
        sine, cosine = 2 * x / square, (1 - power(x, 2)) / square
    if name == "cos":
        return cosine
    value = x if name == "tan" and abs(times) == 1 else sine if name == "sin" else sine / cosine
    return value if times > 0 else neg(value)


def _arc_tangent(argument: Expr) -> tuple[Expr, int] | None:
    """`m atan x` as x and m, one or two; what is written otherwise is left."""
    match argument.kind:
        case "call" if argument.name == "atan":
            return argument.parts[0], 1
        case "neg":
            found = _arc_tangent(argument.parts[0])
            return None if found is None else (found[0], -found[1])
        case "mul" if len(argument.parts) == 2 and argument.parts[0].kind == "number":
            found, times = _arc_tangent(argument.parts[1]), argument.parts[0].fraction
            if found is not None and abs(times * found[1]) in (1, 2):
                return found[0], int(times * found[1])
    return None
