"""Function values that become variables: b^(m/d), tan(m/(2d)), and anything else as a whole."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from math import lcm

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.expression import (
    Expr,
    neg,
    number,
    power,
    symbol,
    symbols_of,
    walk,
)
from gainproof.verify.judge.exact.expression_text import written
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.freed.half_tangent import half_tangent
from gainproof.verify.judge.freed.monomials import (
    UNIT,
    Monomial,
    monomial_expr,
    monomials,
    terms_expr,
)
from gainproof.verify.judge.meaning.domains import is_whole
from gainproof.verify.judge.meaning.sequences import is_term

EULER = symbol("e")
"""Base of exponentials; no base variable is called like that."""
ANGLES = ("sin", "cos", "tan")
MOST_FACTORS = 1_000_000

Positive = Callable[[Expr], bool]
Key = tuple[str, Expr, Monomial]


@dataclass
class Atoms:
    """The variables made so far. `divisors` holds the common denominator of each exponent."""

    boxes: Mapping[str, Box]
    is_positive: Positive
    divisors: dict[Key, int] = field(default_factory=dict)
    made: dict[str, Box] = field(default_factory=dict)
    names: dict[Key, str] = field(default_factory=dict)
    exclusions: dict[Expr, str] = field(default_factory=dict)

    def collect(self, *roots: Expr) -> None:
        """Notes every power, exponential and angle below the roots."""
        for node in walk(*roots):
            if node.kind != "call" or _nested(node):
                continue
            for key, c in [*self.exponents(node), *angle_terms(node)]:
                self.divisors[key] = lcm(self.divisors.get(key, 1), c.denominator)

    def exponents(self, node: Expr) -> list[tuple[Key, Fraction]]:
        """A power or exponential as a product of b^m with rational exponents; empty for others.

        Raises Undecided for an exponent that is not whole, of a base not known to be positive.
        """
        if node.name == "exp":
            bases, exponent = {EULER: 1}, monomials(node.parts[0])
        elif node.name == "power":
            bases, exponent = _bases(node.parts[0]), monomials(node.parts[1])
        else:
            return []
        found = []
        for base, times in bases.items():
            positive = base == EULER or self.is_positive(base)
            for monomial, c in exponent.items():
                whole = is_whole(monomial_expr(monomial), self.boxes)
                if not positive and not (whole and c.denominator == 1):
                    raise Undecided("a power with a base that may be negative, exponent not whole")
                if not positive and monomial != UNIT:
                    self._refuse_zero(base, monomial, c * times)
                found.append((("power", base, monomial), c * times))
        return found

    def power(self, key: Key) -> tuple[Expr, int]:
        """The variable for b^(m/d), and d."""
        _, base, monomial = key
        divisor = self.divisors[key]
        if monomial == UNIT and base != EULER and divisor == 1:
            return base, 1
        positive = base == EULER or self.is_positive(base)
        return self._named(key, self._range(base, monomial, positive)), divisor

    def _refuse_zero(self, base: Expr, monomial: Monomial, c: Fraction) -> None:
        """Raises Undecided if zero may be raised to a negative number.

        Where nothing was said of the base, that it is zero is left out.
        """
        rising = c > 0 and self.is_positive(monomial_expr(monomial) + 1)
        if rising or self.is_positive(power(base, 2)):
            return
        unstated = all(not self.boxes[n].stated for n in symbols_of(base) if n in self.boxes)
        self.exclusions[base] = f"where {written(base)[1][0]} is not zero"
        if not unstated:
            raise Undecided("a power that may have base zero and a negative exponent")

    def _range(self, base: Expr, monomial: Monomial, positive: bool) -> Box:
        """Above 1, between 0 and 1, positive, or anything."""
        if not positive:
            return self._any(base, monomial_expr(monomial))
        grows = base == EULER or self.is_positive(base - 1)
        falls = not grows and self.is_positive(1 - base)
        exponent = monomial_expr(monomial)
        up, down = self.is_positive(exponent), self.is_positive(neg(exponent))
        if (grows and up) or (falls and down):
            return Box(lower=Fraction(1))
        if (grows and down) or (falls and up):
            return Box(lower=Fraction(0), upper=Fraction(1))
        return Box(lower=Fraction(0))

    def half_angle(self, monomial: Monomial) -> tuple[Expr, int]:
        """The variable for tan(m/(2d)), and d."""
        key: Key = ("angle", number(1), monomial)
        angle, divisor = monomial_expr(monomial), self.divisors[key]
        known = self.boxes.get(angle.name) if angle.kind == "symbol" else None
        box = None if known is None else half_tangent(known, divisor)
        return self._named(key, box or self._any(angle)), divisor

    def box_of(self, key: Key) -> Box:
        """Where the variable of a key lies."""
        return self.made[self.names[key]]

    @property
    def has_angles(self) -> bool:
        """Whether an angle is among them."""
        return any(kind == "angle" for kind, _, _ in self.names)

    def labels(self) -> dict[str, str]:
        """What each variable stands for, readable."""
        found = {}
        for (kind, base, monomial), name in self.names.items():
            inner = base if kind == "value" else monomial_expr(monomial)
            text = written(inner)[1][0]
            if kind == "angle":
                text = f"tan(half of {text})"
            elif kind == "power":
                text = f"({written(base)[1][0]})^({text})"
            found[name] = text
        return found

    def whole(self, node: Expr) -> Expr:
        """The variable for a function value of which nothing is known but that it exists.

        Raises Undecided where that is not known either.
        """
        if is_term(node):
            index = terms_expr(monomials(node.parts[0]))
            return self._named(("value", Expr("call", node.name, (index,)), UNIT), self._any(index))
        if node.name == "log" and not self.is_positive(node.parts[0]):
            raise Undecided("a logarithm of something that is not known to be positive")
        if node.name not in ("log", "atan", "sum") or (_nested(node) and node.name != "sum"):
            raise Undecided(f"the function {node.name} of this argument is not covered")
        key: Key = ("value", _with_plain_index(node), UNIT)
        return self._named(key, self._any(node))

    def _any(self, *exprs: Expr) -> Box:
        """Any number; stated, so that no divisor may vanish, where a domain behind it is stated."""
        stated = any(self.boxes[n].stated for n in symbols_of(*exprs) if n in self.boxes)
        return Box(stated=stated)

    def _named(self, key: Key, box: Box) -> Expr:
        if key not in self.names:
            self.names[key] = f"freed {len(self.names)}"
            self.made[self.names[key]] = box
        return symbol(self.names[key])


def angle_terms(node: Expr) -> list[tuple[Key, Fraction]]:
    """The argument of a sine, cosine or tangent; empty for other calls."""
    if node.name not in ANGLES:
        return []
    return [(("angle", number(1), m), c) for m, c in monomials(node.parts[0]).items()]


def is_opaque(node: Expr) -> bool:
    """Whether a call is taken as a whole."""
    return _nested(node) or node.name not in ("exp", "power", *ANGLES)


def _nested(node: Expr) -> bool:
    return any(below.kind == "call" for part in node.parts for below in walk(part))


def _with_plain_index(expr: Expr) -> Expr:
    """Sums with their indices named by how deep they nest, so that equal sums are one."""
    depths: dict[bytes, int] = {}

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        depth = max((depths[p.key] for p in node.parts), default=0)
        is_sum = node.kind == "call" and node.name == "sum"
        depths[node.key] = depth + is_sum
        if not is_sum:
            return None
        plain = {node.parts[1].name: symbol(f"index {depth}")}
        return Expr("call", "sum", tuple(substituted(p, plain) for p in parts))

    return rebuilt(expr, change)


def _bases(base: Expr) -> dict[Expr, int]:
    """A product of powers as base -> exponent, numbers as their primes; else the whole base."""
    terms = monomials(base)
    if len(terms) != 1:
        return {terms_expr(terms): 1}
    ((monomial, c),) = terms.items()
    found = {terms_expr(monomials(each)): n for each, n in monomial}
    for value, sign in ((abs(c.numerator), 1), (c.denominator, -1)):
        for prime, n in _primes(value).items():
            found[number(prime)] = found.get(number(prime), 0) + sign * n
    if c < 0:
        found[number(-1)] = 1
    return found


def _primes(value: int) -> dict[int, int]:
    if value > MOST_FACTORS:
        return {value: 1}
    found: dict[int, int] = {}
    prime = 2
    while value > 1:
        if prime * prime > value:
            prime = value
        while value % prime == 0:
            found[prime] = found.get(prime, 0) + 1
            value //= prime
        prime += 1
    return found
