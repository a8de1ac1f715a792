"""The search for the nearest true formulas: values first, then dimensions, then proof."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property

from gainproof.verify.judge.claim.record import Claim, OwnField, Setting
from gainproof.verify.judge.claim_decision import judge_claim
from gainproof.verify.judge.dimensions.formula import reading_fault
from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of, walk
from gainproof.verify.judge.exact.expression_graph import read_graph
from gainproof.verify.judge.exact.statement import ALLOWED
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.catalogue import kind_named
from gainproof.verify.judge.repair.edits import LARGE, PLAIN, SLIGHT
from gainproof.verify.judge.repair.empty_repairs import Empty
from gainproof.verify.judge.repair.equal_offers import same_equation
from gainproof.verify.judge.repair.exchanged_symbols import sample_numbers, table_of
from gainproof.verify.judge.repair.formula_values import Values, truth, values_at
from gainproof.verify.judge.repair.generic_points import generic_points
from gainproof.verify.judge.repair.printed_formula import MOST_NODES, Link, Printed, printed
from gainproof.verify.judge.repair.proof import Offer, is_of_use, is_proved, reread, with_formula
from gainproof.verify.judge.repair.rounded_numbers import rounded
from gainproof.verify.judge.repair.senseless_parts import is_more_senseless, lacks_more
from gainproof.verify.judge.repair.sharp_bounds import is_sharp, is_weaker
from gainproof.verify.judge.repair.single_changes import changes, changes_of_bound
from gainproof.verify.judge.repair.solved_changes import Context, closings
from gainproof.verify.judge.repair.tree_construction import places
from gainproof.verify.judge.repair.trivial_formulas import OffTheModel, sorted_key
from gainproof.verify.judge.repair.whole_formula import OF_SIDES, Change, Step
from gainproof.verify.judge.scope import Scope, UndefinedSymbol
from gainproof.verify.judge.setting.environment import Environment
from gainproof.verify.judge.verdict import Finding

POINTS = 5
FAR_POINTS = 80
LEAST_AGREED = 3
MOST_TRIED = 20_000
MOST_PROOFS = 30
MOST_OFFERED = 12
STAGES = (0, 1, 2)
STRICT_OR_NOT = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}
BOUNDS = tuple(Fraction(n) for n in ("2", "1", "4", "1/2", "3/2", "3"))


@dataclass
class Search:
    """One reading of one claim in one environment; `partly` says that it is true on a part of its
    domain, so that it has no slip but in signs, numbers and conditions; `own_scope` has a symbol
    more than the source.
    """

    claim: Claim
    reading: Reading
    setting: Setting
    environment: Environment
    others: Sequence[Claim]
    deadline: float
    partly: bool = False
    own_scope: Scope | None = None
    formula: Printed = field(init=False)
    scope: Scope = field(init=False)
    points: list[Values] = field(init=False, default_factory=list)
    tried: int = field(init=False, default=0)

    def __post_init__(self) -> None:
        self.formula, self.kind = printed(self.reading), kind_named(self.claim.kind)
        plain = Scope(self.setting, self.environment, held=self.claim.held)
        self.scope = plain if self.own_scope is None else self.own_scope
        self.table = table_of(self.setting, self.formula, self.others)
        self.numbers = sample_numbers(self.setting)
        self.said = parts_of_source(self.others, self.setting)
        self.by_values = self._by_values()
        if self.by_values:
            self._prepare()
        self.off = OffTheModel(self.scope, frozenset(symbols_of(*self.formula.sides)))
        self.empty = Empty(self.claim, self.formula, self.off)

    def _by_values(self) -> bool:
        plain = all(link.operator in ALLOWED for link in self.formula.links)
        return plain and self.kind.pointwise and self.formula.connective == "if"

    @property
    def is_equation(self) -> bool:
        """Whether the claim is made of equations that values can decide."""
        return self.by_values and all(link.operator == "=" for link in self.formula.links)

    def _prepare(self) -> None:
        for name in symbols_of(*self.formula.sides) | set(self.table.symbols):
            try:
                self.scope.symbol(name)
            except (Undecided, Malformed, UndefinedSymbol):
                continue
        points, put_in = generic_points(self.claim, self.reading.conditions, self.scope, POINTS)
        if not points:
            raise Undecided("no generic point of the domain was found")
        self.points = values_at(self.scope, points, put_in)

    @cached_property
    def far(self) -> list[Values]:
        """Points from near the ends of the domain to far out."""
        points, put_in = generic_points(
            self.claim, self.reading.conditions, self.scope, FAR_POINTS, far=True
        )
        return values_at(self.scope, points, put_in)

    def offers(self, stage: int) -> list[Offer]:
        """The proved formulas of the least weight at which there is one, best first: one edit
        away, with one thing solved for, two edits away.
        """
        if sum(len(side.parts) + 1 for side in self.formula.sides) > MOST_NODES:
            return []
        if stage == 0 and self.kind.rounded:
            # within the digits shown, other edits come out right by chance
            slight = changes(self.formula, self.table, self.numbers, SLIGHT)
            turned = [c for c in slight if all(s.what.startswith("sign of") for s in c.steps)]
            return self._first([*turned, *rounded(self.claim, self.formula, self.judged)])
        if stage == 0:
            if further := with_further_bound(self):
                return further
            is_bound = self.partly or self.claim.kind == "inequality"
            listed = changes_of_bound if is_bound else changes
            most = LARGE if self.is_equation and not self.partly else PLAIN
            edited = listed(self.formula, self.table, self.numbers, most)
            # only where the formula itself is right well inside its domain is its edge at fault
            inside = self.by_values and self.agrees(self.formula)
            narrowed = self._proved(list(changed_conditions(self.formula))) if inside else []
            found = [*self._first(edited), *narrowed]
            least = min((offer.change.weight for offer in found), default=0)
            return [offer for offer in found if offer.change.weight == least]
        if not self.is_equation or self.partly:
            return []
        return self._first(closings(self) if stage == 1 else two_changes(self))

    def near(self, stage: int) -> list[Change]:
        """The changes of the least weight with which an equation agrees at points, best first."""
        if not self.is_equation:
            return []
        if stage == 0:
            candidates = changes(self.formula, self.table, self.numbers)
        else:
            candidates = closings(self) if stage == 1 else two_changes(self)
        agreed = list(self._filtered(candidates))
        least = min((change.weight for change in agreed), default=0)
        found: list[Change] = []
        for change in sorted((c for c in agreed if c.weight == least), key=self._rank):
            if not any(same_equation(f.printed, change.printed, self.off) for f in found):
                found.append(change)
        return found[:MOST_OFFERED]

    def agrees(self, formula: Printed) -> bool:
        """Whether the formula is seen to hold at generic points and nowhere seen to fail."""
        agreed = 0
        for values in self.points:
            found = truth(values, formula)
            if found is False:
                return False
            agreed += found is True
        return agreed >= min(LEAST_AGREED, len(self.points))

    @property
    def is_late(self) -> bool:
        """Whether enough was tried, which should come first on any machine, or the time is over."""
        return self.tried > MOST_TRIED or time.process_time() > self.deadline

    def _first(self, candidates: Iterable[Change]) -> list[Offer]:
        """Proved candidates of the least weight."""
        kept: dict[int, list[Change]] = {}
        for change in self._filtered(candidates):
            kept.setdefault(change.weight, []).append(change)
        for weight in sorted(kept):
            offers = self._proved(sorted(kept[weight], key=self._rank))
            if offers:
                return offers
        return []

    def _filtered(self, candidates: Iterable[Change]) -> Iterator[Change]:
        for change in candidates:
            self.tried += 1
            if self.is_late:
                return
            holds = not self.by_values or self.agrees(change.printed)
            if not holds or is_more_senseless(change.printed, self.formula):
                continue
            whole = self.partly or self.kind.two_parts
            if not (whole and lacks_more(change.printed, self.formula)):
                yield change

    def _proved(self, ordered: Sequence[Change]) -> list[Offer]:
        found: list[Offer] = []
        for change in ordered[:MOST_PROOFS]:
            if self.is_late or len(found) == MOST_OFFERED:
                break
            if any(same_equation(o.change.printed, change.printed, self.off) for o in found):
                continue
            weaker = any(is_weaker(change.printed, o.change.printed, self.off) for o in found)
            if weaker and self.kind.strongest:
                continue
            offer = self._offer(change)
            if offer is not None and offer.formula.latex not in {o.formula.latex for o in found}:
                found.append(offer)
        return found

    def _offer(self, change: Change) -> Offer | None:
        formula = reread(change.printed, self.setting.symbols)
        if formula is None or reading_fault(formula.readings[0], self.setting) is not None:
            return None
        if self.empty.is_empty(printed(formula.readings[0])):
            return None
        if self.by_values and not is_sharp(self.formula, change.printed, self.far):
            return None
        if not is_of_use(with_formula(self.claim, formula), self.setting, self.environment):
            return None
        return Offer(formula, change, self.environment.name)

    def judged(self, formula: Printed) -> Finding | None:
        if (read := reread(formula, self.setting.symbols)) is None:
            return None
        return judge_claim(with_formula(self.claim, read), self.setting, self.environment)

    def _rank(self, change: Change) -> tuple[object, ...]:
        return rank(change, self.formula, self.said)


def changed_conditions(formula: Printed) -> Iterator[Change]:
    """The claim under conditions with one such slip undone."""
    if formula.connective != "if":
        return
    for n, link in enumerate(formula.conditions):
        operator = STRICT_OR_NOT.get(link.operator)
        if operator is None:
            continue
        conditions = (
            *formula.conditions[:n],
            replace(link, operator=operator),
            *formula.conditions[n + 1 :],
        )
        step = Step(f"the condition's sign {link.operator} that is {operator}")
        yield Change(replace(formula, conditions=conditions), SLIGHT, (step,))
        for side in (link.left, link.right):
            before = formula.sides[side]
            if before.kind != "number" or before.fraction.denominator != 1:
                continue
            for value in (before.fraction + 1, before.fraction - 1):
                if value >= 0:
                    after = number(value)
                    step = Step("a number in the condition", before, after)
                    yield Change(formula.with_side(side, after), PLAIN, (step,))


def two_changes(context: Context) -> Iterator[Change]:
    """Formulas two edits away, none of which puts something in or leaves it out."""
    yield from _on_both_sides(context)
    yield from _within(context)


def _on_both_sides(context: Context) -> Iterator[Change]:
    formula = context.formula
    if len(formula.links) != 1 or formula.links[0].operator != "=":
        return
    link = formula.links[0]
    left: dict[str, list[Change]] = {}
    right: dict[str, list[Change]] = {}
    for change in changes(formula, context.table, context.numbers, PLAIN):
        same_left = change.printed.sides[link.left] == formula.sides[link.left]
        same_right = change.printed.sides[link.right] == formula.sides[link.right]
        if context.is_late:
            return
        if same_right and not same_left:
            left.setdefault(_value(context, change, link.left), []).append(change)
        elif same_left and not same_right:
            right.setdefault(_value(context, change, link.right), []).append(change)
    for value in left.keys() & right.keys() - {""}:
        for a in left[value]:
            for b in right[value]:
                both = a.printed.with_side(link.right, b.printed.sides[link.right])
                yield Change(both, a.weight + b.weight, (*a.steps, *b.steps))


def _value(context: Context, change: Change, side: int) -> str:
    """A side's value at the first point to eleven digits; empty if there is none."""
    ball = context.points[0].ball(change.printed.sides[side])
    return "" if ball is None or not ball.is_finite() else str(ball.str(11, radius=False))


def _within(context: Context) -> Iterator[Change]:
    for heaviest in (SLIGHT, PLAIN):
        for first in changes(context.formula, context.table, context.numbers, heaviest):
            if first.weight != heaviest:
                continue
            for second in changes(first.printed, context.table, context.numbers, PLAIN):
                if context.is_late:
                    return
                if second.weight >= first.weight:
                    weight = first.weight + second.weight
                    yield Change(second.printed, weight, (*first.steps, *second.steps))


def with_further_bound(search: Search) -> list[Offer]:
    """The claim with one bound more, if under the conditions it has the filter is stable exactly
    where this bound holds: then no weaker one would do. One offer at most.
    """
    claim = search.claim
    if (
        claim.kind != "stability"
        or claim.own["sense"].word != "sufficient"
        or search.formula.conditions
    ):
        return []
    said = (*claim.domain, *search.reading.relations)
    for bound in _bounds(search):
        formula = reread(bound, search.setting.symbols)
        if formula is None:
            continue
        own = {"sense": OwnField(word="exact")}
        exactly = replace(with_formula(claim, formula), own=own, domain=said)
        if judge_claim(exactly, search.setting, search.environment).verdict != "proved":
            continue
        found = _offered(search, bound)
        return [found] if found is not None else []
    return []


def _bounds(search: Search) -> Iterator[Printed]:
    region = search.environment.region
    labels = search.scope.labels()
    used = set().union(*[symbols_of(side) for side in search.formula.sides])
    for gain in () if region is None else region.gains:
        token = labels.get(gain, gain)
        if token in used or token not in search.setting.symbols:
            continue
        for operator in ("<", ">"):
            for value in BOUNDS:
                if search.is_late:
                    return
                yield Printed((symbol(token), number(value)), (Link(operator, 0, 1),))


def _offered(search: Search, bound: Printed) -> Offer | None:
    own = search.formula
    (link,) = bound.links
    place = len(own.sides)
    condition = replace(link, left=place, right=place + 1)
    both = Printed((*own.sides, *bound.sides), own.links, (condition,), own.connective)
    formula = reread(both, search.setting.symbols)
    if formula is None:
        return None
    if not is_proved(with_formula(search.claim, formula), search.setting, search.environment):
        return None
    step = Step("a condition is missing")
    return Offer(formula, Change(both, LARGE, (step,)), search.environment.name)


def parts_of_source(claims: Iterable[Claim], setting: Setting) -> frozenset[bytes]:
    """Keys of everything that other claims and definitions of the source print, single symbols
    apart.
    """
    found: set[bytes] = set()
    formulas = [claim.formula for claim in claims]
    formulas += [entry.definition for entry in setting.symbols.values()]
    for formula in formulas:
        for reading in () if formula is None else formula.readings:
            for relation in (*reading.relations, *reading.conditions):
                for side in (relation.left, relation.right):
                    try:
                        found |= _parts(read_graph(side))
                    except Malformed:
                        continue
    return frozenset(found)


def _parts(*sides: Expr) -> set[bytes]:
    return {sorted_key(node) for side in sides for node in walk(side) if node.parts}


def rank(change: Change, formula: Printed, said: frozenset[bytes]) -> tuple[object, ...]:
    """Fewest places changed, then on one side, then not in what a function is taken of, then what
    the source says elsewhere too, or the formula itself twice, then the same symbols, then the
    smallest part touched and the same left sides.
    """
    before, after = formula.sides, change.printed.sides
    sides = sum(a != b for a, b in zip(before, after, strict=True))
    gained = len((_parts(*after) - _parts(*before)) & said)
    gained += _repeated(after) - _repeated(before)
    other_names = len(symbols_of(*after) ^ symbols_of(*before))
    size = abs(_size(after) - _size(before))
    touched = sum(_size((node,)) for s in change.steps if (node := s.part or s.before))
    named = sum(before[n] != after[n] for n in {link.left for link in formula.links})
    inside = _arguments(after) - _arguments(before)
    led = sum(_begins_with_minus(argument) for argument in inside)
    # a sign or a missing factor is put where the left side stays what the formula is for
    sided = change.weight == LARGE or any(step.what in OF_SIDES for step in change.steps)
    last = (named, touched) if sided else (touched, named)
    stacked = _stacked(after) - _stacked(before)
    times = sum(step.times for step in change.steps)
    return (times, sides, len(inside), led, -gained, other_names, stacked, *last, size)


def _arguments(sides: tuple[Expr, ...]) -> set[Expr]:
    """What functions are taken of."""
    return {part for node in walk(*sides) if node.kind == "call" for part in node.parts}


def _begins_with_minus(expr: Expr) -> bool:
    return expr.kind == "neg" or (expr.kind == "add" and expr.parts[0].kind == "neg")


def _repeated(sides: tuple[Expr, ...]) -> int:
    """How many composed parts stand in more than one place."""
    times = Counter(sorted_key(node) for side in sides for _, node in places(side) if node.parts)
    return sum(count > 1 for count in times.values())


def _stacked(sides: tuple[Expr, ...]) -> int:
    """How many fractions stand under a fraction bar."""
    return sum(
        node.kind == "div" and any(part.kind == "div" for part in walk(node.parts[1]))
        for side in sides
        for node in walk(side)
    )


def _size(sides: tuple[Expr, ...]) -> int:
    return sum(1 for side in sides for _ in walk(side))
