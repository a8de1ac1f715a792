"""The goals of a certificate decided by python-flint."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import flint

from gainproof.certify.divisors import divisors, known_forms
from gainproof.certify.expression import Tree
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
        except _RefutedError as reason:
            rejected = rejected or f"{statement.id}: {reason}"
    seconds = perf_counter() - start
    return Outcome(subject.name, NAME, count, accepted, seconds, rejected, unfinished, left_out)


def decide(statement: Statement, tower: Tower) -> None:
    """Raises RefutedError for a goal that is not shown."""
    for place, goal in enumerate(statement.goals, 1):
        try:
            _decide(goal, tower, _Algebra(tower, goal.free))
        except (_RefutedError, ZeroDivisionError) as error:
            raise _RefutedError(f"goal {place}: {error}") from None


def _decide(goal: Goal, tower: Tower, algebra: _Algebra) -> None:
    known: dict[int, _Quotient] = {}
    left, right = algebra.quotient(goal.left, known), algebra.quotient(goal.right, known)
    forms = {id(divisor): form for divisor, _, form in known_forms(goal, tower)}
    for divisor in divisors(goal):
        value = known[id(divisor)]
        if divisor.symbols().isdisjoint(goal.free) and not algebra.has_sign(value):
            form = forms.get(id(divisor))
            if form is None:
                raise _RefutedError("a divisor is not shown to be nonzero")
            shown = algebra.quotient(form, known)
            if not (algebra.has_sign(shown) and algebra.equal(value, shown)):
                raise _RefutedError("a divisor is not the form that is given for it")
    if not algebra.equal(left, right):
        raise _RefutedError("the two sides differ")
    if goal.positive:
        for part in goal.right.parts:
            if not algebra.positive(algebra.quotient(part, known).above):
                raise _RefutedError("a coefficient of what should be positive is not")


class _RefutedError(Exception):
    """A goal that does not hold, or does not follow from its evidence."""


@dataclass(frozen=True)
class _Quotient:
    above: Any
    below: Any


class _Algebra:
    """The polynomials of a tower and free names. Roots come first: their powers are reduced."""

    def __init__(self, tower: Tower, free: tuple[str, ...]) -> None:
        roots = [relation.symbol for relation in tower.relations]
        self.names = (*reversed(roots), *tower.parameters, *free)
        self.context = flint.fmpq_mpoly_ctx.get(list(self.names), flint.Ordering.lex)
        self.variables = dict(zip(self.names, self.context.gens(), strict=True))
        self.one = self.context.constant(1)
        self.signed = set(free)
        self.shift = {
            name: self.variables[name] + flint.fmpq(*map(int, f"{start}/1".split("/")[:2]))
            for name, start in tower.shifted.items()
        }
        self.relations: list[Any] = []
        self.elements: dict[str, _Quotient] = {}
        for relation in tower.relations:
            value = self.quotient(relation.radicand, {})
            root = self.variables[relation.symbol] ** relation.power
            self.relations.append(root - value.above / value.below.leading_coefficient())
        self.relations.reverse()
        for name, element in tower.elements.items():
            self.elements[name] = self.quotient(element, {})
            if not self.positive(self.elements[name].below):
                raise _RefutedError(f"the denominator of {name} is not seen to be positive")

    def reduced(self, value: Any) -> Any:
        """The remainder of a polynomial by the relations, of which each has a power of its root."""
        previous = None
        while previous != value:
            previous = value
            for relation in self.relations:
                value = divmod(value, relation)[1]
        return value

    def equal(self, left: _Quotient, right: _Quotient) -> bool:
        return bool(self.reduced(left.above * right.below - right.above * left.below) == 0)

    def has_sign(self, value: _Quotient) -> bool:
        """Whether it is seen from its coefficients that a quotient is not zero."""
        return self.positive(value.above) or self.positive(-value.above)

    def positive(self, value: Any) -> bool:
        """Whether all coefficients are, counted from the parameters' ends, one without an end."""
        ends = []
        if self.shift:
            value = value.compose(*(self.shift.get(n, self.variables[n]) for n in self.names))
        places = [self.names.index(name) for name in self.shift]
        free = [self.names.index(name) for name in self.signed]
        for powers, coefficient in value.terms():
            if coefficient < 0 or any(powers[place] for place in free):
                return False
            ends.append(any(powers[place] for place in places))
        return bool(ends) and not all(ends)

    def quotient(self, tree: Tree, known: dict[int, _Quotient]) -> _Quotient:
        """A tree's value where its divisors are not zero; those of its parts become known."""
        for node in tree.nodes():
            if id(node) not in known:
                known[id(node)] = self._value(node, [known[id(part)] for part in node.parts])
        return known[id(tree)]

    def _value(self, tree: Tree, parts: list[_Quotient]) -> _Quotient:
        match tree.operation:
            case "number":
                value = tree.value
                return self._made(
                    self.one * flint.fmpq(value.numerator, value.denominator), self.one
                )
            case "symbol" if tree.name in self.elements:
                return self.elements[tree.name]
            case "symbol":
                return _Quotient(self.variables[tree.name], self.one)
            case "add":
                result = parts[0]
                for part in parts[1:]:
                    shared = result.below.gcd(part.below)
                    own, other = result.below / shared, part.below / shared
                    above = result.above * other + part.above * own
                    result = self._made(above, result.below * other)
                return result
            case "mul":
                result = parts[0]
                for part in parts[1:]:
                    result = self._made(result.above * part.above, result.below * part.below)
                return result
            case "div":
                return self._made(parts[0].above * parts[1].below, parts[0].below * parts[1].above)
        (base,) = parts
        if tree.exponent < 0:
            base = _Quotient(base.below, base.above)
        power = abs(tree.exponent)
        return self._made(base.above**power, base.below**power)

    def _made(self, above: Any, below: Any) -> _Quotient:
        above, below = self.reduced(above), self.reduced(below)
        shared = above.gcd(below)
        return _Quotient(above / shared, below / shared)
