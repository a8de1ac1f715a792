"""Derivatives where the rules of differentiation give no value: (y^2)^(3/4) has the slope 0 at 0,
where 3/2 y/(y^2)^(1/4) is 0/0, and |y| has none.

A statement is decided by the formal derivatives where these have values. At a place where one has
none the function itself is expanded, to the right and to the left: it has a slope there if both
expansions begin alike up to the first power, or if it has values on one side only. The statement is
then decided apart from the place, and at the place with the true slopes put in.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

from gainproof.verify.judge.exact.ball_text import value_shown
from gainproof.verify.judge.exact.balls import Balls
from gainproof.verify.judge.exact.box import Boxes
from gainproof.verify.judge.exact.calculus import (
    differentiated,
    rebuilt,
    roots_made_prime,
    substituted,
)
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    number,
    power,
    symbol,
    symbols_of,
    walk,
    whole_power,
)
from gainproof.verify.judge.exact.functions import has_jumps
from gainproof.verify.judge.exact.statement import (
    NOT_EVALUATED,
    STRICT,
    Enclosure,
    Outcome,
    Rel,
    Statement,
    Witness,
    unstated,
)
from gainproof.verify.judge.exact.total_expressions import divisors
from gainproof.verify.judge.exact.truth import NO_VALUE
from gainproof.verify.judge.exact.truth_survey import Work, survey
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Undecided
from gainproof.verify.judge.meaning.derivatives import VARIABLE, Slope
from gainproof.verify.judge.meaning.sums import powers_put_in
from gainproof.verify.judge.series.one_sided_slopes import slope_at, without_roots_of_zero
from gainproof.verify.judge.series.series import ProvingOracle
from gainproof.verify.judge.transcendental.free_values import where_valued
from gainproof.verify.judge.verdict_words import DECIDES, LACKS_VALUE

Decide = Callable[[Statement, Boxes], Outcome]
MOST_PLACES = 4
BITS = 128
NO_SLOPE = "there is no derivative"


def with_slopes(
    statement: Statement,
    slopes: tuple[Slope, ...],
    boxes: Boxes,
    decide: Decide,
    labels: Mapping[str, str],
) -> Outcome:
    """The verdict on a statement in which derivatives stand. Raises Undecided, also where neither a
    slope nor the lack of one is shown.
    """
    return _Derivatives(slopes, decide, labels).decided(statement, boxes, MOST_PLACES)


@dataclass(frozen=True)
class _Known(ProvingOracle):
    """What the domain says of coefficients: the oracle of expansions."""

    statement: Statement
    boxes: Boxes
    decide: Decide
    unknown = "a derivative that may exist for some values of the other symbols only"

    def holds(self, operator: str, coefficient: Expr) -> bool:
        rel = Rel(operator, coefficient, number(0))
        try:
            found = self.decide(Statement((rel,), self.statement.domain), self.boxes)
        except Undecided:
            return False
        return found.verdict == "proved"


def _anew(slope: Slope) -> Slope:
    """The same with the rules applied to what the function is now that symbols were put in."""
    function = without_roots_of_zero(powers_put_in(slope.function, {}))
    formal = substituted(differentiated(function, VARIABLE.name), {VARIABLE.name: slope.place})
    return Slope(function, slope.place, formal)


@dataclass(frozen=True)
class _Place:
    """Where an expression is zero, what is put in for symbols there, and its names of these."""

    zero: Expr
    put_in: Mapping[str, Expr]
    point: Mapping[str, str]

    @property
    def text(self) -> str:
        """Readable."""
        return ", ".join(f"{name} = {value}" for name, value in self.point.items())

    def within(self, statement: Statement) -> Statement:
        """The statement at this place alone."""
        kept = symbols_of(substituted(self.zero, self.put_in))
        given = (Rel("=", self.zero, number(0)),) if kept else ()
        whole = replace(statement, given=(*statement.given, *given))
        return whole.mapped(lambda e: powers_put_in(e, self.put_in))


@dataclass(frozen=True)
class _Derivatives:
    slopes: tuple[Slope, ...]
    decide: Decide
    labels: Mapping[str, str]

    def decided(self, statement: Statement, boxes: Boxes, places: int) -> Outcome:
        """The verdict, by the true slopes at so many places. Raises Undecided."""
        statement = self._at_numbers(statement, boxes)
        slopes = _standing(self.slopes, *statement.exprs())
        if not any(_may_lack(slope) for slope in slopes):
            return self.decide(statement, boxes)
        found = self._by_rules(statement, boxes)
        if isinstance(found, Outcome) and _needs_no_more(found, statement, slopes):
            return found
        point = self._lacking(statement, slopes, boxes)
        if isinstance(found, Undecided) and (point is None or not places):
            raise found
        if isinstance(found, Outcome) and point is None:
            return found
        assert point is not None
        if isinstance(found, Outcome) and found.verdict != "proved":
            lost = [s for s in slopes if self._is_lost(s, point, boxes)]
            if lost:
                return _without_slope(found, statement, lost, point)
        if not places:
            raise Undecided("a derivative whose rules give no value at too many places")
        reason = Undecided("a derivative at a place that is no symbol")
        for place in self._places(point, slopes):
            try:
                return self._split(statement, boxes, place, places)
            except Undecided as no:
                reason = no
        raise reason

    def _by_rules(self, statement: Statement, boxes: Boxes) -> Outcome | Undecided:
        try:
            return self.decide(statement, boxes)
        except Undecided as reason:
            return reason

    def _at_numbers(self, statement: Statement, boxes: Boxes) -> Statement:
        """The true slopes at places that are numbers, where their functions have roots. Raises
        Undecided for a point about which the function has no values.
        """
        put_in: dict[Expr, Expr] = {}
        needed: list[Expr] = []
        for slope in _standing(self.slopes, *statement.exprs()):
            below = walk(slope.function)
            roots = [n.fraction for n in below if n.kind == "pow" and n.fraction.denominator > 1]
            if symbols_of(slope.place) or not roots:
                continue
            try:
                found = slope_at(
                    slope.function,
                    VARIABLE.name,
                    slope.place,
                    _Known(statement, boxes, self.decide),
                )
            except Undecided:
                # the rules give 0 for a power above 1 of what is 0, with values beside it or not
                if max(roots) > 1 or _has_no_value(slope.formal, {}):
                    raise
                continue
            if found is not None:
                put_in[slope.formal] = found
                needed += self._functions_at(slope.place)
            elif not _has_no_value(slope.formal, {}):
                raise Undecided("a derivative at a place where the function has none")
        exact = statement.mapped(lambda e: _exchanged(e, put_in))
        return replace(exact, needed=tuple(dict.fromkeys((*exact.needed, *needed))))

    def _functions_at(self, place: Expr) -> list[Expr]:
        """What must have a value where there are derivatives: expansions know of no gaps."""
        formal = {s.formal for s in self.slopes}
        here = (s.function for s in self.slopes if s.place == place)
        functions = [substituted(f, {VARIABLE.name: place}) for f in here]
        return [f for f in dict.fromkeys(functions) if formal.isdisjoint(walk(f))]

    def _lacking(self, statement: Statement, slopes: list[Slope], boxes: Boxes) -> _Place | None:
        """A point of the domain where a formal derivative has no value and its function has one;
        None if there is none. Raises Undecided.
        """
        valued = dict.fromkeys(f for s in slopes for f in self._functions_at(s.place))
        apart = self._without_slopes(statement.domain)
        given = (*apart, *[Rel("=", f, f) for f in valued])
        asked = Statement(tuple(Rel("=", s.formal, s.formal) for s in slopes), given)
        stated = {name: replace(box, stated=True) for name, box in boxes.items()}
        found = self.decide(asked, stated)
        if found.verdict == "proved":
            return None
        shown = {} if found.witness is None else found.witness.point
        try:
            put_in = {n: number(shown[self.labels.get(n, n)]) for n in sorted(asked.symbols())}
        except ValueError:
            return self._algebraic(asked, stated, shown)
        except KeyError:
            raise Undecided("a derivative whose rules may give no value somewhere") from None
        away = [power(symbol(n) - value, 2) for n, value in put_in.items()]
        return _Place(add(*away) if away else number(0), put_in, shown)

    def _algebraic(self, asked: Statement, boxes: Boxes, shown: Mapping[str, str]) -> _Place:
        """The roots of one polynomial of the one symbol. Raises Undecided."""
        name, *others = asked.symbols()
        asked = asked.mapped(roots_made_prime)
        if not others and not any(n.kind == "call" for n in walk(*asked.exprs())):
            box = boxes.get(name, unstated())
            work = Work(asked, {name: box}, name, self.labels, DEFAULT_LIMITS)
            for each in survey(work):
                if each.truth == NO_VALUE and each.place.at is not None:
                    known = enumerate(each.place.at.coefficients)
                    terms = [number(c) * whole_power(symbol(name), k) for k, c in known]
                    return _Place(add(*terms), {}, shown)
        raise Undecided("a derivative whose rules give no value at a place that is no number")

    def _places(self, point: _Place, slopes: list[Slope]) -> Iterator[_Place]:
        """All values of the other symbols together, then the point alone."""
        values = {name: value.fraction for name, value in point.put_in.items()}
        here = [s.place for s in slopes if values and _has_no_value(s.formal, values)]
        own = [p.name for p in here if p.kind == "symbol" and p.name in values]
        for name in dict.fromkeys((*own, *values)):
            value = point.put_in[name]
            shown = {self.labels.get(name, name): str(value.fraction)}
            yield _Place(symbol(name) - value, {name: value}, shown)
        if len(values) != 1:
            yield point

    def _is_lost(self, slope: Slope, point: _Place, boxes: Boxes) -> bool:
        """Whether the function has no derivative at a point. Raises Undecided."""
        values = {name: value.fraction for name, value in point.put_in.items()}
        if not values:
            known = _Known(point.within(Statement(())), boxes, self.decide)
            return slope_at(slope.function, VARIABLE.name, slope.place, known) is None
        if not _has_no_value(slope.formal, values):
            return False
        function, place = (powers_put_in(e, point.put_in) for e in (slope.function, slope.place))
        if symbols_of(place) or not symbols_of(function) <= {VARIABLE.name}:
            raise Undecided("a derivative of what holds symbols without a value")
        return (
            slope_at(function, VARIABLE.name, place, _Known(Statement(()), {}, self.decide)) is None
        )

    def _split(self, statement: Statement, boxes: Boxes, place: _Place, places: int) -> Outcome:
        """The statement apart from a place, and there with the true slopes. Raises Undecided."""
        fixed = [boxes.get(name, unstated()) for name in place.put_in]
        single = all(box.lower == box.upper is not None for box in fixed)
        at = self._there(statement, boxes, place, places)
        if single and place.put_in and at is not None:
            return at
        given = (*statement.given, Rel("!=", place.zero, number(0)))
        apart = self.decided(replace(statement, given=given), boxes, places - 1)
        if at is None:
            return _told_apart(apart, place)
        if apart.verdict == "refuted":
            return apart
        if apart.verdict == "conditional":
            if at.verdict == "proved":
                return apart
            left_out = self._left_out(statement, boxes, place, at, places)
            domain = _but(apart.domain, statement, *left_out)
            # at the place it may hold here and there all the same
            reason = apart.reason.replace("holds exactly", "holds").replace(apart.domain, domain)
            return replace(apart, domain=domain, reason=reason)
        if at.verdict == "proved":
            # what is told of the one place and of all others, each with its own certificate
            whole = replace(
                apart,
                domain=self._domain(statement, boxes) or f"{apart.domain}, and {place.text}",
                method=f"{apart.method}; at {place.text} by the true derivative",
                # all that is kept is proved, also beside what is only held elsewhere
                certificate={
                    **_parts(apart, "elsewhere"),
                    **_parts(at, f"at {place.text}"),
                    DECIDES: "proved",
                },
            )
            return _where_valued(whole) if _Beside in map(type, (apart, at)) else whole
        if at.witness is None:
            return at
        witness = replace(at.witness, point={**place.point, **at.witness.point})
        if apart.verdict != "proved":
            reason = f"fails {witness.text()}; where it may hold is not determined"
            told = replace(at, verdict="refuted", domain="", certificate=_decided_as(at))
            return replace(told, reason=reason, witness=witness)
        left_out = self._left_out(statement, boxes, place, at, places)
        domain = _but(apart.domain, statement, *left_out)
        return replace(
            apart,
            verdict="conditional",
            domain=domain,
            reason=f"fails {witness.text()}; holds {domain}",
            witness=witness,
            certificate=_decided_as(apart),
        )

    def _left_out(
        self, statement: Statement, boxes: Boxes, place: _Place, at: Outcome, places: int
    ) -> tuple[_Place, ...]:
        """The place, and the point of it that was found where all else of it is kept."""
        point = {} if at.witness is None or at.verdict != "conditional" else at.witness.point
        names = sorted(statement.symbols() - set(place.put_in))
        labels = [self.labels.get(name, name) for name in names]
        if not names or not place.put_in or not set(labels) <= set(point):
            return (place,)
        shown = {label: point[label] for label in labels}
        try:
            put_in = {n: number(point[label]) for n, label in zip(names, labels, strict=True)}
            away = add(*[power(symbol(n) - value, 2) for n, value in put_in.items()])
            given = (*statement.given, Rel("!=", away, number(0)))
            rest = self._there(replace(statement, given=given), boxes, place, places)
        except (ValueError, Undecided):
            return (place,)
        if rest is None or rest.verdict != "proved":
            return (place,)
        return place, _Place(away, put_in, shown)

    def _there(
        self, statement: Statement, boxes: Boxes, place: _Place, places: int
    ) -> Outcome | None:
        """The verdict at a place; None if nothing is said there, since a condition has no value or
        no domain is stated. Raises Undecided.
        """
        names = symbols_of(place.zero)
        stated = any(boxes[n].stated for n in names if n in boxes)
        others = {
            n: replace(box, stated=box.stated or stated)
            for n, box in boxes.items()
            if n not in place.put_in
        }
        near = place.within(Statement((), self._without_slopes(statement.domain)))
        known = _Known(near, others, self.decide)
        true: dict[Expr, Expr] = {}
        kept: list[Slope] = []
        for each in _standing(self.slopes, *statement.exprs()):
            moved = each.put_in(place.put_in)
            if names.isdisjoint(symbols_of(each.place)):
                kept.append(_anew(moved))
                true[each.formal] = kept[-1].formal
                continue
            slope = slope_at(moved.function, VARIABLE.name, moved.place, known)
            if slope is None and (not stated or _holds(statement.domain, each)):
                return None
            true[each.formal] = number(1) / number(0) if slope is None else slope
        functions = (
            f for s in self.slopes if s.formal in true for f in self._functions_at(s.place)
        )
        exact = statement.mapped(lambda e: _exchanged(e, true))
        needed = tuple(dict.fromkeys((*exact.needed, *functions)))
        exact = place.within(replace(exact, needed=needed))
        slopes = [s.put_in(place.put_in) for s in self.slopes if s.formal not in true]
        inner = replace(self, slopes=(*slopes, *kept))
        return inner.decided(exact, others, places - 1)

    def _without_slopes(self, relations: tuple[Rel, ...]) -> tuple[Rel, ...]:
        return tuple(r for r in relations if not any(_holds((r,), s) for s in self.slopes))

    def _domain(self, statement: Statement, boxes: Boxes) -> str:
        """The whole domain in words; nothing where conditions speak of slopes."""
        apart = self._without_slopes(statement.domain)
        if apart != statement.domain:
            return ""
        zeros = {s.formal: number(0) for s in self.slopes}
        sides = [side for rel in statement.relations for side in (rel.left, rel.right)]
        same = tuple(Rel("=", e, e) for e in (_exchanged(side, zeros) for side in sides))
        needed = tuple(_exchanged(e, zeros) for e in statement.needed)
        try:
            found = self.decide(Statement(same, apart, "if", needed), boxes)
        except Undecided:
            return ""
        return found.domain if found.verdict == "proved" else ""


@dataclass(frozen=True)
class _Beside(Outcome):
    """Proved beside places of which nothing is said."""


def _where_valued(found: Outcome) -> Outcome:
    return replace(found, domain=where_valued(found.domain))


def _told_apart(apart: Outcome, place: _Place) -> Outcome:
    """What is proved beside a place of which nothing is said, with words for that where its domain
    does not speak of it.
    """
    if apart.verdict != "proved":
        return apart
    is_told = set(place.point) <= set(apart.domain.replace(",", " ").split())
    beside = _Beside(**vars(apart))
    return beside if is_told or not apart.domain else _where_valued(beside)


def _but(domain: str, statement: Statement, *places: _Place) -> str:
    """A domain in words without what is on all of these places, which conditions keep out of it. Of
    one symbol it tells places one by one; otherwise conditions are not repeated in it.
    """
    if len(statement.symbols()) < 2:
        return domain
    parts = [part for place in places for part in place.text.split(", ")]
    told = {f"{name} != {value}" for place in places for name, value in place.point.items()}
    if " or " not in domain and told & set(domain.removeprefix("for ").split(", ")):
        return domain  # one of the values is left out already
    if len(told) == 1 and " or " not in domain and domain != "everywhere":
        return f"{domain}, {told.pop()}"
    but = f"except where {' and '.join(parts)}"
    return f"everywhere {but}" if domain == "everywhere" else f"{domain}, {but}"


def _without_slope(
    found: Outcome, statement: Statement, lost: list[Slope], point: _Place
) -> Outcome:
    """The same verdict with a point at which the function has no derivative."""
    values = {name: value.fraction for name, value in point.put_in.items()}
    rels = statement.all_relations()
    rel = next((r for r in rels if any(_holds((r,), s) for s in lost)), rels[0])
    left, right = (
        Enclosure("", "", NO_SLOPE)
        if _standing(lost, side)
        else value_shown(side, Balls(values, BITS))
        for side in (rel.left, rel.right)
    )
    witness = Witness(point.point, rel.operator, left, right, note=LACKS_VALUE)
    old = None if found.witness is None else found.witness.text()
    reason = found.reason if old is None else found.reason.replace(old, witness.text())
    return replace(found, witness=witness, reason=reason)


def _needs_no_more(found: Outcome, statement: Statement, slopes: list[Slope]) -> bool:
    """Whether the verdict does not rest on a formal derivative that has no value."""
    if found.verdict in ("refuted", "conditional"):
        witness = found.witness
        return witness is not None and not (witness.left.undefined or witness.right.undefined)
    # where equations and weak orders hold next to a place, they hold there, unless something jumps
    strict = any(rel.operator in STRICT for rel in statement.relations)
    strict = strict or any(map(has_jumps, walk(*statement.exprs())))
    beside = any(_holds(statement.domain, s) for s in slopes)
    return found.verdict != "proved" or not (strict or statement.connective != "if" or beside)


def _may_lack(slope: Slope) -> bool:
    """Whether the rules divide by anything that the function itself does not ask to be nonzero, or
    lower an exponent that is a symbol.
    """
    function = substituted(slope.function, {VARIABLE.name: slope.place})
    if any(n.kind == "call" and n.name == "power" for n in walk(slope.formal)):
        return True
    return not _divisors(slope.formal) <= _divisors(function)


def _divisors(expr: Expr) -> set[Expr]:
    """The factors that must not be zero, at a glance; numbers are left out."""
    logarithms = (n.parts[0] for n in walk(expr) if n.kind == "call" and n.name == "log")
    angles = (n.parts for n in walk(expr) if n.kind == "call" and n.name == "atan2")
    points = (add(power(x, 2), power(y, 2)) for y, x in angles)
    pending = [*divisors(expr), *logarithms, *points]
    found = set()
    while pending:
        node = pending.pop()
        if node.kind in ("mul", "div", "neg", "pow") and node.value != 0:
            pending += node.parts
        elif constant_value(node) in (None, 0):
            found.add(node)
    return found


def _standing(slopes: Iterable[Slope], *exprs: Expr) -> list[Slope]:
    """The derivatives that stand in expressions."""
    nodes = set(walk(*exprs))
    return [s for s in dict.fromkeys(slopes) if s.formal in nodes and s.formal.kind != "number"]


def _holds(relations: Iterable[Rel], slope: Slope) -> bool:
    return bool(_standing([slope], *[e for r in relations for e in (r.left, r.right)]))


def _exchanged(expr: Expr, values: Mapping[Expr, Expr]) -> Expr:
    """Parts replaced, the outermost first."""
    return rebuilt(expr, lambda node, _: values.get(node)) if values else expr


def _has_no_value(expr: Expr, point: Mapping[str, Fraction]) -> bool:
    return value_shown(expr, Balls(point, BITS)).undefined not in (None, NOT_EVALUATED)


def _decided_as(found: Outcome) -> dict[str, object]:
    """The certificate of what is told as another verdict; it may be told so already."""
    return {DECIDES: found.verdict, **found.certificate}


def _parts(found: Outcome, title: str) -> dict[str, object]:
    """The certificates of an outcome by their titles."""
    own = found.certificate
    return {title: own} if "statement" in own or not own else dict(own)
