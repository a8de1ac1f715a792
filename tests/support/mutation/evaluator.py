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
from mutation.arithmetic import NoValue, plus, product, real, root, times
from mutation.three_states import of_three_states
from mutation.tree import Tree

DIGITS = 90

Values = Mapping[str, Any]
Point = Fraction


class UnknownName(LookupError):
    """A symbol of which the oracles say nothing: with it nothing can be said to be false."""


@dataclass
class Subject:
    """What symbols are worth at a point; `variable` is what derivatives and shifts are taken in,
    `short` are names for expressions.
    """

    variable: str
    quantities: Callable[[Fraction], Values]
    roots: Mapping[str, tuple[int, Tree]] = field(default_factory=dict)
    free: Mapping[str, Any] = field(default_factory=dict)
    short: Mapping[str, Tree] = field(default_factory=dict)

    def value(self, tree: Tree, point: Fraction) -> Any:
        """The number (or matrix, as rows) of a tree. Raises NoValue, UnknownName."""
        with mpmath.workdps(DIGITS):
            return self._value(tree, point)

    def _symbol(self, name: str, point: Fraction) -> Any:
        if name == self.variable:
            return real(point)
        if name in self.free:
            return self.free[name]
        if name in self.roots:
            order, radicand = self.roots[name]
            return root(self._value(radicand, point), Fraction(1, order))
        if name in self.short:
            return self._value(self.short[name], point)
        values = self.quantities(point)
        if name not in values:
            raise UnknownName(name)
        return values[name]

    def _value(self, tree: Tree, point: Fraction) -> Any:
        kind = tree[0]
        match kind:
            case "number":
                return real(tree[1])
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
                return root(self._value(tree[1], point), tree[2])
            case "neg":
                return times(-1, self._value(tree[1], point))
        parts = [self._value(part, point) for part in tree[1:]]
        if kind == "div":
            if isinstance(parts[1], list) or parts[1] == 0:
                raise NoValue("division by zero")
            return times(1 / parts[1], parts[0])
        total = parts[0]
        for part in parts[1:]:
            total = plus(total, part) if kind == "add" else product(total, part)
        return total

    def _difference(self, tree: Tree, name: str, point: Fraction) -> Any:
        step = point * Fraction(1, 10**25)
        high, low = self._value(tree, point + step), self._value(tree, point - step)
        top = self._symbol(name, point + step) - self._symbol(name, point - step)
        return times(1 / top, plus(high, times(-1, low)))


def _rational(x: Any) -> Fraction:
    """A multiprecision number that is a simple rational, as one."""
    return Fraction(str(mpmath.nstr(x, 60, strip_zeros=False))).limit_denominator(10**12)


@cache
def _steady(model: tuple[tuple[str, Any], ...], point: Fraction) -> Values:
    data = {name: [list(row) for row in rows] for name, rows in model}
    state = doubling.steady_state(state_space(data, point), DIGITS).state
    with mpmath.workdps(DIGITS):
        index = real(point)
        gain = [mpmath.mpf(row[0]) for row in state.gain]
        names = ("alpha", "beta", "gamma")
        values: dict[str, Any] = {"tracking_index": index, **dict(zip(names, gain, strict=False))}
        transition = data["transition"]
        forward = [
            sum(real(Fraction(f)) * g for f, g in zip(row, gain, strict=True)) for row in transition
        ]
        values["predictor_position"] = forward[0]
        values["rest"] = 1 - gain[0]
        values["innovation_variance"] = mpmath.mpf(state.innovation[0][0])
        values["innovation_deviation"] = mpmath.sqrt(values["innovation_variance"])
        for which, matrix in (("predicted", state.predicted), ("updated", state.updated)):
            for i, row in enumerate(matrix):
                for j, entry in enumerate(row):
                    values[f"{which}_{i + 1}{j + 1}"] = mpmath.mpf(entry)
        if len(gain) == 3:
            motion = [[real(Fraction(entry)) for entry in row] for row in transition]
            values |= of_three_states(motion, gain)
        return values


def steady_subject(
    model: Mapping[str, Any],
    roots: Mapping[str, tuple[int, Tree]] | None = None,
    free: Values | None = None,
    short: Mapping[str, Tree] | None = None,
) -> Subject:
    """Symbols of a steady state as functions of the tracking index."""
    names = ("transition", "process_noise", "measurement", "measurement_noise")
    frozen = tuple((name, tuple(tuple(row) for row in model[name])) for name in names)
    return Subject(
        "tracking_index", lambda point: _steady(frozen, point), roots or {}, free or {}, short or {}
    )


def memory_subject(degree: int, free: Values | None = None) -> Subject:
    """Symbols of a least-squares fit as functions of the sample number."""

    def quantities(point: Fraction) -> Values:
        if point.denominator != 1 or point < degree:
            raise NoValue("no fit")
        k = int(point)
        covariance = least_squares.covariance(degree, k)
        values: dict[str, Any] = {"k": real(point)}
        for name, gain in zip(
            ("alpha", "beta", "gamma"), least_squares.gains(degree, k), strict=False
        ):
            values[name] = real(Fraction(gain))
        for i, row in enumerate(covariance):
            for j, entry in enumerate(row):
                values[f"updated_{i + 1}{j + 1}"] = real(Fraction(entry))
        return values

    return Subject("k", quantities, {}, free or {})
