"""Fixed points in the graphs of kernels: the value of v where the positive unknown x is y(x).

Which value that is is guessed: a coefficient of the closed loop times a number and a power of the
index. What makes it the value is that it is positive and a fixed point for every value of the
parameter, and that there is no other: read off its shape, the logarithmic slope of y is below 1, so
that log x - log y(x) rises with log x throughout.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import log2

from gainproof.verify.judge.exact.balls import enclosed
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import (
    Expr,
    mul,
    number,
    power,
    sqrt,
    symbol,
    symbols_of,
    walk,
)
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.setting.environment import INDEX
from judged_derivations.surroundings import Surroundings

UNKNOWN = "the unknown"
ROOTED = "a fixed point in a kernel whose tracking index holds roots: too many roots of roots"
HALF = Fraction(1, 2)
CLOSE = 1e-12
PLACES = (Fraction(1, 2), Fraction(3))
STEPS = 60
BITS = 128
Range = tuple[Fraction, Fraction]
FLAT: Range = (Fraction(0), Fraction(0))


def without_fixed_points(where: Surroundings, expr: Expr) -> Expr:
    """The expression with every fixed point replaced by its value. Raises Undecided, Malformed."""
    found: dict[bytes, Expr] = {}
    maps: dict[bytes, Expr] = {}
    for node in walk(expr):
        if _is_call(node, "fixed_point"):
            unknown, image, _ = node.parts
            if unknown.key not in found:
                found[unknown.key] = _value(where, unknown, image)
                maps[unknown.key] = image
            elif maps[unknown.key] != image:
                raise Malformed("an unknown with two maps")
    if not found:
        return expr

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        if node.key in found:
            return found[node.key]
        return parts[2] if _is_call(node, "fixed_point") else None

    return rebuilt(expr, change)


def _value(where: Surroundings, unknown: Expr, image: Expr) -> Expr:
    """The one positive fixed point of the map. Raises Undecided."""
    if any(_is_call(node, "unknown") and node != unknown for node in walk(image)):
        raise Undecided("a map with another unknown in it")
    guess = _guess(where, _put(image, unknown, symbol(UNKNOWN)))
    there = _put(image, unknown, guess)
    _require(where, Rel(">", guess, number(0)), Rel("=", there, guess))
    slopes: dict[bytes, Range] = {}
    for node in walk(image):
        slopes[node.key] = _slope(where, node, [slopes[p.key] for p in node.parts], unknown)
    if not slopes[image.key][1] < 1:
        raise Undecided("a map that may have several fixed points")
    return guess


def _slope(where: Surroundings, node: Expr, below: list[Range], unknown: Expr) -> Range:
    """Between what the logarithmic slope of a positive part of the map lies."""
    if node == unknown:
        return Fraction(1), Fraction(1)
    if not any(part == unknown for part in walk(node)):
        return FLAT
    for part, slope in zip(node.parts, below, strict=True):
        # what holds the unknown is positive as its own parts are
        if slope is FLAT:
            _require(where, Rel(">", part, number(0)))
    match node.kind:
        case "add":
            return min(low for low, _ in below), max(high for _, high in below)
        case "mul":
            return sum((s[0] for s in below), Fraction(0)), sum((s[1] for s in below), Fraction(0))
        case "div":
            (low, high), (first, last) = below
            return low - last, high - first
        case "pow":
            ends = sorted(node.fraction * end for end in below[0])
            return ends[0], ends[1]
        case _:
            raise Undecided("a map that is made of more than positive terms")


def _require(where: Surroundings, *relations: Rel) -> None:
    found = settle(Statement(relations), where.boxes, where.parameter, {})
    if found.verdict != "proved":
        raise Undecided(f"of a fixed point it is not known that {found.reason}")


def _guess(where: Surroundings, image: Expr) -> Expr:
    """The fixed point as a multiple of a known one, to many digits at a few places."""
    name = where.parameter or ""
    found = _multiple(where, [_iterated(image, {name: place}) for place in PLACES])
    if found is None:
        raise Undecided("no coefficient of the closed loop tells the value of a fixed point")
    return found


def _multiple(where: Surroundings, wanted: Sequence[float]) -> Expr | None:
    """A coefficient of the closed loop times powers of 2 and of the index with these values."""
    name = where.parameter or ""
    for base in _bases(where):
        values = [float(enclosed(base, {name: place}, BITS).mid()) for place in PLACES]
        ratios = [w / v for v, w in zip(values, wanted, strict=True)]
        if min(ratios) <= 0:
            continue
        exponent = round(log2(ratios[0]))
        if all(abs(ratio * 2.0**-exponent - 1) < CLOSE for ratio in ratios):
            return number(Fraction(2) ** exponent) * base
    return None


def _bases(where: Surroundings) -> Iterator[Expr]:
    """The coefficients of the closed loop of three states after z = (1 + s)/(1 - s), over the first
    one, times powers of the index.
    """
    if not {"alpha", "beta", "gamma"} <= set(where.values):
        return
    a, b, c = (where.values[name] for name in ("alpha", "beta", "gamma"))
    root = sqrt(sqrt(where.value(INDEX)))
    for top in (2 * b, 4 * a - c, 8 - 4 * a - 2 * b):
        part = tidied(top / c)
        for k in range(-4, 5):
            yield mul(part, power(root, k)) if k else part


def has_roots(expr: Expr) -> bool:
    """Whether it holds roots of anything."""
    return any(n.kind == "pow" and n.fraction.denominator != 1 for n in walk(expr))


def _iterated(image: Expr, place: dict[str, Fraction]) -> float:
    found = Fraction(1)
    for _ in range(STEPS):
        ball = enclosed(image, {**place, UNKNOWN: found}, BITS)
        found = Fraction(float(ball.mid()))
    return float(found)


def _put(expr: Expr, unknown: Expr, value: Expr) -> Expr:
    return rebuilt(expr, lambda node, _: value if node == unknown else None)


def _is_call(node: Expr, name: str) -> bool:
    return node.kind == "call" and node.name == name


def with_known_roots(where: Surroundings, expr: Expr) -> Expr:
    """Square roots that are multiples of a coefficient of the closed loop written as these: each is
    shown to be positive and to have the right square. Others stay. Raises Undecided.
    """
    if not any(_is_call(node, "unknown") for node in walk(expr)):
        return expr
    if has_roots(where.value(INDEX)):
        raise Undecided(ROOTED)
    name = where.parameter or ""

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        if node.kind != "pow" or node.fraction != HALF:
            return None
        (inside,) = parts
        if symbols_of(inside) != {name} or any(n.kind == "call" for n in walk(inside)):
            return None
        root = power(inside, HALF)
        values = [float(enclosed(root, {name: place}, BITS).mid()) for place in PLACES]
        found = _multiple(where, values)
        if found is not None:
            _require(where, Rel(">", found, number(0)), Rel("=", power(found, 2), inside))
        return found

    return rebuilt(expr, change)
