"""The goals of a certificate decided by python-flint."""

from __future__ import annotations

from collections import Counter
from time import perf_counter

from gainproof.certify.algebra import Algebra, Quotient, RefutedError
from gainproof.certify.divisors import divisors, known_forms
from gainproof.certify.goals import Goal, Statement, Tower
from gainproof.certify.outcome import Outcome
from gainproof.certify.reading import statements, towers
from gainproof.certify.subjects import Subject

NAME = "flint"


def certify(subject: Subject, limit: float) -> Outcome:
    """Statement after statement; the time is looked at between them."""
    start, count, accepted, rejected, unfinished = perf_counter(), 0, 0, "", False
    left_out: Counter[str] = Counter()
    known = towers(subject.certificate)
    for statement in statements(subject.certificate):
        if statement.left_out:
            left_out[statement.left_out] += 1
            continue
        count += 1
        if perf_counter() - start > limit:
            unfinished = True
            continue
        try:
            decide(statement, known[statement.tower])
            accepted += 1
        except RefutedError as reason:
            rejected = rejected or f"{statement.id}: {reason}"
    seconds = perf_counter() - start
    return Outcome(subject.name, NAME, count, accepted, seconds, rejected, unfinished, left_out)


def decide(statement: Statement, tower: Tower) -> None:
    """Raises RefutedError for a goal that is not shown."""
    for place, goal in enumerate(statement.goals, 1):
        try:
            _decide(goal, tower, Algebra(tower, goal.free))
        except (RefutedError, ZeroDivisionError) as error:
            raise RefutedError(f"goal {place}: {error}") from None


def _decide(goal: Goal, tower: Tower, algebra: Algebra) -> None:
    known: dict[int, Quotient] = {}
    left, right = algebra.quotient(goal.left, known), algebra.quotient(goal.right, known)
    forms = {id(divisor): form for divisor, _, form in known_forms(goal, tower)}
    for divisor in divisors(goal):
        value = known[id(divisor)]
        if divisor.symbols().isdisjoint(goal.free) and not algebra.has_sign(value):
            form = forms.get(id(divisor))
            if form is None:
                raise RefutedError("a divisor is not shown to be nonzero")
            shown = algebra.quotient(form, known)
            if not (algebra.has_sign(shown) and algebra.equal(value, shown)):
                raise RefutedError("a divisor is not the form that is given for it")
    if not algebra.equal(left, right):
        raise RefutedError("the two sides differ")
    if goal.positive:
        for part in goal.right.parts:
            if not algebra.positive(algebra.quotient(part, known).above):
                raise RefutedError("a coefficient of what should be positive is not")
