"""How many real solutions an equation between rational functions has, for all its parameters.

Where no leading coefficient, discriminant, resultant with a divisor or value at an end of the
interval is zero, solutions are simple roots that stay apart from each other, from zeros of divisors
and from the ends, and do not run off to infinity: their number is the same on each connected set of
parameters. It is counted exactly at a point of each, and with one parameter also at all places
where one of these polynomials is zero.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations
from typing import Any

import flint

from gainproof.verify.judge.cells.lifting import cells
from gainproof.verify.judge.cells.parameter_polynomials import (
    irreducible,
    leading,
    over,
    put_in,
    value_at,
)
from gainproof.verify.judge.cells.projection import discriminants, projected, resultants
from gainproof.verify.judge.claim.record import Claim, OwnField
from gainproof.verify.judge.exact.algebraic_numbers import (
    Algebraic,
    compare,
    rational_point,
    real_roots,
)
from gainproof.verify.judge.exact.box import Box, bounds_text
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.places import Place, places
from gainproof.verify.judge.exact.polynomial import (
    Poly,
    coefficients_in,
    degree,
    fraction,
    ring,
    terms,
    univariate,
)
from gainproof.verify.judge.exact.region_text import region_text
from gainproof.verify.judge.exact.root_count import Coefficients, Element, NumberField
from gainproof.verify.judge.exact.simple_points import at_ends, simple_points
from gainproof.verify.judge.exact.simplification import expression_of
from gainproof.verify.judge.exact.statement import (
    ALLOWED,
    STRICT,
    TURNED,
    Enclosure,
    Rel,
    Witness,
)
from gainproof.verify.judge.exact.total_expressions import divisors
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Nowhere, Undecided
from gainproof.verify.judge.fixed_gain.rational_system import numerator_and_denominator
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.claim_domain import Frame, fixed_numbers, framed
from gainproof.verify.judge.kinds.identity import resolved
from gainproof.verify.judge.kinds.kind import EQUATION, Kind, OwnFields, one_symbol
from gainproof.verify.judge.meaning.evaluation import number_of
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.verdict import Finding
from gainproof.verify.judge.verdict_words import NOT_COMPARED

METHOD = "solutions counted in each cell of the parameters by Sturm's theorem"
MOST_SOLUTIONS = 64
NO_NUMBER = rational_point(Fraction(0))
"""Of which nothing is asked where all coefficients are rational."""
Point = tuple[Fraction, ...]


def _number(claim: OwnFields, name: str) -> OwnField:
    count = claim.fields.whole_number(name, 0, MOST_SOLUTIONS)
    if count is None:
        raise claim.fields.fail(name, "this field is missing: how many real solutions")
    return OwnField(number=count)


def judge_solutions(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether the equation has as many real solutions as the claim says, wherever the conditions
    without the unknown hold; those with it say which solutions count.
    """
    token, count = claim.own["variable"].symbol, claim.own["number"].number
    unknown = number_of(scope.symbol(token))
    relations = resolved(reading.relations, scope)
    if unknown.kind != "symbol" or len(relations) != 1:
        raise Undecided("wanted: one equation, and an unknown that is a free symbol")
    frame = framed(claim, scope, resolved(reading.conditions, scope))
    equation = _equation(relations[0], unknown.name, frame, scope.needed)
    search = _Search(equation, count, frame, unknown.name)
    found = search.along() if len(equation.names) < 2 else search.in_cells()
    many = "satisfy it" if count > 1 else "satisfies it"
    how = f"exactly {count}" if count else "no"
    where = f" with {', '.join(words)}" if (words := search.within()) else ""
    reading_told = f"{how} real {token}{where} {many}"
    return replace(found, reading=reading_told)


@dataclass(frozen=True)
class Bound:
    """An end of the interval: numerator and denominator in the parameters."""

    top: Poly
    bottom: Poly
    is_open: bool
    is_lower: bool


@dataclass(frozen=True)
class Interval:
    """Where solutions count at a point of the parameters; ends that are None are infinite."""

    low: Element | None = None
    high: Element | None = None
    low_open: bool = True
    high_open: bool = True

    def within(self, field: NumberField, end: Element, bound: Bound) -> Interval:
        """The part on the side of one more end."""
        known, is_open = (
            (self.low, self.low_open) if bound.is_lower else (self.high, self.high_open)
        )
        inward = 1 if bound.is_lower else -1
        further = 1 if known is None else field.sign(end - known) * inward
        if further < 0:
            return self
        is_open = bound.is_open or (further == 0 and is_open)
        if bound.is_lower:
            return replace(self, low=end, low_open=is_open)
        return replace(self, high=end, high_open=is_open)


@dataclass(frozen=True)
class Equation:
    """f = 0 where none of `divisors` is zero and the unknown is within `bounds`; polynomials hold
    the parameters `names` and then the unknown. `conditions` are on the parameters, and others
    are `fixed` to a number.
    """

    names: tuple[str, ...]
    boxes: Mapping[str, Box]
    f: Poly
    divisors: tuple[Poly, ...]
    bounds: tuple[Bound, ...]
    conditions: tuple[tuple[str, Poly], ...]
    fixed: tuple[str, ...] = ()

    def count(self, point: Point, at: Algebraic = NO_NUMBER) -> int | None:
        """The solutions at a rational point of the parameters, or at an algebraic value of the one
        parameter; None where there is no end of them.
        """
        field = NumberField(at)
        known = self._simple(field, point)
        if not isinstance(known, tuple):
            return known
        (interval, simple), (low, high) = known, (known[0].low, known[0].high)
        found = field.roots_up_to(simple, low, high)
        if high is not None and interval.high_open and not field.value(simple, high):
            found -= 1
        if low is not None and not interval.low_open and not field.value(simple, low):
            found += 1
        return found

    def near(self, point: Point) -> list[Algebraic]:
        """The solutions at a rational point, in order, each in an interval of its own."""
        known = self._simple(NumberField(NO_NUMBER), point)
        if not isinstance(known, tuple):
            return []
        interval, simple = known
        ends = (interval.low, interval.high)
        low, high = (None if end is None else fraction(end[0]) for end in ends)
        factors = flint.fmpq_poly([c[0] for c in simple]).numer().factor()[1]
        inside = [
            root.refined(Fraction(1, 10**8))
            for factor, _ in factors
            for root in real_roots(factor)
            if (low is None or compare(root, low) >= interval.low_open)
            and (high is None or compare(root, high) <= -interval.high_open)
        ]
        return sorted(inside, key=lambda root: root.low)

    def _simple(
        self, field: NumberField, point: Point
    ) -> tuple[Interval, Coefficients] | int | None:
        """Where solutions count and a polynomial with simple roots, or how many there are where
        that is seen without.
        """
        f, *others = (self._at(field, p, point) for p in (self.f, *self.divisors))
        if not all(others):
            return 0  # a divisor that is zero whatever the unknown is leaves none
        interval, size = self._interval(field, point)
        if size < 0:
            return 0
        if f:
            return interval, field.simple(f, others)
        if size or interval.low is None:
            return None
        return int(all(field.value(d, interval.low) for d in others))

    def holds(self, point: Point, at: Algebraic = NO_NUMBER) -> bool:
        """Whether the conditions on the parameters hold there."""
        field = NumberField(at)
        values = [(op, self._number(field, p, point)) for op, p in self.conditions]
        return all(field.sign(value) in ALLOWED[operator] for operator, value in values)

    def walls(self) -> list[Poly]:
        """Irreducible polynomials of the parameters, at whose zeros alone the number can change.
        Raises Undecided.
        """
        x, f = len(self.names), self.f
        found = [_content(p, x) for p in (f, *self.divisors)]
        if not f.is_zero():
            f = _over(f, f.gcd(f.derivative(f.context().names()[x])))
        for d in self.divisors if not f.is_zero() else ():
            f = _over(f, f.gcd(d))
        for d in self.divisors:
            if degree(f, x) > 0 and degree(d, x) > 0:
                found += resultants([f, d], x, DEFAULT_LIMITS)
        if degree(f, x) > 0:
            found += [leading(f, x), *discriminants([f], x, DEFAULT_LIMITS)]
        parts = coefficients_in(f, x)
        # an interval of one point may be where a divisor is zero: of an identity that matters
        of_ends = [parts, *(coefficients_in(d, x) for d in self.divisors if f.is_zero())]
        for b in self.bounds:
            for p in of_ends:
                powers = (c * b.top**k * b.bottom ** (len(p) - 1 - k) for k, c in enumerate(p))
                found.append(sum(powers, 0 * f))
            found.append(b.bottom)
        found += [a.top * b.bottom - b.top * a.bottom for a, b in combinations(self.bounds, 2)]
        return irreducible(found)

    def _interval(self, field: NumberField, point: Point) -> tuple[Interval, int]:
        """Where solutions count, and whether that is more than a number (1), one (0) or none."""
        interval = Interval()
        for bound in self.bounds:
            bottom = self._number(field, bound.bottom, point)
            if not bottom:
                raise Undecided("an end of the interval without a value is not excluded")
            end = field.quotient(self._number(field, bound.top, point), bottom)
            interval = interval.within(field, end, bound)
        if interval.low is None or interval.high is None:
            return interval, 1
        size = field.sign(interval.high - interval.low)
        return interval, -1 if size == 0 and (interval.low_open or interval.high_open) else size

    def _number(self, field: NumberField, p: Poly, point: Point) -> Element:
        """The value of a polynomial without the unknown."""
        found = self._at(field, p, point)
        return found[0] if found else flint.fmpq_poly([0])

    def _at(self, field: NumberField, p: Poly, point: Point) -> Coefficients:
        """Coefficients in the unknown at a point."""
        for name, value in zip(self.names, point, strict=False):
            p = put_in(p, name, value)
        found = []
        for part in coefficients_in(p, len(self.names)):
            powers = {exponents[0]: c for exponents, c in terms(part)}  # of the one parameter left
            dense = [powers.get(k, 0) for k in range(max(powers, default=0) + 1)]
            found.append(flint.fmpq_poly(dense))
        return field.polynomial(found)


def _over(p: Poly, by: Poly) -> Poly:
    found, rest = divmod(p, by)
    assert rest.is_zero()
    return found


def _content(p: Poly, x: int) -> Poly:
    """What all coefficients in the unknown have in common: where it is zero, all are."""
    found = 0 * p
    for part in coefficients_in(p, x):
        found = part.gcd(found)
    return found


def _equation(rel: Rel, unknown: str, frame: Frame, needed: Iterable[Expr]) -> Equation:
    fixed = _fixed(frame, unknown)
    sides = [substituted(side, fixed) for side in (rel.left, rel.right, *needed)]
    others = [
        Rel(c.operator, substituted(c.left, fixed), substituted(c.right, fixed))
        for c in frame.conditions
    ]
    others = [c for c in others if not _is_met(c)]
    used = symbols_of(*sides, *(s for c in others for s in (c.left, c.right)))
    names = tuple(sorted(used - {unknown}))
    boxes = {name: frame.boxes.get(name, Box(stated=False)) for name in (*names, unknown)}
    if any(box.integer for box in boxes.values()):
        raise Undecided("solutions of an equation with whole numbers are not counted")

    def quotient(expr: Expr) -> tuple[Poly, Poly]:
        try:
            return numerator_and_denominator(expr, (*names, unknown))
        except Undecided as why:
            raise Undecided("solutions are counted of rational functions only") from why

    box, x = boxes[unknown], unknown
    ends = [(box.lower, box.lower_open, True), (box.upper, box.upper_open, False)]
    bounds = [Bound(*quotient(number(v)), o, side) for v, o, side in ends if v is not None]
    conditions = []
    for said in others:
        left, right, operator = said.left, said.right, said.operator
        if x not in symbols_of(left, right):
            top, bottom = quotient(left - right)
            conditions.append((operator, top * bottom))
            # where a divisor is zero the condition says nothing, so it does not hold
            conditions += [("!=", quotient(d)[0]) for d in divisors(left, right)]
            continue
        if right.kind == "symbol" and right.name == x:
            left, right, operator = right, left, TURNED.get(operator, "")
        if left.kind != "symbol" or x in symbols_of(right) or operator not in TURNED:
            raise Undecided("a condition on the unknown that is no bound of it")
        bounds.append(Bound(*quotient(right), operator in STRICT, operator in (">", ">=")))
        sides.append(right)  # where it has no value no solution counts
    below = tuple(quotient(d)[0] for d in divisors(*sides))
    f, _ = quotient(sides[0] - sides[1])
    return Equation(names, boxes, f, below, tuple(bounds), tuple(conditions), (*fixed,))


def _fixed(frame: Frame, unknown: str) -> dict[str, Expr]:
    """Parameters that have one value. Raises Nowhere where that is not in their domain."""
    points = {n: box.lower for n, box in frame.boxes.items() if box.lower == box.upper}
    found = {
        **fixed_numbers(frame.conditions),
        **{n: value for n, value in points.items() if value is not None},
    }
    fixed = {n: value for n, value in found.items() if n != unknown}
    if not all(frame.boxes[n].holds(value) for n, value in fixed.items() if n in frame.boxes):
        raise Nowhere
    return {n: number(value) for n, value in fixed.items()}


def _is_met(condition: Rel) -> bool:
    """Whether a condition compares two numbers as it says. Raises Nowhere where it does not."""
    left, right = constant_value(condition.left), constant_value(condition.right)
    if left is None or right is None:
        return False
    if (left > right) - (left < right) not in ALLOWED[condition.operator]:
        raise Nowhere
    return True


@dataclass(frozen=True)
class _Search:
    equation: Equation
    wanted: int
    frame: Frame
    unknown: str

    def along(self) -> Finding:
        """With one parameter or none: every place is counted. Raises Undecided."""
        equation, name = self.equation, next(iter(self.equation.names), "")
        walls = [*equation.walls(), *irreducible(p for _, p in equation.conditions)]
        factors = [univariate(p, 0) for p in walls]
        kept: list[Place] = []
        wrong: list[tuple[Place, Point, int | None]] = []
        seen: list[tuple[str, str]] = []
        for place in places(factors, equation.boxes[name]) if name else [Place()]:
            at, point = _where(place)
            if equation.holds(point, at):
                count = equation.count(point, at)
                seen.append((place.text(self._label(name)), _told(count)))
                if count == self.wanted:
                    kept.append(place)
                else:
                    wrong.append((place, point, count))
        if not seen:
            raise Nowhere
        certificate = self._certificate(walls, seen)
        if not wrong:
            reason = "counted at every place where the number can change"
            return Finding("proved", reason, self._domain(), METHOD, None, certificate)
        place, point, count = min(wrong, key=lambda each: each[0].at is not None)
        value = str(point[0]) if point else place.at.text() if place.at else ""
        witness = self._witness({name: value} if name else {}, point, count, place)
        reason = f"fails {witness.text()}"
        if not kept:
            return Finding("refuted", reason, "nowhere", METHOD, witness, certificate)
        holds = f"for {region_text(kept, self._label(name))}"
        is_part = any(place.is_cell for place in kept)
        verdict, word = ("conditional", "exactly") if is_part else ("refuted", "only")
        reason += f"; holds {word} {holds}"
        return Finding(verdict, reason, holds, METHOD, witness, certificate)

    def in_cells(self) -> Finding:
        """With several parameters: a point of each open cell, and that no wall is met. Raises
        Undecided.
        """
        equation, names = self.equation, self.equation.names
        boxes, own = [equation.boxes[name] for name in names], ring(names)
        walls = equation.walls()
        cuts = irreducible([*walls, *(p for _, p in equation.conditions)])
        flat = [over(own, p) for p in cuts]
        levels = projected(flat, boxes, DEFAULT_LIMITS).levels
        found = [cell.samples[0] for cell in cells(levels, boxes, DEFAULT_LIMITS)]
        inside = [point for point in found if equation.holds(point)]
        for point in (*inside, *filter(equation.holds, self._further(flat))):
            count = equation.count(point)
            if count != self.wanted:
                values = dict(zip(names, map(str, point), strict=True))
                witness = self._witness(values, point, count)
                reason = f"fails {witness.text()}; where it may hold is not determined"
                certificate = self._certificate(cuts, [])
                return Finding("refuted", reason, "", METHOD, witness, certificate)
        if any(operator == "=" for operator, _ in equation.conditions):
            raise Undecided("an equation between several parameters")
        if not inside and all(operator in STRICT for operator, _ in equation.conditions):
            raise Nowhere
        if not inside or not self._is_joined():
            raise Undecided("conditions on several parameters that are not strict")
        for wall in walls:
            plain = expression_of(wall, (*names, self.unknown))
            if not self._on_parameters().holds(Rel("!=", plain, number(0))):
                text = labelled(plain, self.frame.labels)
                raise Undecided(f"so many wherever {text} is not zero; there it was not decided")
        reason = "the number changes nowhere, and was counted in each cell"
        seen = [(self._place(point), _told(self.wanted)) for point in inside]
        certificate = self._certificate(cuts, seen)
        return Finding("proved", reason, self._domain(), METHOD, None, certificate)

    def _is_joined(self) -> bool:
        """Whether each connected part of the domain, which has a point inside, holds a cell: it is
        open in a convex set.
        """
        conditions = self.equation.conditions
        return all(op in STRICT or (op != "=" and p.total_degree() == 1) for op, p in conditions)

    def _further(self, walls: Sequence[Poly]) -> Iterator[Point]:
        """Simple points, and points of walls that are of first degree in a parameter."""
        names, boxes = self.equation.names, self.equation.boxes
        for point in (*simple_points([*names], boxes), *at_ends([*names], boxes)):
            here = tuple(point[name] for name in names)
            yield here
            for wall in walls:
                for i, name in enumerate(names):
                    if degree(wall, i) == 1:
                        low, high = (value_at(p, here) for p in coefficients_in(wall, i))
                        if high and boxes[name].holds(-low / high):
                            yield (*here[:i], -low / high, *here[i + 1 :])

    def _on_parameters(self) -> Frame:
        kept = [c for c in self.frame.conditions if self.unknown not in symbols_of(c.left, c.right)]
        return replace(self.frame, conditions=tuple(kept))

    def within(self) -> list[str]:
        """Which solutions count, in words."""
        words = bounds_text({self.unknown: self.equation.boxes[self.unknown]}, self.frame.labels)
        other = self._on_parameters().conditions
        return [*words, *self._words(c for c in self.frame.conditions if c not in other)]

    def _words(self, conditions: Iterable[Rel]) -> list[str]:
        labels = self.frame.labels
        return [
            f"{labelled(c.left, labels)} {c.operator} {labelled(c.right, labels)}"
            for c in conditions
        ]

    def _domain(self) -> str:
        """Where the parameters lie."""
        equation, labels = self.equation, self.frame.labels
        told = {
            n: b for n, b in self.frame.boxes.items() if n in (*equation.names, *equation.fixed)
        }
        words = bounds_text(told, labels)
        words += self._words(self._on_parameters().conditions)
        return f"for {', '.join(words)}" if words else "everywhere"

    def _label(self, name: str) -> str:
        return self.frame.labels.get(name, name)

    def _place(self, point: Point) -> str:
        pairs = zip(self.equation.names, point, strict=True)
        return ", ".join(f"{self._label(name)} = {value}" for name, value in pairs)

    def _certificate(
        self, walls: Iterable[Poly], seen: Iterable[tuple[str, str]]
    ) -> dict[str, Any]:
        """What changes the number, and what was counted where."""
        names = (*self.equation.names, self.unknown)
        texts = [labelled(expression_of(p, names), self.frame.labels) for p in walls]
        places_seen = [{"place": place, "found": found, "balls": []} for place, found in seen]
        return {"checked": "replayed", "candidates": texts, "places": places_seen}

    def _witness(
        self,
        values: Mapping[str, str],
        point: Point,
        count: int | None,
        place: Place | None = None,
    ) -> Witness:
        none = Enclosure("", "", NOT_COMPARED)
        exact = place is None or place.at is None or place.at.is_rational
        roots = self.equation.near(point) if exact else []
        shown = ", ".join(f"{float(root.low):.6g}" for root in roots)
        note = _told(count) + (f", near {shown}" if roots else "")
        where = {self._label(name): value for name, value in values.items()}
        return Witness(where, "=", none, none, note=note)


def _where(place: Place) -> tuple[Algebraic, Point]:
    """An algebraic number, or a rational point of a place."""
    if place.at is None:
        return NO_NUMBER, place.samples[:1]
    return (NO_NUMBER, (place.at.low,)) if place.at.is_rational else (place.at, ())


def _told(count: int | None) -> str:
    if count is None:
        return "every number is a solution"
    return (
        f"there {'is' if count == 1 else 'are'} {count or 'no'} real solution{'s' * (count != 1)}"
    )


SOLUTIONS = Kind(
    "solutions",
    "the equation has exactly so many different real solutions wherever the conditions without "
    "the unknown hold; those with it, `0 < x < 1` or `x < a`, say which solutions count. Both "
    "sides are rational functions; with several parameters the number must change nowhere on the "
    "domain, or a point is found where it is another",
    judge_solutions,
    own={"variable": one_symbol, "number": _number},
    own_words="`variable`: the unknown; `number` of solutions",
    operators=EQUATION,
    repaired=False,
)
