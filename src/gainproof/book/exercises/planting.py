"""A derivation with one error planted in it: refuted, while every other line stays proved."""

from __future__ import annotations

import functools
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from random import Random
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.book.exercises.refutation import Witness, agree, refuted
from gainproof.book.exercises.tower_values import TowerValues, tower_values
from gainproof.formulas.formula_latex import formula_latex, indexed
from gainproof.formulas.relation_text import Writer, relation_lines
from gainproof.pages.lecture_items import Item, items
from gainproof.subjects.derived import Derived, DerivedStep
from gainproof.verify.certificate import check_statement
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, mul, neg, number, power, symbol, walk
from gainproof.verify.judge.exact.formula_tree import read_tree
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided

FIELDS: Mapping[str, tuple[str, ...]] = {
    "equal": ("left", "right"),
    "positive": ("expression",),
    "limit": ("value",),
    "sum": ("summand", "closed"),
}
"""Where an error is planted, by the kind of the relation; trends are turned round as well."""
LEAST_LINES = 12
_TRENDS = {"increasing": "decreasing", "decreasing": "increasing"}
_SAID = re.compile(r"`[^`]*(=|->|<|>)[^`]*`")
"""A relation in a sentence: the line's own formula is often repeated there, as it should be."""
_TRIES_OF_A_SLIP = 6


@dataclass(frozen=True)
class Planted:
    """`derived`: the subject with the error in the step `id`, whose number on the page is `line`;
    `before`: that step as it was. The sheet shows the lines from `first` to `last`.
    """

    number: int
    seed: int
    derived: Derived
    id: str
    line: int
    slip: str
    witness: Witness
    before: DerivedStep
    first: int
    last: int

    @property
    def step(self) -> DerivedStep:
        """The step with the error."""
        return next(step for step in self.derived.steps if step.id == self.id)


def plant(subjects: Sequence[Derived], count: int, seed: int) -> list[Planted]:
    """So many sheets, the same for the same seed and subjects. Raises BadInputError where no error
    can be planted in any of the subjects.
    """
    order = sorted(subjects, key=lambda subject: subject.name)
    Random(f"order of sheets {seed}").shuffle(order)
    found: list[Planted] = []
    for sheet_number in range(1, count + 1):
        chooser = Random(f"sheet {seed} {sheet_number}")
        start = (sheet_number - 1) % max(len(order), 1)
        tried = (
            _planted(each, sheet_number, seed, chooser) for each in order[start:] + order[:start]
        )
        sheet = next((sheet for sheet in tried if sheet is not None), None)
        if sheet is None:
            raise BadInputError("none of the derivations has a step in which an error is refuted")
        found.append(sheet)
    return found


def _planted(subject: Derived, number: int, seed: int, chooser: Random) -> Planted | None:
    """The first error that is refuted at a point and rejected by the checker."""
    lines = items(subject.steps)
    line_of = {step.id: line for line in lines for step in line.steps}
    towers: dict[str, TowerValues | None] = {}
    candidates = _candidates(subject, line_of)
    chooser.shuffle(candidates)
    for step in candidates:
        tower = _tower(subject, step.tower, towers)
        if tower is None or not agree(step.kind, step.claim, tower):
            continue
        for slip, claim in _slips(step, subject, chooser):
            witness = refuted(step.kind, claim, tower, step.claim)
            if witness is None or not _reads_otherwise(step, claim, subject):
                continue
            spoiled = with_claim(subject, step.id, claim)
            if check_statement(spoiled.certificate, step.id).status != "rejected":
                # a point at which it is false, and a proof of it: one of the two is wrong
                raise ArithmeticError(f"{subject.name}, {step.id}: false and accepted")
            first, last = _excerpt(lines, line_of[step.id].number, chooser)
            line = line_of[step.id].number
            return Planted(number, seed, spoiled, step.id, line, slip, witness, step, first, last)
    return None


def _candidates(subject: Derived, line_of: Mapping[str, Item]) -> list[DerivedStep]:
    """Steps that can be spoiled and whose truth no sentence beside them repeats."""
    shown = [step for step in subject.steps if step.id in line_of]
    claims = [step.claim for step in shown]
    return [
        step
        for step in shown
        if (step.kind in FIELDS or step.kind == "monotone")
        and not _SAID.search(f"{line_of[step.id].first.sentence} {line_of[step.id].first.reason}")
        and claims.count(step.claim) == 1
    ]


def _tower(subject: Derived, name: str, known: dict[str, TowerValues | None]) -> TowerValues | None:
    if name not in known:
        try:
            known[name] = tower_values(subject.certificate["towers"][name])
        except (Undecided, Malformed):
            known[name] = None
    return known[name]


def _slips(
    step: DerivedStep, subject: Derived, chooser: Random
) -> Iterator[tuple[str, dict[str, Any]]]:
    """Claims with a slip, some of each kind of slip, in the chooser's order."""
    if step.kind == "monotone":
        yield "a trend turned round", {**step.claim, "trend": _TRENDS[step.claim["trend"]]}
        return
    tower = subject.certificate["towers"][step.tower]
    names = [*(p["symbol"] for p in tower["parameters"]), *sorted(tower["elements"])]
    by_slip: dict[str, list[dict[str, Any]]] = {}
    for field in FIELDS[step.kind]:
        if isinstance(step.claim[field], str):
            continue
        for mutant in _mutants(read_tree(step.claim[field]), names):
            spoiled = {**step.claim, field: graph_of(mutant.formula)}
            by_slip.setdefault(mutant.slip, []).append(spoiled)
    slips = sorted(by_slip)
    chooser.shuffle(slips)
    for slip in slips:
        chosen = by_slip[slip]
        for claim in chooser.sample(chosen, min(_TRIES_OF_A_SLIP, len(chosen))):
            yield slip, claim


def _reads_otherwise(step: DerivedStep, claim: Mapping[str, Any], subject: Derived) -> bool:
    """Whether a reader sees another formula."""
    writer = Writer(subject.symbols, functools.partial(formula_latex, at=indexed))
    return relation_lines(step.kind, claim, writer) != relation_lines(step.kind, step.claim, writer)


def with_claim(subject: Derived, id: str, claim: dict[str, Any]) -> Derived:  # noqa: A002
    """The subject with another claim in one step: in its steps, its certificate, and what is
    expected of that.
    """

    def put(record: Any) -> Any:
        return {**record, "claim": claim} if record["id"] == id else record

    statements = [put(statement) for statement in subject.certificate["statements"]]
    return replace(
        subject,
        steps=tuple(replace(s, claim=claim) if s.id == id else s for s in subject.steps),
        claims=tuple(put(record) for record in subject.claims),
        certificate={**subject.certificate, "statements": statements},
    )


def parts(lines: Sequence[Item]) -> list[tuple[int, int]]:
    """First and last line of each part of a page."""
    opened = [line.number for line in lines if line.first.heading] or [1]
    starts = sorted({lines[0].number, *opened})
    return list(zip(starts, [*(s - 1 for s in starts[1:]), lines[-1].number], strict=True))


def _excerpt(lines: Sequence[Item], line: int, chooser: Random) -> tuple[int, int]:
    """Whole parts round a line, at least two of them and `LEAST_LINES`, if the page has them."""
    found = parts(lines)
    low = high = next(k for k, (start, end) in enumerate(found) if start <= line <= end)
    while (low, high) != (0, len(found) - 1):
        first, last = found[low][0], found[high][1]
        if low < high and last - first + 1 >= LEAST_LINES:
            break
        downwards = low > 0 and (high == len(found) - 1 or chooser.random() < 0.5)
        low, high = (low - 1, high) if downwards else (low, high + 1)
    return found[low][0], found[high][1]


_LONGEST = 40
"""Parts of a formula that are tried: a slip in a longer one is found by nobody."""


@dataclass(frozen=True)
class _Mutant:
    """A formula with a slip: its kind in words, and what it was done to, for the key."""

    slip: str
    formula: Expr


def _mutants(formula: Expr, others: Sequence[str]) -> list[_Mutant]:
    """All slips of one part of a formula; none if it is longer than `_LONGEST`.

    `others`: names that the derivation has, of which one may be mistaken for another where they
    differ in digits only.
    """
    places = list(_places(formula))
    if len(places) > _LONGEST:
        return []
    found = [
        _Mutant(slip, _put(formula, path, part))
        for path, node in places
        for slip, part in _slips_of_part(node, others)
    ]
    found += [_Mutant("two symbols exchanged", changed) for changed in _exchanged(formula)]
    return [mutant for mutant in found if mutant.formula != formula]


def _places(node: Expr, path: tuple[int, ...] = ()) -> Iterator[tuple[tuple[int, ...], Expr]]:
    """Every occurrence of a part, however often it is shared."""
    yield path, node
    for number_of_part, part in enumerate(node.parts):
        yield from _places(part, (*path, number_of_part))


def _put(node: Expr, path: Sequence[int], part: Expr) -> Expr:
    """The tree with another part at one occurrence."""
    if not path:
        return part
    parts = list(node.parts)
    parts[path[0]] = _put(parts[path[0]], path[1:], part)
    return Expr(node.kind, node.value, tuple(parts))


def _slips_of_part(node: Expr, others: Sequence[str]) -> Iterator[tuple[str, Expr]]:
    match node.kind:
        case "add":
            for place, term in enumerate(node.parts):
                yield "the sign of a term", _put(node, [place], _opposite(term))
        case "number" if node.fraction not in (0, 1, -1):
            value = node.fraction
            yield "a factor of two", number(2 * value)
            yield "a factor of two", number(value / 2)
            yield "a number", number(value + (1 if value > 0 else -1))
        case "pow":
            exponent = node.fraction
            yield "an exponent", power(node.parts[0], exponent + 1)
            if exponent == Fraction(1, 2):
                yield "an exponent", node.parts[0]
            elif exponent not in (1, 0):
                yield "an exponent", power(node.parts[0], exponent - 1)
        case "symbol":
            yield "an exponent", power(node, 2)
            for name in others:
                if name != node.name and _stem(name) == _stem(node.name):
                    yield "an index", symbol(name)
        case "div":
            top, bottom = node.parts
            yield "numerator and denominator exchanged", Expr("div", None, (bottom, top))
        case "mul" if not any(part.kind == "matrix" for part in node.parts):
            yield "a factor of two", mul(number(2), *node.parts)
            for place in range(len(node.parts)):
                rest = [part for other, part in enumerate(node.parts) if other != place]
                yield "a factor that is lost", mul(*rest)


def _opposite(term: Expr) -> Expr:
    """A term with the other sign, written as people write it."""
    match term.kind:
        case "neg":
            return term.parts[0]
        case "number":
            return number(-term.fraction)
        case "mul" if term.parts[0].kind == "number":
            return mul(number(-term.parts[0].fraction), *term.parts[1:])
        case _:
            return neg(term)


def _stem(name: str) -> str:
    """A name without its indices; one without indices is like no other."""
    stem = re.sub(r"\d+$", "", name)
    return stem if stem != name else f"{name}!"


def _exchanged(formula: Expr) -> Iterator[Expr]:
    """Two symbols in each other's place throughout."""
    names = sorted({node.name for node in walk(formula) if node.kind == "symbol"})
    for place, first in enumerate(names):
        for second in names[place + 1 :]:
            yield substituted(formula, {first: symbol(second), second: symbol(first)})
