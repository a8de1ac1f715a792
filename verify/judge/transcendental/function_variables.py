"""Function values that become variables: b^(m/d), tan(m/(2d)), and anything else as a whole."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from fractions import Fraction
from math import lcm

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.expression import (
    Expr,
    number,
    power,
    symbol,
    symbols_of,
    walk,
)
from gainproof.verify.judge.exact.expression_text import SERIES, is_series, written
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.meaning.base_variables import is_whole
from gainproof.verify.judge.meaning.sequences import is_term
from gainproof.verify.judge.transcendental.monomials import (
    UNIT,
    Monomial,
    monomial_expr,
    monomials,
    terms_expr,
)
from gainproof.verify.judge.transcendental.pi import LABEL, VARIABLE
from gainproof.verify.judge.transcendental.power_bases import bases_of
from gainproof.verify.judge.transcendental.variable_ranges import EULER, Positive, Ranges

ANGLES = ("sin", "cos", "tan")
MINUS = number(-1)

Key = tuple[str, Expr, Monomial]


@dataclass
class Atoms:
    """The variables made so far. `divisors` holds the common denominator of each exponent.

    `turned` are the angles whose variable is the tangent of half of the angle plus half a turn: it
    reaches the angle that the other misses.
    """

    boxes: Mapping[str, Box]
    is_positive: Positive
    turned: frozenset[Key] = frozenset()
    divisors: dict[Key, int] = field(default_factory=dict)
    made: dict[str, Box] = field(default_factory=dict)
    names: dict[Key, str] = field(default_factory=dict)
    exclusions: dict[Expr, str] = field(default_factory=dict)

    @property
    def ranges(self) -> Ranges:
        """Where the variables live."""
        return Ranges(self.boxes, self.is_positive)

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
            bases, exponent = bases_of(node.parts[0]), monomials(node.parts[1])
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
        return self._named(key, self.ranges.power(base, monomial, divisor, positive)), divisor

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

    def half_angle(self, monomial: Monomial) -> tuple[Expr, int]:
        """The variable for tan(m/(2d)), and d."""
        key: Key = ("angle", number(1), monomial)
        box = self.ranges.tangent(monomial, self.divisors[key], turned=key in self.turned)
        return self._named(key, box), self.divisors[key]

    def whole_turns(self, *, unstated: bool) -> list[Key]:
        """The angles that may be half a turn, where there is no tangent; those over no stated
        domain only if asked for.
        """
        return [
            key
            for key, name in self.names.items()
            if key[0] == "angle" and (unstated or self.made[name].stated)
            if not self.ranges.is_below_half_turn(key[2], self.divisors[key])
        ]

    def quarter_turns(self) -> list[Rel]:
        """That arc tangents lie between -pi/2 and pi/2."""
        found = [
            symbol(name)
            for (kind, node, _), name in self.names.items()
            if kind == "value" and node.name == "atan"
        ]
        quarter = VARIABLE / 2
        return [
            Rel(operator, each, bound)
            for each in found
            for operator, bound in (("<", quarter), (">", -quarter))
        ]

    def signs(self) -> list[Rel]:
        """That powers of -1 are 1 or -1."""
        powers = [n for key, n in self.names.items() if key[:2] == ("power", MINUS)]
        return [Rel("=", power(symbol(each), 2), number(1)) for each in powers]

    def labels(self) -> dict[str, str]:
        """What each variable stands for, readable."""
        found = {}
        for (kind, base, monomial), name in self.names.items():
            inner = base if kind == "value" else monomial_expr(monomial)
            text = written(substituted(inner, {VARIABLE.name: symbol(LABEL)}))[1][0]
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
            return self._named(
                ("value", Expr("call", node.name, (index,)), UNIT), Box(stated=False)
            )
        if node.name == "log" and not self.is_positive(node.parts[0]):
            raise Undecided("a logarithm of something that is not known to be positive")
        if node.name not in ("log", "atan", *SERIES, "erf") or (
            _nested(node) and node.name not in (*SERIES, "log")
        ):
            raise Undecided(f"the function {node.name} of this argument is not covered")
        plain = _with_plain_index(node)
        if not is_series(node):
            with suppress(Undecided):  # too long
                # equal arguments written otherwise; that they have values is asked for by itself
                plain = Expr("call", node.name, tuple(terms_expr(monomials(p)) for p in node.parts))
        key: Key = ("value", plain, UNIT)
        return self._named(key, self.ranges.value(node))

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
    """Sums and products with their indices named by how deep they nest, so that equal ones are
    one.
    """
    depths: dict[bytes, int] = {}

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        depth = max((depths[p.key] for p in node.parts), default=0)
        depths[node.key] = depth + is_series(node)
        if not is_series(node):
            return None
        plain = {node.parts[1].name: symbol(f"index {depth}")}
        return Expr("call", node.name, tuple(substituted(p, plain) for p in parts))

    return rebuilt(expr, change)
