"""Dimensions of printed formulas: sides and terms must agree before anything else is asked.

A number has no dimension; the number zero has any. A symbol without a declared unit has an unknown
one, which agrees with everything.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.judge.claim.record import Setting, SymbolEntry, Unit
from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.graph import read_graph
from gainproof.verify.judge.exact.limits import Malformed
from gainproof.verify.judge.formula import Formula, Graph, Reading, Relation

ONE = Unit()
VARIANCES = "the variances of noises"
MOST_CALLS = 500
"""Calls of functions looked into: inside one another they double with every definition. What is
beyond has an unknown dimension.
"""


@dataclass(frozen=True)
class _Any:
    """Zero, or a symbol of unknown unit."""


ANY = _Any()
Dimension = Unit | _Any


class Mismatch(Exception):
    """Two dimensions that should agree and do not; the text names both."""


def fitting_readings(formula: Formula, setting: Setting) -> tuple[tuple[Reading, ...], str | None]:
    """The readings of a formula whose dimensions agree; if there is none, what is wrong."""
    faults = [reading_fault(reading, setting) for reading in formula.readings]
    fitting = tuple(r for r, fault in zip(formula.readings, faults, strict=True) if fault is None)
    return fitting, None if fitting else f"dimensions: {faults[0]}"


def reading_fault(reading: Reading, setting: Setting) -> str | None:
    """What is wrong with the dimensions of a reading, or None."""
    for relation in (*reading.relations, *reading.conditions):
        try:
            relation_dimensions(relation, setting)
        except Mismatch as fault:
            return str(fault)
        except Malformed:
            return None  # reported where the reading is judged
    return None


def relation_dimensions(relation: Relation, setting: Setting) -> None:
    """Raises Mismatch if the sides of a relation, or terms inside them, differ in dimension."""
    names = _Names(setting)
    left, right = (dimension(read_graph(side), names) for side in (relation.left, relation.right))
    _agree([left, right], "the sides")


def dimension_of(graph: Graph, setting: Setting) -> Unit | None:
    """The dimension of a formula; None if it mixes dimensions or one is not known."""
    try:
        found = dimension(read_graph(graph), _Names(setting))
    except (Mismatch, Malformed):
        return None
    return found if isinstance(found, Unit) else None


class _Names:
    """Dimensions of symbols; those of definitions follow from their formulas."""

    def __init__(self, setting: Setting, local: Mapping[str, Dimension] | None = None) -> None:
        self.setting = setting
        self.local = dict(local or {})
        self.known: dict[str, Dimension] = {"infinity": ANY}
        self.open: set[str] = set()
        self.calls: dict[tuple[str, tuple[Dimension, ...]], Dimension] = {}

    def of(self, token: str) -> Dimension:
        if token in self.local:
            return self.local[token]
        if token not in self.known:
            if token in self.open:
                return ANY
            self.open.add(token)
            entry = self.setting.symbols.get(token)
            self.known[token] = ANY if entry is None else self._of_entry(entry)
            self.open.discard(token)
        return self.known[token]

    def _of_entry(self, entry: SymbolEntry) -> Dimension:
        if entry.unit is not None:
            return entry.unit
        if entry.definition is None or entry.arguments:
            return ANY
        found: Dimension = ANY
        for reading in entry.definition.readings:
            try:
                found = dimension(read_graph(reading.relations[0].right), self)
            except Mismatch:
                continue
            break
        return found


def dimension(expr: Expr, names: _Names) -> Dimension:
    """The dimension of an expression over declared symbols. Raises Mismatch."""
    done: dict[bytes, Dimension] = {}
    for node in walk(expr):
        done[node.key] = _node(node, [done[p.key] for p in node.parts], names)
    return done[expr.key]


def _node(node: Expr, parts: list[Dimension], names: _Names) -> Dimension:
    match node.kind:
        case "number":
            return ANY if node.fraction == 0 else ONE
        case "symbol":
            return names.of(node.name)
        case "add":
            return _agree(parts, "the terms of a sum")
        case "mul":
            total: Dimension = ONE
            for part in parts:
                total = _times(total, part, 1)
            return total
        case "div":
            return _times(parts[0], parts[1], -1)
        case "neg":
            return parts[0]
        case "pow":
            return _times(ONE, parts[0], node.fraction)
        case "derivative":
            return _times(parts[0], names.of(node.name), -1)
        case "at":
            _agree([names.of(node.name), parts[1]], "a symbol and what replaces it")
            return parts[0]
        case _:
            return _call(node, parts, names)


def _call(node: Expr, parts: list[Dimension], names: _Names) -> Dimension:
    if node.name == "sum":
        return parts[0]
    if node.name == "expectation":
        _agree_with_variances(names)
        return parts[0]
    entry = names.setting.symbols.get(node.name)
    if entry is None or entry.definition is None or node.name in names.open:
        return ANY
    call = (node.name, tuple(parts))
    if call in names.calls:
        return names.calls[call]
    if len(names.calls) > MOST_CALLS:
        return ANY
    names.calls[call] = ANY
    names.open.add(node.name)
    try:
        inner = _Names(names.setting, dict(zip(entry.arguments, parts, strict=False)))
        inner.open, inner.calls = names.open, names.calls
        body = read_graph(entry.definition.readings[0].relations[0].right)
        names.calls[call] = dimension(body, inner)
    finally:
        names.open.discard(node.name)
    return names.calls[call]


def _agree_with_variances(names: _Names) -> None:
    """Raises Mismatch if the variance of a noise has not the dimension of its square."""
    if VARIANCES in names.open:
        return  # a variance that is an expectation, which is refused where it is evaluated
    names.open.add(VARIANCES)
    for token, entry in names.setting.symbols.items():
        if entry.variance is not None:
            square = _times(ONE, names.of(token), 2)
            variance = dimension(read_graph(entry.variance), names)
            _agree([square, variance], f"the square of {token} and its variance")
    names.open.discard(VARIANCES)


def _times(a: Dimension, b: Dimension, exponent: int | Fraction) -> Dimension:
    if isinstance(a, _Any) or isinstance(b, _Any):
        return ANY
    return Unit(a.metre + exponent * b.metre, a.second + exponent * b.second)


def _agree(parts: Sequence[Dimension], what: str) -> Dimension:
    known = [p for p in parts if not isinstance(p, _Any)]
    for part in known:
        if part != known[0]:
            raise Mismatch(f"{what} have dimensions {unit_text(known[0])} and {unit_text(part)}")
    return known[0] if known else ANY


def unit_text(unit: Unit) -> str:
    """`m s^-1`, or `1` without dimension."""
    shown = [
        name if exponent == 1 else f"{name}^{exponent}"
        for name, exponent in (("m", unit.metre), ("s", unit.second))
        if exponent
    ]
    return " ".join(shown) or "1"
