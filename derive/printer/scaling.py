"""Scalings of the inputs that multiply each step of a program by a number: changes of units.

What is a ratio of steps then depends on fewer numbers than there are inputs: on the products of
powers of them that no such scaling changes (Buckingham). They are found from the program: terms of
a sum are scaled alike, what a function takes is not scaled at all.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from gainproof.derive.printer.program import Program

Row = list[Fraction]


@dataclass(frozen=True)
class Group:
    """Input number `axis` times powers of the inputs that are set to 1, by number."""

    axis: int
    powers: tuple[tuple[int, Fraction], ...]

    def text(self, names: Sequence[str], sized: bool = False) -> str:
        """As a formula; `sized`: of the magnitude of the input."""
        over = [f"|{names[self.axis]}|" if sized else names[self.axis]]
        under: list[str] = []
        for number, power in self.powers:
            size = abs(power)
            text = str(size) if size.denominator == 1 else f"({size})"
            factor = names[number] if size == 1 else f"{names[number]}**{text}"
            (over if power > 0 else under).append(factor)
        top, bottom = "*".join(over), "*".join(under)
        if not under:
            return top
        return f"{top}/{bottom}" if len(under) == 1 else f"{top}/({bottom})"


def groups(program: Program, positive: Sequence[bool]) -> tuple[list[Group], list[int]]:
    """The groups on which ratios depend, and the inputs that may be set to 1, all `positive`."""
    count = len(program.inputs)
    left = _kernel(_constraints(program), count)
    rows: dict[int, Row] = {}
    for axis in reversed(range(count)):
        found = next((row for row in left if row[axis] != 0), None) if positive[axis] else None
        if found is not None:
            pivot = [entry / found[axis] for entry in found]
            left = [_less(row, pivot, axis) for row in left if row is not found]
            rows = {place: _less(row, pivot, axis) for place, row in rows.items()}
            rows[axis] = pivot
    return [
        Group(axis, tuple((place, -row[axis]) for place, row in sorted(rows.items()) if row[axis]))
        for axis in range(count)
        if axis not in rows
    ], sorted(rows)


def _less(row: Row, pivot: Row, axis: int) -> Row:
    """The row without its entry at the axis."""
    return [entry - row[axis] * other for entry, other in zip(row, pivot, strict=True)]


def _constraints(program: Program) -> list[Row]:
    """Forms in the inputs' exponents that have to be 0."""
    count = len(program.inputs)
    nothing = [Fraction(0)] * count
    found: list[Row] = []
    sizes: list[Row] = []

    def apart(a: Row, b: Row) -> Row:
        return [x - y for x, y in zip(a, b, strict=True)]

    for number, step in enumerate(program.steps):
        parts = [sizes[part] for part in step.operands]
        match step.operation:
            case "input":
                axis = program.axis(number)
                sizes.append([Fraction(int(place == axis)) for place in range(count)])
            case "constant":
                sizes.append(nothing)
            case "neg" | "abs":
                sizes.append(parts[0])
            case "mul" if step.scale is not None:
                sizes.append(parts[0])
            case "mul":
                sizes.append([x + y for x, y in zip(*parts, strict=True)])
            case "div":
                sizes.append(apart(*parts))
            case "sqrt":
                sizes.append([x / 2 for x in parts[0]])
            case "add" | "sub" | "hypot" | "atan2":
                found.append(apart(*parts))
                sizes.append(nothing if step.operation == "atan2" else parts[0])
            case _:
                found += parts
                sizes.append(nothing)
    return found


def _kernel(rows: Sequence[Row], count: int) -> list[Row]:
    """A basis of what all rows vanish on."""
    pivots: dict[int, Row] = {}
    for row in rows:
        for axis, known in pivots.items():
            row = _less(row, known, axis)
        first = next((place for place, entry in enumerate(row) if entry != 0), None)
        if first is None:
            continue
        pivot = [entry / row[first] for entry in row]
        pivots = {place: _less(known, pivot, first) for place, known in pivots.items()}
        pivots[first] = pivot
    free = [axis for axis in range(count) if axis not in pivots]
    return [
        [
            Fraction(int(place == axis)) if place not in pivots else -pivots[place][axis]
            for place in range(count)
        ]
        for axis in free
    ]
