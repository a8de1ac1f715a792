"""Graphs of a sensor's kernels, in space and in the plane, from the page of their formulas.

A page is one of `pages.kernel_formulas` where a line `NAME_kernel = [...]` is a kernel, a row of
the names of its outputs. In the conditions of headings `plane` is 1 in the plane and 0 in space,
and `NAME_kernel` is 1 where that is made, else 0. What is a number is neither input nor output.
Headings `### NAME` begin what is said of a kernel.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from pathlib import Path

from gainproof.derive.derivation import PageError
from gainproof.derive.pages.formula import Formula, FormulaError
from gainproof.derive.pages.kernel_formulas import (
    Section,
    Value,
    formulas_that_hold,
    kernel_values,
    place_of,
    read_page,
)
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node

ROW = "_kernel"
PLANE = "_in_plane"
"""The end of the names of kernels in the plane."""
_WORDS = re.compile(r"^### (\w+)\n\n((?:\S.*\n)+)\n((?:\S.*\n)+)", re.MULTILINE)
Words = tuple[str, tuple[str, ...]]
"""The summary of a kernel, and the lines of its equations as they are printed."""
Inputs = Callable[[str], Mapping[str, str]]
"""The inputs of a kernel by what formulas call them, in the order of arguments."""


def page_graphs(page: Path, inputs: Inputs, named: str = "") -> dict[str, Graph]:
    """The graph of each kernel of a page by its name; first those in space.

    `inputs`: what a kernel may use; what it does not need is left out. `named`: a regular
    expression of what is named in graphs besides values of functions.
    Raises PageError for what is no formula, a name without one, a negative number that stands with
    a node, and a kernel without outputs.
    """
    sections = read_page(page)
    rows = dict.fromkeys(
        row for section in sections for row in section.formulas if row.endswith(ROW)
    )
    found: dict[str, Graph] = {}
    for plane in (0, 1):
        for row in rows:
            numbers = {each: Fraction(each == row) for each in rows}
            numbers["plane"] = Fraction(plane)
            if row in formulas_that_hold(sections, numbers):
                kernel = row.removesuffix(ROW)
                name = f"{kernel}{PLANE * plane}"
                try:
                    found[name] = _graph(sections, row, numbers, inputs(kernel), named)
                except (ValueError, ArithmeticError) as error:
                    raise PageError(f"{place_of(page)}: {name}: {error}") from None
    return found


def kernel_words(page: Path, kernels: Iterable[str]) -> dict[str, Words]:
    """What a page says of kernels: the two paragraphs below `### NAME`.

    Raises PageError for a kernel without them.
    """
    found = {
        name: (" ".join(summary.split()), tuple(equations.splitlines()))
        for name, summary, equations in _WORDS.findall(page.read_text(encoding="utf-8"))
    }
    for name in kernels:
        if name not in found:
            raise PageError(
                f"{place_of(page)}: wanted a heading `### {name}`, below it a paragraph that says "
                "what the kernel is and one with its equations"
            )
    return found


def _graph(
    sections: Iterable[Section],
    row: str,
    numbers: Mapping[str, Value],
    inputs: Mapping[str, str],
    named: str,
) -> Graph:
    builder, known = GraphBuilder(), dict(numbers)
    formulas = formulas_that_hold(sections, known)
    for name, argument in inputs.items():
        if name not in formulas or formulas[name].kind != "number":
            known[name] = builder.symbol(argument)
    outputs = [part.text for part in formulas[row].parts]
    needed = _needed(outputs, formulas, known)
    # in the order of the page, which is that of the printed operations
    found = kernel_values(sections, known, [name for name in formulas if name in needed])
    nodes = {name: node for name, node in (known | found).items() if isinstance(node, Node)}
    names = {
        name: nodes[name]
        for name in found
        if name in nodes and (formulas[name].kind == "call" or re.fullmatch(named, name))
    }
    return builder.graph({name: nodes[name] for name in outputs if name in nodes}, names)


def _needed(
    names: Iterable[str], formulas: Mapping[str, Formula], known: Mapping[str, Value]
) -> set[str]:
    """The names of formulas that some names need, themselves too; FormulaError for an unknown."""
    found: set[str] = set()
    left = list(names)
    while left:
        name = left.pop()
        if name in known or name in found:
            continue
        if name not in formulas:
            raise FormulaError(f"{name!r} has no formula")
        found.add(name)
        left += _names_in(formulas[name])
    return found


def _names_in(formula: Formula) -> list[str]:
    if formula.kind == "name":
        return [formula.text]
    return [name for part in formula.parts for name in _names_in(part)]
