"""Expressions over the triangle 0 < v < w < sqrt(3) as elements of a field of functions.

An element is a polynomial in v, w, free symbols and square roots, over a polynomial without roots.
Roots are taken of different irreducible polynomials, positive where the chart is, and of different
primes: no product of some of them is a square, so their products are linearly independent over the
rational functions, and an element is zero only if its coefficients are. Nothing is sampled, no
branch is open: every root is the positive one, and what a square root of a square is follows from
the sign of its base.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import flint

from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.polynomial import (
    Poly,
    coefficients_in,
    constant,
    degree,
    fraction,
    grouped,
    ring,
)
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Undecided
from gainproof.verify.judge.setting.triangle_signs import sign_on_triangle

LOW, HIGH = "chart v", "chart w"
"""The base variables; 0 < v < w < sqrt(3) unless another domain is said."""
MOST_ROOTS = 12
SignInside = Callable[[Poly, int, int], int | None]
"""The sign that a polynomial of v and w keeps on the domain of these, None where none is shown."""


@dataclass(frozen=True)
class Quotient:
    """num / den; den holds no roots and is not the zero polynomial."""

    num: Poly
    den: Poly


@dataclass(frozen=True)
class Gap:
    """A divisor that is not shown to be nowhere zero; `exact` says that it is zero just where a
    polynomial without roots is.
    """

    divisor: Expr
    exact: bool


@dataclass
class ChartField:
    """The field over v, w and free symbols, those in `positive` greater than zero."""

    free: tuple[str, ...]
    positive: frozenset[str]
    sign_inside: SignInside = sign_on_triangle
    squares: list[Poly] = field(default_factory=list)
    gaps: dict[bytes, Gap] = field(default_factory=dict)
    elements: dict[bytes, Quotient] = field(default_factory=dict)

    def __post_init__(self) -> None:
        names = [f"g{k}" for k in range(MOST_ROOTS)] + [f"u{k}" for k in range(len(self.free))]
        self.ring: Any = ring([*names, "v", "w"])
        self.one = constant(self.ring, 1)
        self.low, self.high = len(names), len(names) + 1

    def element(self, expr: Expr) -> Quotient:
        """What an expression is wherever it has a value. Raises Undecided."""
        for node in walk(expr):
            if node.key not in self.elements:
                self.elements[node.key] = self._node(node)
        return self.elements[expr.key]

    def sign(self, p: Poly) -> int | None:
        """The sign of a polynomial that is shown to keep it wherever the chart is, else None.

        Roots and positive symbols are positive: their coefficients must have one sign.
        """
        degrees = p.degrees()
        outer = [i for i in range(self.low) if degrees[i] > 0]
        loose = [MOST_ROOTS + k for k, n in enumerate(self.free) if n not in self.positive]
        if any(i in loose for i in outer):
            return None
        signs = {self._sign_of(part) for part in grouped(p, outer).values()}
        return signs.pop() if len(signs) == 1 else None

    def _sign_of(self, p: Poly) -> int | None:
        lead, factors = p.factor()
        sign = 1 if fraction(lead) > 0 else -1
        for factor, exponent in factors:
            known = self.sign_inside(factor, self.low, self.high)
            if known is None:
                return None
            sign *= known**exponent
        return sign

    def _node(self, node: Expr) -> Quotient:
        parts = [self.elements[p.key] for p in node.parts]
        match node.kind:
            case "number":
                return Quotient(constant(self.ring, node.fraction), self.one)
            case "symbol":
                return Quotient(self._variable(node.name), self.one)
            case "add":
                total = parts[0]
                for other in parts[1:]:
                    total = self.sum(total, other)
                return total
            case "mul":
                total = parts[0]
                for other in parts[1:]:
                    total = self.product(total, other)
                return total
            case "neg":
                return Quotient(-parts[0].num, parts[0].den)
            case "div":
                return self.product(parts[0], self._inverse(node.parts[1], parts[1]))
            case "pow":
                return self._power(node, parts[0])
            case _:
                raise Undecided(f"{node.value or node.kind} is not covered over a chart")

    def _variable(self, name: str) -> Poly:
        if name in (LOW, HIGH):
            return self.ring.gen(self.low if name == LOW else self.high)
        if name not in self.free:
            raise Undecided(f"the symbol {name} has no meaning over the chart")
        return self.ring.gen(MOST_ROOTS + self.free.index(name))

    def sum(self, x: Quotient, y: Quotient) -> Quotient:
        """x + y."""
        if x.den == y.den:
            return self._tidy(x.num + y.num, x.den)
        return self._tidy(x.num * y.den + y.num * x.den, x.den * y.den)

    def product(self, x: Quotient, y: Quotient) -> Quotient:
        """x y."""
        return self._tidy(x.num * y.num, x.den * y.den)

    def _reduced(self, p: Poly) -> Poly:
        degrees = p.degrees()
        for index, square in enumerate(self.squares):
            if degrees[index] >= 2:
                p = divmod(p, self.ring.gen(index) ** 2 - square)[1]
                degrees = p.degrees()
        if len(p) > DEFAULT_LIMITS.terms:
            raise Undecided(f"a polynomial of more than {DEFAULT_LIMITS.terms} terms")
        return p

    def _tidy(self, num: Poly, den: Poly) -> Quotient:
        num = self._reduced(num)
        if num.is_zero():
            return Quotient(num, self.one)
        common = num.gcd(den)
        if not common.is_constant():
            num, den = divmod(num, common)[0], divmod(den, common)[0]
        lead = den.leading_coefficient()
        return Quotient(num / lead, den / lead)

    def _inverse(self, what: Expr, x: Quotient) -> Quotient:
        """1 / x with the roots brought up; x that may be zero is a gap."""
        if x.num.is_zero():
            raise Undecided("a divisor is zero everywhere")
        top, norm = x.den, x.num
        for index in range(len(self.squares)):
            if degree(norm, index) > 0:
                a, b = coefficients_in(norm, index, 2)
                other = a - b * self.ring.gen(index)
                top, norm = self._reduced(top * other), self._reduced(norm * other)
        if self.sign(x.num) is None and self._may_vanish(norm):
            plain = all(degree(x.num, i) <= 0 for i in range(len(self.squares)))
            self.gaps.setdefault(what.key, Gap(what, plain))
        return self._tidy(top, norm)

    def _may_vanish(self, norm: Poly) -> bool:
        return any(self.sign(factor) is None for factor, _ in norm.factor()[1])

    def _power(self, node: Expr, base: Quotient) -> Quotient:
        exponent = node.fraction
        if exponent.denominator == 2:
            base = self._root(base)
        elif exponent.denominator != 1:
            raise Undecided("a root that is no square root")
        times = abs(exponent.numerator)
        if times > DEFAULT_LIMITS.exponent:
            raise Undecided(f"an exponent beyond {DEFAULT_LIMITS.exponent}")
        if exponent < 0:
            base = self._inverse(node.parts[0], base)
        result = Quotient(self.one, self.one)
        for _ in range(times):
            result = self.product(result, base)
        return result

    def _root(self, base: Quotient) -> Quotient:
        """The square root that is not negative."""
        if any(degree(base.num, i) > 0 for i in range(len(self.squares))):
            raise Undecided("a root of a root that is no square over the chart")
        if base.num.is_zero():
            return base
        number, inside, tops = Fraction(1), self.one, [self.one, self.one]
        sign = 1
        for place, side in enumerate((base.num, base.den)):
            lead, factors = side.factor()
            number = number * fraction(lead) if place == 0 else number / fraction(lead)
            for factor, count in factors:
                known = self.sign(factor)
                if known is None:
                    raise Undecided("a root of something whose sign is not known on the chart")
                sign *= known**count
                positive = factor * known
                tops[place] = tops[place] * positive ** (count // 2)
                if count % 2:
                    inside = inside * self._generator(positive)
                    # root(1 / f) = root(f) / f
                    tops[1] = tops[1] * positive if place == 1 else tops[1]
        if number * sign < 0:
            raise Undecided("a square root of a negative number everywhere on the chart")
        whole = self._number_root(abs(number))
        made = self._tidy(tops[0] * inside, tops[1])
        return self.product(made, whole)

    def _generator(self, square: Poly) -> Poly:
        if square in self.squares:
            return self.ring.gen(self.squares.index(square))
        if len(self.squares) == MOST_ROOTS:
            raise Undecided(f"more than {MOST_ROOTS} roots over the chart")
        self.squares.append(square)
        return self.ring.gen(len(self.squares) - 1)

    def _number_root(self, value: Fraction) -> Quotient:
        """root(u / v) = root(u v) / v, primes that stay under it as generators."""
        num, den = self.one, constant(self.ring, value.denominator)
        for prime, count in flint.fmpz(value.numerator * value.denominator).factor():
            num = num * int(prime) ** (int(count) // 2)
            if count % 2:
                num = num * self._generator(constant(self.ring, int(prime)))
        return self._tidy(num, den)


def field_over(
    names: set[str], positive: Mapping[str, bool], sign_inside: SignInside = sign_on_triangle
) -> ChartField:
    """The field for expressions of these symbols."""
    free = tuple(sorted(names - {LOW, HIGH}))
    return ChartField(free, frozenset(name for name in free if positive.get(name)), sign_inside)
