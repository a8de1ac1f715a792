"""Formulas of kernels as text: a page of lines `name = formula`, and the graphs made of them.

    ## Where m1 = 1 and m2 = 0

        velocity = (step + p)/N

Lines that begin with four blanks are formulas, in the notation of pages, and go on where the next
begins with more; all else is prose, but for headings. What stands below one that begins with
`## Where` holds where its conditions do and comes before what stands above; so does what stands
below `### NAME` for that kernel, where `NAME_kernel = 1`. A name may be used before its line.
Operations are made in the order that is written, from the left, so that rounding is the author's;
in kernels a number stands behind what it multiplies. Numbers are exact: what 0 and 1 make
superfluous is left out. A number that is written may be taken away, what is worked out may not:
where it is negative the form is not one for this model.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, reduce
from pathlib import Path
from typing import Any

from gainproof.derive.derivation import PageError
from gainproof.derive.pages.formula import NAME, Formula, FormulaError, read_formula
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node

HEADING, WHERE, OF_KERNEL = "## ", "## Where ", "### "
ROW = "_kernel"
"""Ends the name of the row of a kernel's outputs."""
PLANE = "_in_plane"
"""The end of the names of kernels in the plane."""
INDENT = "    "
CALLS = {"atan2": 2, "cos": 1, "exp": 1, "expm1": 1, "sin": 1, "sqrt": 1, "near_cbrt": 1}
CALLS |= {"unknown": 2, "fixed_point": 2}
"""Functions, with how many arguments they have: with `u = unknown(start, within)`, a number, the
root of `u = map` is `fixed_point(u, map)`, see `printer.fixed_point`.
"""
SCALE = "_scale"
"""Ends the name of what an output of changing sign is measured by: its parts, added."""
TURN = "_turn"
"""Ends the name of a difference."""
FIRST, SECOND = "d_", "dd_"
"""Begin the names of formulas of derivatives."""
_LINE = re.compile(rf"({NAME}) = (.+)")
_NEARLY = re.compile(r"#+\s*where\b", re.IGNORECASE)
_RELATIONS: Mapping[str, Callable[[Any, Any], bool]] = {"=": operator.eq, "<": operator.lt}
Value = Any
"""A node or an expression of SymPy, or a Fraction."""


@dataclass(frozen=True)
class Condition:
    """A relation of two formulas of numbers."""

    left: Formula
    relation: str
    right: Formula

    def __str__(self) -> str:
        """As it is written."""
        return f"{self.left} {self.relation} {self.right}"


@dataclass(frozen=True)
class Section:
    """Formulas by name, and the conditions under which they hold; `of_kernel`: those of one."""

    conditions: tuple[Condition, ...]
    formulas: dict[str, Formula]
    of_kernel: bool = False


def read_sections(text: str) -> tuple[Section, ...]:
    """The sections of a page. Raises FormulaError, with the line, for what is no formula."""
    found = [Section((), {})]
    outside = formulas = found[0]
    for number, line in _joined(text):
        try:
            if line.startswith(OF_KERNEL):
                kernel = line.removeprefix(OF_KERNEL).split(" ")[0].removesuffix(PLANE)
                given = (*outside.conditions, _condition(f"{kernel}{ROW} = 1"))
                formulas = Section(given, {}, of_kernel=True)
            elif line.startswith(WHERE):
                given = tuple(map(_condition, line[len(WHERE) :].split(" and ")))
                outside = formulas = Section(given, {})
                found.append(outside)
            elif line.startswith(HEADING):
                formulas = outside
            else:
                match = _LINE.fullmatch(line)
                if match is None:
                    raise FormulaError("wanted a line `name = formula`")
                if match[1] in formulas.formulas:
                    raise FormulaError(f"{match[1]} has a formula here already")
                formulas.formulas[match[1]] = read_formula(match[2])
                if formulas is not found[-1] and formulas.of_kernel:
                    found.append(formulas)
        except FormulaError as error:
            raise FormulaError(f"line {number}: {error}") from error
    return tuple(found)


def read_page(page: Path) -> tuple[Section, ...]:
    """The sections of a file. Raises PageError, with file and line, for what is no formula."""
    try:
        return read_sections(page.read_text(encoding="utf-8"))
    except FormulaError as error:
        raise PageError(f"{place_of(page)}, {error}") from None


def place_of(page: Path) -> str:
    """A page as errors call it, from `derive` on."""
    return "/".join(page.parts[-3:])


def _joined(text: str) -> list[tuple[int, str]]:
    """Headings with conditions and whole formulas, each with the number of its first line."""
    found: list[tuple[int, str]] = []
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith(f"{INDENT} ") and found:
            first, start = found[-1]
            found[-1] = (first, f"{start} {line.strip()}")
        elif line.startswith((INDENT, WHERE, OF_KERNEL)):
            found.append((number, line.strip()))
        elif line.startswith((" ", "\t")):
            raise FormulaError(f"line {number}: a formula begins with four blanks, prose with none")
        elif _NEARLY.match(line):
            raise FormulaError(f"line {number}: wanted a heading `{WHERE}...`, came {line!r}")
        elif line.startswith(HEADING):
            found.append((number, line))
    return found


def _condition(text: str) -> Condition:
    match = re.fullmatch(r"(.+) ([=<]) (.+)", text)
    if match is None:
        raise FormulaError(f"wanted a condition such as m2 = 0, came {text!r}")
    return Condition(read_formula(match[1]), match[2], read_formula(match[3]))


@cache
def page_sections(page: Path) -> tuple[Section, ...]:
    """What `read_page` reads, of files that do not change while the program runs."""
    return read_page(page)


def formula_of(kernel: str, output: str) -> str:
    """The name of the formula by which a kernel computes an output."""
    if kernel.endswith("_second_derivatives"):
        return f"{SECOND}{output}"
    if kernel.endswith("_derivatives") and kernel != "gains_with_derivatives":
        return f"{FIRST}{output}"
    return output


def formula_graph(
    builder: GraphBuilder,
    page: Path,
    known: Mapping[str, Value],
    outputs: Mapping[str, str],
    names: Mapping[str, Node],
) -> Graph:
    """The graph of outputs, each by the name of its formula; a difference with a scale has a name.

    Raises as `page_values` does, and PageError for an output without a formula.
    """
    wanted = [f"{name}{end}" for name in outputs.values() for end in ("", SCALE, TURN)]
    found = page_values(page, known, wanted)
    made: dict[str, Value] = {}
    turns: dict[str, Node] = {}
    for output, name in outputs.items():
        if name not in found:
            raise PageError(f"{place_of(page)}: the output {name!r} has no formula")
        made[output] = found[name]
        # a scale of 0 says that nothing cancels
        if found.get(f"{name}{SCALE}", 0) != 0:
            made[f"{output}{SCALE}"] = found[f"{name}{SCALE}"]
            turn = f"{name}{TURN}"
            turns[f"{output}{TURN}"] = found[turn if turn in found else name]
    return builder.graph(made, {**names, **turns})


def page_values(page: Path, known: Mapping[str, Value], names: Iterable[str]) -> dict[str, Value]:
    """What `kernel_values` makes of the formulas of a file.

    Raises PageError, with the file, where that raises FormulaError, and ArithmeticError as that
    does.
    """
    try:
        return kernel_values(page_sections(page), known, names)
    except FormulaError as error:
        raise PageError(f"{place_of(page)}: {error}") from None
    except ArithmeticError as error:
        raise ArithmeticError(f"{place_of(page)}: {error}") from None


def kernel_values(
    sections: Iterable[Section], known: Mapping[str, Value], names: Iterable[str]
) -> dict[str, Value]:
    """The values of some names over known nodes or symbols, and numbers; those without a formula
    are left out.

    Raises ArithmeticError where a number that stands with a node is negative, and for a quotient by
    0: a form that is not for this model; FormulaError for what a formula cannot hold. What is known
    is taken before a formula of that name, which another kernel may have.
    """
    formulas = formulas_that_hold(sections, known)
    found = _Values(known, formulas)
    return {name: found[name] for name in names if name in formulas}


def formulas_that_hold(
    sections: Iterable[Section], known: Mapping[str, Value]
) -> dict[str, Formula]:
    """Formulas by name, in the order of the page, of sections whose conditions known values meet.

    Raises FormulaError for a condition over what is no known number.
    """
    formulas: dict[str, Formula] = {}
    given = _Values(known, {})

    def holds(condition: Condition) -> bool:
        sides = [_value(side, given) for side in (condition.left, condition.right)]
        if any(isinstance(side, Node) for side in sides):
            raise FormulaError(f"a condition is about numbers: {condition}")
        return _RELATIONS[condition.relation](*sides)

    for section in sections:
        if section.of_kernel and str(section.conditions[-1].left) not in known:
            continue
        if all(map(holds, section.conditions)):
            for name in section.formulas if section.of_kernel else ():
                formulas.pop(name, None)  # comes in the order of the kernel's own
            formulas |= section.formulas
    return formulas


class _Values(dict[str, Value]):
    """Values by name, each made when it is first asked for."""

    def __init__(self, known: Mapping[str, Value], formulas: Mapping[str, Formula]) -> None:
        super().__init__(known)
        self._left = dict(formulas)

    def __missing__(self, name: str) -> Value:
        if name not in self._left:
            raise FormulaError(f"{name!r} has no formula, or one that needs itself")
        self[name] = _value(self._left.pop(name), self)
        return self[name]


def _value(formula: Formula, known: Mapping[str, Value]) -> Value:
    if formula.kind == "name":
        return known[formula.text]
    if formula.kind == "number":
        return Fraction(formula.text)
    if formula.kind == "call" and formula.text in CALLS:
        return _call(formula.text, [_value(part, known) for part in formula.parts], known)
    if formula.kind not in (*_OPERATIONS, "neg", "pow"):
        raise FormulaError(f"no sum, product, quotient or function that is known: {formula}")
    first, *others = formula.parts
    found = _value(first, known)
    if formula.kind == "neg":
        return -found
    if formula.kind == "pow":
        return reduce(_product, [found] * int(formula.text))
    for part in others:
        if part.kind == "neg" and isinstance(found, Node) and _is_number(part.parts[0]):
            found = found - _value(part.parts[0], known)
            continue
        other = _value(part, known)
        if formula.kind == "div" and other == 0:
            raise ZeroDivisionError(f"no form: {formula} divides by 0")
        found = _OPERATIONS[formula.kind](found, other)
    return found


def _is_number(formula: Formula) -> bool:
    return formula.kind == "number" or (
        formula.kind == "div" and all(map(_is_number, formula.parts))
    )


def _call(function: str, values: Sequence[Value], known: Mapping[str, Value]) -> Node:
    """A function of nodes, or the root of a number."""
    if len(values) != CALLS[function]:
        raise FormulaError(f"{function}: {CALLS[function]} wanted in brackets, {len(values)} came")
    nodes = [node for node in (*values, *known.values()) if isinstance(node, Node)]
    if function == "sqrt" and nodes:
        return nodes[0].builder.sqrt(values[0])
    if function == "fixed_point":
        values = (*values, values[-1])
    if not all(isinstance(value, Node) for value in values[: 1 if function == "unknown" else None]):
        raise FormulaError(f"{function} of a number: write its value")
    found: Node = values[0].builder.call(function, *values)
    return found


def _sum(one: Value, other: Value) -> Value:
    _require_positive(one, other)
    if one == 0 or other == 0:
        return other if one == 0 else one
    return one + other


def _product(one: Value, other: Value) -> Value:
    _require_positive(one, other)
    if one == 0 or other == 0:
        return Fraction(0)
    if one == 1 or other == 1:
        return other if one == 1 else one
    return other * one if isinstance(one, Fraction) else one * other


def _quotient(one: Value, other: Value) -> Value:
    _require_positive(one, other)
    return one if one == 0 or other == 1 else one / other


def _require_positive(*parts: Value) -> None:
    numbers = [part for part in parts if isinstance(part, Fraction)]
    if len(numbers) == 1 and numbers[0] < 0:
        raise ArithmeticError(f"no form without a subtraction: {numbers[0]} stands with a node")


_OPERATIONS: Mapping[str, Callable[[Value, Value], Value]] = {
    "add": _sum,
    "mul": _product,
    "div": _quotient,
}
