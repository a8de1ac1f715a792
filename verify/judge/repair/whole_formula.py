"""What a slip does to a whole formula: a sign of comparison, a side, an index everywhere, a
deviation where a variance is meant.

An index moved by one is written the way one would print it: 2(k + 1) - 1 is 2k + 1.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of
from gainproof.verify.judge.repair.edits import (
    LARGE,
    PLAIN,
    ROOT,
    SLIGHT,
    SQUARE,
    SYMBOL_EVERYWHERE,
    Table,
)
from gainproof.verify.judge.repair.printed_formula import Printed
from gainproof.verify.judge.repair.requested_operations import asked_names, open_sides
from gainproof.verify.judge.repair.tree_construction import (
    HALF,
    ONE,
    TWO,
    multiplied,
    opposite,
    places,
    product,
    quotient,
    raised,
    remade,
    total,
)

SIDE, DOUBLED, TURNED = "sign of a side", "a factor 2 of a side", "a side upside down"
OF_SIDES = frozenset((SIDE, DOUBLED, TURNED))
"""Changes of a whole side that would do on the other side as well."""
COMPARISONS = ("<", "<=", ">", ">=")


@dataclass(frozen=True)
class Change:
    """A changed formula, the weight of all its changes, and these in words and nodes."""

    printed: Printed
    weight: int
    steps: tuple[Step, ...]


@dataclass(frozen=True)
class Step:
    """One change in words; `before` and `after` are what it made of a part, where that helps;
    `times` is in how many places.
    """

    what: str
    before: Expr | None = None
    after: Expr | None = None
    part: Expr | None = None
    times: int = 1


def changes_of_whole(
    formula: Printed, table: Table, numbers: frozenset[str], most: int = LARGE
) -> Iterator[Change]:
    """All of them that weigh at most `most`; `numbers` are the symbols that count samples."""
    for n, link in enumerate(formula.links):
        if link.operator in COMPARISONS:
            for operator in COMPARISONS:
                if operator != link.operator:
                    links = (
                        *formula.links[:n],
                        replace(link, operator=operator),
                        *formula.links[n + 1 :],
                    )
                    weight = SLIGHT
                    step = Step(f"the sign {link.operator} that is {operator}")
                    yield Change(replace(formula, links=links), weight, (step,))
    for n in open_sides(formula):
        side = formula.sides[n]
        for new, weight, what in _sides(side, table, numbers, most):
            yield Change(formula.with_side(n, new), weight, (Step(what, side, new),))
    yield from _everywhere(formula, table, numbers, most)


def _sides(
    side: Expr, table: Table, numbers: frozenset[str], most: int
) -> Iterator[tuple[Expr, int, str]]:
    yield opposite(side), SLIGHT, SIDE
    if most >= PLAIN:
        for factor in (TWO, quotient(ONE, TWO)):
            yield multiplied(side, factor), PLAIN, DOUBLED
        if side.kind != "div":
            yield quotient(ONE, side), PLAIN, TURNED
    for name in table.symbols if most >= LARGE else ():
        yield product(side, symbol(name)), LARGE, "a missing factor"
        yield quotient(side, symbol(name)), LARGE, "a missing divisor"
    for name in numbers & symbols_of(side):
        for shift in (1, -1):
            yield shifted(side, name, shift), SLIGHT, "an index of samples"


def _everywhere(
    formula: Printed, table: Table, numbers: frozenset[str], most: int
) -> Iterator[Change]:
    """One symbol changed wherever it stands in the claim."""
    claimed = [n for n in open_sides(formula) if not asked_names(formula.sides[n])]
    used = [symbols_of(side) for side in formula.sides]
    for name in sorted({s for n in claimed for s in used[n]}):
        x = symbol(name)
        times = sum(node == x for n in claimed for _, node in places(formula.sides[n]))
        new: list[tuple[Expr, int, str]] = []
        for shift in (1, -1) if name in numbers else ():
            sides = tuple(
                shifted(side, name, shift) if n in claimed else side
                for n, side in enumerate(formula.sides)
            )
            step = Step("the number of the first sample", x, shifted(x, name, shift), times=times)
            yield Change(formula.with_sides(sides), SLIGHT, (step,))
        if most < PLAIN:
            continue
        new.append((raised(x, Fraction(2)), PLAIN, SQUARE))
        new.append((raised(x, HALF), PLAIN, ROOT))
        new += [
            (symbol(other), PLAIN, SYMBOL_EVERYWHERE)
            for other in table.symbols
            if (name, other) in table.alike
        ]
        for value, weight, what in new:
            sides = tuple(
                substituted(side, {name: value}) if n in claimed and name in used[n] else side
                for n, side in enumerate(formula.sides)
            )
            yield Change(formula.with_sides(sides), weight, (Step(what, x, value, times=times),))


def shifted(expr: Expr, name: str, by: int) -> Expr:
    """The symbol replaced by itself plus a number, sums of numbers added up."""
    moved = _summed((symbol(name), number(by)))

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr:
        if node.kind == "symbol" and node.name == name:
            return moved
        return _summed(parts) if node.kind == "add" else remade(node.kind, node.value, parts)

    return rebuilt(expr, change)


def _summed(terms: tuple[Expr, ...]) -> Expr:
    constant = Fraction(0)
    rest: list[Expr] = []
    for part in (part for term in terms for part in _flat(term)):
        value = _number(part)
        if value is None:
            rest.append(part)
        else:
            constant += value
    size = number(abs(constant))
    return total(*rest, size if constant > 0 else opposite(size)) if constant else total(*rest)


def _number(term: Expr) -> Fraction | None:
    if term.kind == "number":
        return term.fraction
    inner = term.parts[0] if term.kind == "neg" else None
    return -inner.fraction if inner is not None and inner.kind == "number" else None


def _flat(term: Expr) -> tuple[Expr, ...]:
    return term.parts if term.kind == "add" else _spread(term)


def _spread(term: Expr) -> tuple[Expr, ...]:
    """A number times a sum, term by term."""
    if term.kind != "mul" or len(term.parts) != 2:
        return (term,)
    factor, inner = term.parts
    if factor.kind != "number" or inner.kind != "add":
        return (term,)
    found = []
    for part in inner.parts:
        value = _number(part)
        found.append(product(factor, part) if value is None else number(factor.fraction * value))
    return tuple(found)
