"""Expansions of expression trees."""

from __future__ import annotations

from fractions import Fraction
from math import factorial

from gainproof.verify.judge.exact.expression import Expr, mul, number, power, symbols_of, walk
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.series.logarithmic import power_of_small
from gainproof.verify.judge.series.series import (
    EXACT,
    MOST_STEPS,
    Oracle,
    Series,
    composed,
    constant,
    leading,
    opposite,
    plus,
    powered,
    split,
    times,
)

ONE = Fraction(1)


def expanded(expr: Expr, name: str, oracle: Oracle, depth: Fraction) -> Series:
    """The expansion of an expression in the symbol `name`, small and positive. Raises Undecided."""
    done: dict[bytes, Series] = {}
    for node in walk(expr):
        if name not in symbols_of(node):
            done[node.key] = constant(node)
        else:
            parts = [done[p.key] for p in node.parts]
            done[node.key] = _node(node, parts, oracle, depth)
    return done[expr.key]


def _node(node: Expr, parts: list[Series], oracle: Oracle, depth: Fraction) -> Series:
    match node.kind:
        case "symbol":
            return Series({ONE: number(1)})
        case "add":
            return plus(*parts)
        case "mul":
            total = parts[0]
            for part in parts[1:]:
                total = times(total, part)
            return total
        case "neg":
            return opposite(parts[0])
        case "div":
            return times(parts[0], powered(parts[1], Fraction(-1), oracle, depth))
        case "pow":
            if _vanishes(parts[0]) and node.fraction > 0 and _is_positive(node.parts[0]):
                return parts[0]
            return powered(parts[0], node.fraction, oracle, depth)
        case "call" if node.name == "exp":
            return _exponential(parts[0], oracle, depth)
        case "call" if node.name == "log":
            return _logarithm(parts[0], oracle, depth)
        case "call" if node.name == "atan":
            return _arc_tangent(parts[0], oracle, depth)
        case "call" if node.name in ("sin", "cos", "tan"):
            return _angle(node.name, parts[0], oracle, depth)
        case "call" if node.name == "power":
            return _power(parts[0], parts[1], oracle, depth)
        case _:
            raise Undecided(f"the expansion of {node.value or node.kind} is not covered")


def _vanishes(s: Series) -> bool:
    """Whether it is zero or smaller than every power."""
    return not s.terms and s.order == EXACT


def _is_positive(expr: Expr) -> bool:
    """Whether it is positive, at a glance: products, powers of exponentials."""
    match expr.kind:
        case "call":
            return expr.name == "exp"
        case "mul" | "div" | "pow":
            return all(_is_positive(p) for p in expr.parts)
        case _:
            return expr.kind == "number" and expr.fraction > 0


def _apart(s: Series) -> tuple[Expr, Series]:
    """Constant term and the rest; Raises Undecided for negative powers."""
    if any(e < 0 for e in s.terms) or s.order <= 0:
        raise Undecided("a function of something that grows without bound near the limit")
    rest = {e: c for e, c in s.terms.items() if e > 0}
    return s.terms.get(Fraction(0), number(0)), Series(rest, s.order)


def _exponential(s: Series, oracle: Oracle, depth: Fraction) -> Series:
    first = leading(s, oracle) if any(e < 0 for e in s.terms) else None
    if first is not None and first[0] < 0:
        if oracle.is_positive(-first[1]):
            return Series({}, EXACT)  # smaller than every power
        raise Undecided("an exponential that may grow beyond every power")
    start, rest = _apart(s)
    body = composed(rest, [Fraction(1, factorial(k)) for k in range(MOST_STEPS)], depth)
    if (found := power_of_small(start)) is not None:
        exponent, start = found
        body = times(Series({exponent: number(1)}), body)
    if start == number(0):
        return body
    return times(constant(Expr("call", "exp", (start,))), body)


def _logarithm(s: Series, oracle: Oracle, depth: Fraction) -> Series:
    e, c, rest = split(s, oracle)
    if not oracle.is_positive(c) or (e != 0 and oracle.logarithm is None):
        raise Undecided("a logarithm of something that tends to zero, to infinity or is negative")
    weights = [Fraction(0), *[Fraction((-1) ** (k + 1), k) for k in range(1, MOST_STEPS)]]
    body = composed(rest, weights, depth)
    if e != 0 and oracle.logarithm is not None:
        body = plus(constant(mul(number(e), oracle.logarithm)), body)
    return body if c == number(1) else plus(constant(Expr("call", "log", (c,))), body)


def _arc_tangent(s: Series, oracle: Oracle, depth: Fraction) -> Series:
    """atan s = pi/2 - atan(1/s) for a large s > 0, and atan(a + x) = atan a + atan(x/(1 + a (a +
    x))) for a small x.
    """
    first = leading(s, oracle) if any(e < 0 for e in s.terms) else None
    if first is not None and first[0] < 0:
        if not oracle.is_positive(first[1]) and not oracle.is_positive(-first[1]):
            raise Undecided("an arc tangent of something that grows, of a sign that is not known")
        sign = 1 if oracle.is_positive(first[1]) else -1
        quarter = number(Fraction(sign, 2)) * Expr("call", "pi", ())
        inner = _arc_tangent(powered(s, Fraction(-1), oracle, depth), oracle, depth)
        return plus(constant(quarter), opposite(inner))
    start, rest = _apart(s)
    if start == number(0):
        weights = [Fraction(0, 1), *(_odd(k) for k in range(1, MOST_STEPS))]
        return composed(rest, weights, depth)
    below = plus(constant(number(1)), times(constant(start), s))
    inner = times(rest, powered(below, Fraction(-1), oracle, depth))
    found = _arc_tangent(inner, oracle, depth)
    return plus(constant(Expr("call", "atan", (start,))), found)


def _odd(k: int) -> Fraction:
    """The coefficient of x^k in the expansion of atan x."""
    return Fraction(k % 2 * (-1) ** (k // 2), k)


def _angle(name: str, s: Series, oracle: Oracle, depth: Fraction) -> Series:
    start, rest = _apart(s)
    sine = composed(rest, _weights((0, 1, 0, -1)), depth)
    cosine = composed(rest, _weights((1, 0, -1, 0)), depth)
    if start != number(0):
        c, r = (constant(Expr("call", f, (start,))) for f in ("cos", "sin"))
        sine, cosine = (
            plus(times(r, cosine), times(c, sine)),
            plus(times(c, cosine), opposite(times(r, sine))),
        )
    if name == "tan":
        return times(sine, powered(cosine, Fraction(-1), oracle, depth))
    return sine if name == "sin" else cosine


def _weights(first: tuple[int, ...]) -> list[Fraction]:
    """The expansion of sine or cosine, whose derivatives at zero repeat."""
    return [Fraction(first[k % len(first)], factorial(k)) for k in range(MOST_STEPS)]


def _power(base: Series, exponent: Series, oracle: Oracle, depth: Fraction) -> Series:
    """base^exponent: smaller than every power where |base| < 1 and the exponent grows, else by the
    logarithm.
    """
    fixed = base.order == EXACT and set(base.terms) <= {Fraction(0)}
    if fixed and any(e < 0 for e in exponent.terms):
        c = base.terms.get(Fraction(0), number(0))
        first = leading(exponent, oracle)
        if first is not None and first[0] < 0 and oracle.is_positive(first[1]):
            if oracle.is_positive(1 - power(c, 2)):
                return Series({}, EXACT)
            raise Undecided("a power that may grow beyond every power")
    return _exponential(times(exponent, _logarithm(base, oracle, depth)), oracle, depth)
