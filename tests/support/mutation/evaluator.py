"""Values of trees in multiprecision, from oracles: independent of the judge and of every
derivation.

Derivatives are central differences of step 1e-25 at 90 digits, good to about 40 digits.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache
from typing import Any

import mpmath

from gainproof.verify.oracles import doubling, least_squares
from gainproof.verify.oracles.state_space import state_space
from mutation.tree import Tree

DIGITS = 90
AGREED = mpmath.mpf(10) ** -35
"""Relative difference below which two values count as equal."""

Values = Mapping[str, Any]
Point = Fraction


class NoValue(Exception):
    """Division by zero, an even root of a negative number, or a symbol without value."""


class Misshapen(Exception):
    """Matrices whose sizes do not fit: no relation at all, so neither true nor false."""


@dataclass
class Subject:
    """What symbols are worth at a point; `variable` is what derivatives and shifts are taken in."""

    variable: str
    quantities: Callable[[Fraction], Values]
    roots: Mapping[str, tuple[int, Tree]] = field(default_factory=dict)
    free: Mapping[str, Any] = field(default_factory=dict)

    def value(self, tree: Tree, point: Fraction) -> Any:
        """The number (or matrix, as rows) of a tree. Raises NoValue."""
        with mpmath.workdps(DIGITS):
            return self._value(tree, point)

    def _symbol(self, name: str, point: Fraction) -> Any:
        if name == self.variable:
            return _real(point)
        if name in self.free:
            return self.free[name]
        if name in self.roots:
            order, radicand = self.roots[name]
            return _root(self._value(radicand, point), Fraction(1, order))
        values = self.quantities(point)
        if name not in values:
            raise NoValue(name)
        return values[name]

    def _value(self, tree: Tree, point: Fraction) -> Any:
        kind = tree[0]
        match kind:
            case "number":
                return _real(tree[1])
            case "symbol":
                return self._symbol(tree[1], point)
            case "matrix":
                rows, columns = tree[1], tree[2]
                entries = [self._value(part, point) for part in tree[3:]]
                return [entries[r * columns : (r + 1) * columns] for r in range(rows)]
            case "derivative":
                return self._difference(tree[1], tree[2], point)
            case "at":
                return self._value(tree[1], _rational(self._value(tree[3], point)))
            case "call":
                if tree[1] != "abs":
                    raise NoValue(tree[1])
                return abs(self._value(tree[2], point))
            case "pow":
                return _root(self._value(tree[1], point), tree[2])
            case "neg":
                return _times(-1, self._value(tree[1], point))
        parts = [self._value(part, point) for part in tree[1:]]
        if kind == "div":
            if isinstance(parts[1], list) or parts[1] == 0:
                raise NoValue("division by zero")
            return _times(1 / parts[1], parts[0])
        total = parts[0]
        for part in parts[1:]:
            total = _plus(total, part) if kind == "add" else _product(total, part)
        return total

    def _difference(self, tree: Tree, name: str, point: Fraction) -> Any:
        step = point * Fraction(1, 10**25)
        high, low = self._value(tree, point + step), self._value(tree, point - step)
        top = self._symbol(name, point + step) - self._symbol(name, point - step)
        return _times(1 / top, _plus(high, _times(-1, low)))


def _real(x: Fraction) -> Any:
    return mpmath.mpf(x.numerator) / x.denominator


def _rational(x: Any) -> Fraction:
    """A multiprecision number that is a simple rational, as one."""
    return Fraction(str(mpmath.nstr(x, 60, strip_zeros=False))).limit_denominator(10**12)


def _root(base: Any, exponent: Fraction) -> Any:
    if isinstance(base, list):
        raise Misshapen("power of a matrix")
    if (base == 0 and exponent < 0) or (base < 0 and exponent.denominator % 2 == 0):
        raise NoValue("power")
    if exponent.denominator == 1:
        return base ** int(exponent)
    sign = -1 if base < 0 and exponent.numerator % 2 else 1
    return sign * mpmath.root(abs(base), exponent.denominator) ** exponent.numerator


def _plus(a: Any, b: Any) -> Any:
    if isinstance(a, list) != isinstance(b, list):
        raise Misshapen("sum of a matrix and a number")
    if isinstance(a, list):
        if len(a) != len(b) or len(a[0]) != len(b[0]):
            raise Misshapen("sizes")
        return [[x + y for x, y in zip(p, q, strict=True)] for p, q in zip(a, b, strict=True)]
    return a + b


def _times(factor: Any, a: Any) -> Any:
    return [[factor * x for x in row] for row in a] if isinstance(a, list) else factor * a


def _product(a: Any, b: Any) -> Any:
    if not isinstance(a, list):
        return _times(a, b)
    if not isinstance(b, list):
        return _times(b, a)
    if len(a[0]) != len(b):
        raise Misshapen("sizes")
    return [
        [sum(x * y for x, y in zip(row, col, strict=True)) for col in zip(*b, strict=True)]
        for row in a
    ]


def differ(a: Any, b: Any) -> bool:
    """Whether two values differ by more than rounding can."""
    if isinstance(a, list) != isinstance(b, list):
        raise Misshapen("a matrix and a number")
    if isinstance(a, list):
        if len(a) != len(b) or len(a[0]) != len(b[0]):
            raise Misshapen("sizes")
        return any(
            differ(x, y) for p, q in zip(a, b, strict=True) for x, y in zip(p, q, strict=True)
        )
    return bool(abs(a - b) > AGREED * max(abs(a), abs(b), mpmath.mpf(10) ** -10))


@cache
def _steady(model: tuple[tuple[str, Any], ...], point: Fraction) -> Values:
    data = {name: [list(row) for row in rows] for name, rows in model}
    state = doubling.steady_state(state_space(data, point), DIGITS).state
    with mpmath.workdps(DIGITS):
        index = _real(point)

        def real(x: Any) -> Any:
            return mpmath.mpf(x)

        gain = [real(row[0]) for row in state.gain]
        values: dict[str, Any] = {"tracking_index": index, "alpha": gain[0], "beta": gain[1]}
        transition = data["transition"]
        forward = [
            sum(_real(Fraction(f)) * g for f, g in zip(row, gain, strict=True))
            for row in transition
        ]
        values["predictor_position"] = forward[0]
        values["rest"] = 1 - gain[0]
        values["innovation_variance"] = real(state.innovation[0][0])
        values["innovation_deviation"] = mpmath.sqrt(values["innovation_variance"])
        for which, matrix in (("predicted", state.predicted), ("updated", state.updated)):
            for i, row in enumerate(matrix):
                for j, entry in enumerate(row):
                    values[f"{which}_{i + 1}{j + 1}"] = real(entry)
        return values


def steady_subject(
    model: Mapping[str, Any],
    roots: Mapping[str, tuple[int, Tree]] | None = None,
    free: Values | None = None,
) -> Subject:
    """Symbols of a steady state as functions of the tracking index."""
    names = ("transition", "process_noise", "measurement", "measurement_noise")
    frozen = tuple((name, tuple(tuple(row) for row in model[name])) for name in names)
    return Subject("tracking_index", lambda point: _steady(frozen, point), roots or {}, free or {})


def memory_subject(degree: int, free: Values | None = None) -> Subject:
    """Symbols of a least-squares fit as functions of the sample number."""

    def quantities(point: Fraction) -> Values:
        if point.denominator != 1 or point < degree:
            raise NoValue("no fit")
        k = int(point)
        covariance = least_squares.covariance(degree, k)
        values: dict[str, Any] = {"k": _real(point)}
        for name, gain in zip(
            ("alpha", "beta", "gamma"), least_squares.gains(degree, k), strict=False
        ):
            values[name] = _real(Fraction(gain))
        for i, row in enumerate(covariance):
            for j, entry in enumerate(row):
                values[f"updated_{i + 1}{j + 1}"] = _real(Fraction(entry))
        return values

    return Subject("k", quantities, {}, free or {})
