"""The algebraic statement that a statement with functions becomes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import Expr, mul, number, power, symbols_of, walk
from gainproof.verify.judge.exact.expression_text import is_series
from gainproof.verify.judge.exact.statement import STRICT, Statement
from gainproof.verify.judge.exact.total_expressions import is_total
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.transcendental.function_variables import (
    MINUS,
    Atoms,
    Key,
    angle_terms,
    is_opaque,
)
from gainproof.verify.judge.transcendental.nested_functions import flattened
from gainproof.verify.judge.transcendental.pi import VARIABLE
from gainproof.verify.judge.transcendental.variable_ranges import Positive

MOST_MULTIPLE = 12
MOST_POWER = 1000
"""Of a new variable: exponents that differ in their eleventh digit have a common part so small that
polynomials in it could not be written out.
"""
MOST_STRICT = 2

Pair = tuple[Expr, Expr]


@dataclass(frozen=True)
class Freed:
    """An algebraic statement that implies the given one; `boxes` hold those of the new variables
    too, `labels` say what these were, `exclusions` where nothing is said. `whole_turns` are the
    angles for which it says nothing of half a turn, although that matters.
    """

    statement: Statement
    boxes: Mapping[str, Box]
    labels: Mapping[str, str]
    exclusions: tuple[str, ...] = ()
    whole_turns: tuple[Key, ...] = ()


def has_functions(statement: Statement) -> bool:
    """Whether a function value stands anywhere in the statement."""
    return any(node.kind == "call" for node in walk(*statement.exprs()))


def freed(
    statement: Statement,
    boxes: Mapping[str, Box],
    is_positive: Positive,
    turned: frozenset[Key] = frozenset(),
) -> Freed:
    """The statement with every function value a variable; `turned` angles begin half a turn
    further. Raises Undecided.
    """
    if statement.connective != "if":
        raise Undecided("an equivalence between function values is not covered")
    statement = replace(statement, needed=(*statement.needed, *arguments(statement)))
    statement = statement.mapped(lambda e: flattened(e, is_positive))
    atoms = Atoms(boxes, is_positive, turned)
    atoms.collect(*statement.exprs())

    bound = bound_names(statement)

    def changed(expr: Expr) -> Expr:
        return rebuilt(expr, lambda node, _: _free(node, atoms) if is_open(node) else None)

    def is_open(node: Expr) -> bool:
        return node.kind == "call" and (is_series(node) or not symbols_of(node) & bound)

    moved = statement.mapped(changed)
    if VARIABLE.name in moved.symbols():
        moved = replace(moved, given=(*moved.given, *atoms.quarter_turns()))
    moved = replace(moved, given=(*moved.given, *atoms.signs()))
    # what holds at all other angles holds at this one by continuity, but for strict relations, and
    # where conditions may come to hold there
    strict = any(r.operator in STRICT for r in statement.relations)
    strict = strict or has_functions(Statement(statement.domain))
    exclusions, turns = tuple(atoms.exclusions.values()), tuple(atoms.whole_turns(unstated=strict))
    if strict and len(turns) > MOST_STRICT:
        raise Undecided(f"a strict relation between more than {MOST_STRICT} angles is not covered")
    return Freed(moved, {**boxes, **atoms.made}, atoms.labels(), exclusions, turns)


def bound_names(statement: Statement) -> set[str]:
    """The indices of sums and products."""
    return {n.parts[1].name for n in walk(*statement.exprs()) if is_series(n)}


def arguments(statement: Statement) -> list[Expr]:
    """What functions are taken of and may lack a value: of that the new variables say nothing."""
    calls = [n for n in walk(*statement.exprs()) if n.kind == "call"]
    bound = bound_names(statement)
    found = [part for n in calls if not is_series(n) for part in n.parts]
    return [part for part in found if not symbols_of(part) & bound and not is_total(part)]


def _free(node: Expr, atoms: Atoms) -> Expr:
    if is_opaque(node):
        return atoms.whole(node)
    if node.name in ("exp", "power"):
        return _product(node, atoms)
    cosine, sine = number(1), number(0)
    for key, c in angle_terms(node):
        t, divisor = atoms.half_angle(key[2])
        multiple = c * divisor
        if abs(multiple) > MOST_MULTIPLE:
            raise Undecided(f"a multiple of an angle beyond {MOST_MULTIPLE}")
        unit = _unit(t)
        if key in atoms.turned:
            unit = (-unit[0], -unit[1])
        cosine, sine = _together((cosine, sine), _multiple(unit, int(multiple)))
    return {"sin": sine, "cos": cosine}.get(node.name) or sine / cosine


def _product(node: Expr, atoms: Atoms) -> Expr:
    factors = []
    for key, c in atoms.exponents(node):
        variable, divisor = atoms.power(key)
        n = int(c * divisor)
        if key[1] == MINUS:
            n %= 2  # the square of (-1)^m is 1
        if abs(n) > MOST_POWER:
            raise Undecided(f"a power of a function value beyond {MOST_POWER}")
        if n:
            factors.append(variable if n == 1 else power(variable, n))
    return mul(*factors) if factors else number(1)


def _unit(t: Expr) -> Pair:
    """Cosine and sine of the angle of which t is the tangent of the half."""
    below = 1 + power(t, 2)
    return (1 - power(t, 2)) / below, 2 * t / below


def _together(a: Pair, b: Pair) -> Pair:
    (c, s), (d, r) = a, b
    return c * d - s * r, s * d + c * r


def _multiple(unit: Pair, n: int) -> Pair:
    total: Pair = (number(1), number(0))
    for _ in range(abs(n)):
        total = _together(total, unit)
    return total if n >= 0 else (total[0], -total[1])
