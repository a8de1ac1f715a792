"""The tower at one place: which expressions are defined there, which elements vanish, and their
signs.

Sound because on a connected open interval where no radicand and no denominator vanishes every
element is real-analytic, and analytic functions on such an interval form an integral domain: p q =
0 gives p = 0 or q = 0, and one ball that excludes zero says which. At a single algebraic point the
same holds for numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence, Set
from dataclasses import dataclass, field
from fractions import Fraction

import flint

from gainproof.verify.judge.exact.algebraic_numbers import Algebraic
from gainproof.verify.judge.exact.connected_sets import Connected, Sample
from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.norm_factors import cofactor, highest_root
from gainproof.verify.judge.exact.polynomial import (
    Ball,
    Poly,
    coefficients_in,
    degree,
    from_terms,
    grouped,
    rational,
)
from gainproof.verify.judge.exact.polynomial_balls import evaluate
from gainproof.verify.judge.exact.tower import Root, Tower
from gainproof.verify.judge.exact.work_limits import Undecided

FIRST_PRECISION = 64


@dataclass
class Local:
    """A tower at a place. `steps` records each ball that decided something.

    `ground_zero` says whether a polynomial of the parameters that is not the zero polynomial is
    zero there all the same, at a point of several parameters.
    """

    tower: Tower
    place: Connected
    ground_zero: Callable[[Poly], bool] | None = None
    steps: list[str] = field(default_factory=list)
    _zero_roots: set[int] = field(default_factory=set)
    _bad: dict[bytes, str] = field(default_factory=dict)
    _relation: Poly = None

    def __post_init__(self) -> None:
        index = self.tower.parameter_index
        if self.place.at is not None and index is not None:
            width = len(self.tower.names)
            entries = {
                tuple(power if i == index else 0 for i in range(width)): c
                for power, c in enumerate(self.place.at.coefficients)
                if c
            }
            relation = from_terms(self.tower.context, entries)
            self._relation = relation / relation.leading_coefficient()
        for check in self.tower.checks:
            if self._bad and self.undefined(check.node) is not None:
                continue
            if check.root is None:
                if self.vanishes(check.poly):
                    self._bad[check.node.key] = "a divisor is zero"
            elif check.root.index in self._zero_roots:
                continue
            else:
                self._judge_root(check.node, check.root)

    def _judge_root(self, node: Expr, root: Root) -> None:
        if self.vanishes(root.sign_poly):
            self._zero_roots.add(root.index)
        elif root.order == 2 and self.sign(root.sign_poly) < 0:
            self._bad[node.key] = "a square root of a negative number"

    def undefined(self, *exprs: Expr) -> str | None:
        """Why one of the expressions has no value here, or None."""
        if not self._bad:
            return None
        for node in walk(*exprs):
            if node.key in self._bad:
                return self._bad[node.key]
        return None

    def is_cause(self, node: Expr) -> bool:
        """Whether this part has no value here though its own parts have, as a quotient by zero."""
        return node.key in self._bad

    def reduce(self, p: Poly) -> Poly:
        """Remainder by the relations of the tower, of the place and of the roots that are zero
        here.
        """
        for index in self._zero_roots:
            if degree(p, index) > 0:
                p = coefficients_in(p, index)[0]
        p = self.tower.reduce(p)
        if self._relation is not None and degree(p, self._index) > 0:
            p = divmod(p, self._relation)[1]
        return p

    @property
    def _index(self) -> int:
        index = self.tower.parameter_index
        assert index is not None
        return index

    def vanishes(self, p: Poly) -> bool:
        """Whether p is zero on the whole place, for all values of the free symbols. Raises
        Undecided.
        """
        return all(
            self._zero(part) for part in grouped(self.reduce(p), self.tower.free_indices).values()
        )

    def _zero(self, p: Poly) -> bool:
        p = self.reduce(p)
        if p.is_zero():
            return True
        root = highest_root(self.tower, p)
        if root is None:
            return self.ground_zero is not None and self.ground_zero(p)
        q = cofactor(self.tower, p, root)
        if not self._zero(self.reduce(p * q)):
            return False
        early, late = self._precisions()[:2], self._precisions()[2:]
        found = self._which(p, q, early)
        if found is None:
            # where p and q both vanish, and the root does not, every coefficient vanishes
            if all(self._zero(c) for c in coefficients_in(p, root.index)):
                return True
            found = self._which(p, q, early, self.place.moved)
            found = self._which(p, q, late) if found is None else found
        if found is None:
            bits = self.tower.limits.precision
            raise Undecided(f"balls of {bits} bits cannot tell two branches apart")
        return found

    def _which(
        self,
        p: Poly,
        q: Poly,
        precisions: list[int],
        points: Sequence[Sample | None] | None = None,
    ) -> bool | None:
        """p q vanishes: whether p does, shown by a ball round q or p that excludes zero; None if
        neither does at these points, or at the samples.
        """
        for precision in precisions:
            for sample in self._points() if points is None else points:
                if self._excludes_zero(q, sample, precision):
                    where = self._at_text(sample)
                    self.steps.append(f"cofactor not zero at {where} ({precision} bits)")
                    return True
                if self._excludes_zero(p, sample, precision):
                    self.steps.append(f"not zero at {self._at_text(sample)} ({precision} bits)")
                    return False
        return None

    def sign(self, p: Poly, *, strict: bool = True) -> int:
        """Sign on the place of an element that is not identically zero and does not change its sign
        there.

        With free symbols all coefficients must have one sign, and the symbols be positive or stand
        in even powers. An even power can vanish: `strict` wants a term without such powers, else
        the sign only says that the element is nowhere of the other sign. Raises Undecided.
        """
        parts = grouped(self.reduce(p), self.tower.free_indices)
        signs = set()
        vanishes = True
        for exponents, part in parts.items():
            if self._zero(part):
                continue
            vanishes &= any(
                e and name not in self.tower.positive
                for name, e in zip(self.tower.free, exponents, strict=True)
            )
            for name, e in zip(self.tower.free, exponents, strict=True):
                if e % 2 and name not in self.tower.positive:
                    raise Undecided(f"a sign that depends on {name}")
            signs.add(self._ball_sign(part))
        if len(signs) != 1:
            raise Undecided("a sign that depends on several parameters")
        if strict and vanishes:
            raise Undecided("a sign that is lost where a parameter is zero")
        return signs.pop()

    def _ball_sign(self, p: Poly) -> int:
        for precision in self._precisions():
            for sample in self._points():
                ball = self.ball(p, sample, precision)
                if ball is not None and not ball.contains(0):
                    return 1 if ball > 0 else -1
        raise Undecided(f"balls of {self.tower.limits.precision} bits cannot tell a sign")

    def _precisions(self) -> list[int]:
        found = [FIRST_PRECISION]
        while found[-1] < self.tower.limits.precision:
            found.append(found[-1] * 2)
        return found

    def _points(self) -> tuple[Sample | None, ...]:
        return tuple(self.place.samples[:3]) or (None,)

    def _at_text(self, sample: Sample | None) -> str:
        if isinstance(sample, tuple):
            texts = (v.text() if isinstance(v, Algebraic) else str(v) for v in sample)
            return f"({', '.join(texts)})"
        if sample is not None:
            return f"{self.tower.parameter} = {sample}"
        return (
            "the point"
            if self.place.at is None
            else f"{self.tower.parameter} = {self.place.at.text()}"
        )

    def _excludes_zero(self, p: Poly, sample: Sample | None, precision: int) -> bool:
        ball = self.ball(p, sample, precision)
        return ball is not None and not ball.contains(0)

    def ball(
        self, p: Poly, sample: Sample | None, precision: int, free: tuple[Fraction, ...] = ()
    ) -> Ball | None:
        """A ball round p at a rational sample (None: at the point of the place); None if a root is
        not resolved.
        """
        with flint.ctx.workprec(precision):
            at = sample if sample is not None else self.place.at
            values = variable_balls(self.tower, self._zero_roots, at, precision, free)
            result = evaluate(p, values)
            return result if result.is_finite() else None


def variable_balls(
    tower: Tower,
    zero_roots: Set[int],
    at: Sample | Algebraic | None,
    precision: int,
    free: tuple[Fraction, ...],
) -> list[Ball | None]:
    """A ball round every variable, at the current working precision; None where the point does not
    say, or where a root is not resolved or has no value. Roots in `zero_roots` are zero.
    """
    values: list[Ball | None] = [None] * max(1, len(tower.names))
    for place, number in zip(tower.free_indices, free, strict=False):
        values[place] = flint.arb(rational(number))
    coordinates = at if isinstance(at, tuple) else () if at is None else (at,)
    for place, value in zip(tower.parameter_indices, coordinates, strict=False):
        values[place] = (
            value.ball(precision) if isinstance(value, Algebraic) else flint.arb(rational(value))
        )
    for root in tower.roots:
        if root.index in zero_roots:
            values[root.index] = flint.arb(0)
            continue
        top, bottom = evaluate(root.radicand.num, values), evaluate(root.radicand.den, values)
        ratio = top / bottom
        if root.order == 2 and ratio > 0:
            values[root.index] = bottom * ratio.sqrt()
        elif root.order == 3 and ratio > 0:
            values[root.index] = bottom * ratio.root(3)
        elif root.order == 3 and ratio < 0:
            values[root.index] = -bottom * (-ratio).root(3)
    return values
