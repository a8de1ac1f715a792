"""Kernels from a page of text: what they compute, are called and say of themselves.

A page is one of `kernel_formulas` where a line `NAME_kernel = [...]` is a kernel, a row of the
names of its outputs. In the conditions of headings `plane` is 1 in the plane and 0 in space, and
`NAME_kernel` is 1 where that is made, else 0. What is a number is neither input nor output.

Below `### NAME`, or `### NAME (CLASS)` with the class of its result, stand what that kernel is and,
lines as they are printed, its equations; then what is its own in tables, and below other headings
what is so of all:

    | input | meaning | domain | in float32 |
    | output | meaning | error over | since |
    | required | meaning | at least | in float32 |

A kernel with a table of inputs of its own has these alone. A domain is `[1e-6, 2)`, an end
`infinity` or `2^-40`; `+-` before it is of magnitudes, `0 or` admits 0, `whole` wants whole
numbers. The error of an output is one over itself, its `terms` taken positive or another output
that is there; `since` says why it is a difference. An output of which nothing is said, but that
others are measured by, is no result. What a cell of its own leaves empty is as below other
headings; a row `| * | slope of the * |` says it of all outputs. Alternatives in braces make as many
rows: `| {x,y} | along {east,north} |` are two. `{name}` without a comma is a slot.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import product
from pathlib import Path

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.derivation import PageError
from gainproof.derive.pages.formula import Formula, FormulaError
from gainproof.derive.pages.kernel_formulas import (
    PLANE,
    ROW,
    SCALE,
    TURN,
    Section,
    Value,
    formulas_that_hold,
    kernel_values,
    place_of,
    read_page,
)
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node, symbols_of
from gainproof.derive.printer.kernel import Input, Kernel, Limit, Module, Output, Requirement

_GROUP = re.compile(r"\{([^{}]*,[^{}]*)\}")
_SLOT = re.compile(r"\{(\w+)\}")
_DOMAIN = re.compile(r"(0 or )?(\+-)?(whole )?([\[(])(\S+), (\S+)([\])])")
Inputs = Callable[[str], Mapping[str, str]]
"""The inputs of a kernel by what formulas call them, in the order of arguments."""


def page_graphs(page: Path, inputs: Inputs | None = None, named: str = "") -> dict[str, Graph]:
    """The graph of each kernel of a page by its name; first those in space.

    `inputs`: what a kernel may use, if not all that tables have; what it does not need is left out.
    `named`: a regular expression of what is named in graphs besides values of functions.
    Raises PageError for what is no formula, a name without one, a negative number that stands with
    a node, and a kernel without outputs.
    """
    sections, words = read_page(page), kernel_words(page)
    rows = dict.fromkeys(
        row for section in sections for row in section.formulas if row.endswith(ROW)
    )
    found: dict[str, Graph] = {}
    conditions = [str(each) for section in sections for each in section.conditions]
    for plane in (0, 1) if any("plane" in each for each in conditions) else (0,):
        for row in rows:
            numbers = {each: Fraction(each == row) for each in rows}
            numbers["plane"] = Fraction(plane)
            if row in formulas_that_hold(sections, numbers):
                kernel = row.removesuffix(ROW)
                name = f"{kernel}{PLANE * plane}"
                try:
                    given = inputs(kernel) if inputs else words.inputs(name)
                    graph = _graph(sections, row, numbers, given, named)
                    found[name] = _with_differences(graph, words.differences(name))
                except (ValueError, ArithmeticError) as error:
                    raise PageError(f"{place_of(page)}: {name}: {error}") from None
    for kernel in (row.removesuffix(ROW) for row in rows):
        if not {kernel, f"{kernel}{PLANE}"} & {*found}:
            raise PageError(f"{place_of(page)}: {kernel}{ROW} stands below another kernel's name")
    return found


Rows = Mapping[str, tuple[str, ...]]
"""Of a table: the cells beside each name."""


@dataclass(frozen=True)
class Told:
    """What stands below the heading of a kernel; tables by their kind."""

    result: str = ""
    summary: str = ""
    equations: tuple[str, ...] = ()
    tables: Mapping[str, Rows] = field(default_factory=dict)


@dataclass(frozen=True)
class KernelWords:
    """What a page says: by kernel, and in tables of all."""

    place: str
    own: Mapping[str, Told]
    general: Mapping[str, Rows]

    def of(self, kernel: str) -> Told:
        """What is said of a kernel; in the plane, if nothing is, what is said of that in space.

        Raises PageError where nothing is said.
        """
        own, base = (self.own.get(name) for name in (kernel, kernel.removesuffix(PLANE)))
        if own is None and base is not None:
            own = replace(base, summary=base.summary.replace(".", " in the plane."))
        if own is None:
            raise PageError(
                f"{self.place}: wanted a heading `### {kernel}`, below it a paragraph that says "
                "what the kernel is and one with its equations"
            )
        return replace(own, tables=self.tables(kernel))

    def tables(self, kernel: str) -> Mapping[str, Rows]:
        """The tables of a kernel's own; of one in the plane those in space where it has none."""
        names = kernel.removesuffix(PLANE), kernel
        return {k: rows for x in names for k, rows in self.own.get(x, Told()).tables.items()}

    def row(self, kernel: str, kind: str, name: str) -> tuple[str, ...]:
        """The cells beside a name, own ones first. Raises PageError for a name without a row."""
        own, general = self.tables(kernel).get(kind, {}).get(name), self.general.get(kind, {})
        if own is None and name not in general:
            raise PageError(f"{self.place}: {kernel}: {kind} {name!r} has no row in a table")
        pairs = zip(own or general[name], general.get(name, own or ()), strict=True)
        meaning, *others = (first or second for first, second in pairs)
        whole = self.tables(kernel).get(kind, {}).get("*")
        if whole and not (own and own[0]):
            meaning = whole[0].replace("*", meaning)
        return (meaning, *others)

    def differences(self, kernel: str) -> list[str]:
        """Outputs that are said to be differences."""
        rows = {**self.general.get("output", {}), **self.tables(kernel).get("output", {})}
        return [name for name in rows if self.row(kernel, "output", name)[-1]]

    def inputs(self, kernel: str) -> Mapping[str, str]:
        """The names of what may be inputs, in the order of tables."""
        return {
            name: name for name in self.tables(kernel).get("input") or self.general.get("input", {})
        }


def kernel_words(page: Path, slots: Mapping[str, str] | None = None) -> KernelWords:
    """What a page says of its kernels. Raises PageError for a slot without a value, and for a table
    of another kind.
    """
    place = place_of(page)
    own: dict[str, Told] = {}
    rows: dict[str, dict[str, tuple[str, ...]]] = {}
    for part in re.split(r"^(?=#)", page.read_text(encoding="utf-8"), flags=re.MULTILINE):
        head, _, body = part.partition("\n")
        found = [each for each in body.split("\n\n") if each.strip()]
        tables = [each for each in found if each.lstrip().startswith("|")]
        match = re.fullmatch(r"### (\w+)(?: \((\w+)\))?", head)
        kernel, result = match.groups("") if match else ("", "")
        kept = {} if kernel else rows
        for table in tables:
            _read_table(place, table, slots or {}, kept)
        if kernel:
            words = [_filled(place, each, slots or {}) for each in found if each not in tables]
            summary, equations = (*words, "", "")[:2]
            lines = tuple(equations.strip("\n").splitlines())
            own[kernel] = Told(result, " ".join(summary.split()), lines, kept)
    return KernelWords(place, own, rows)


def _filled(place: str, text: str, slots: Mapping[str, str]) -> str:
    for name in _SLOT.findall(text):
        if name not in slots:
            raise PageError(f"{place}: {{{name}}} is no slot here")
    return _SLOT.sub(lambda match: slots[match[1]], text)


def _read_table(
    place: str, table: str, slots: Mapping[str, str], found: dict[str, dict[str, tuple[str, ...]]]
) -> None:
    head, _, *lines = table.strip("\n").splitlines()
    kind, *columns = _cells(head)
    if (kind, tuple(columns)) not in _TABLES.items():
        raise PageError(f"{place}: a table with the head {head!r} is none of kernels")
    for line in lines:
        for row in _alternatives(line):
            name, *cells = _cells(_filled(place, row, slots))
            if len(cells) != len(columns):
                raise PageError(f"{place}: {len(columns) + 1} cells are wanted in {line!r}")
            found.setdefault(kind, {})[name] = tuple(cells)


_TABLES = {
    "input": ("meaning", "domain", "in float32"),
    "output": ("meaning", "error over", "since"),
    "required": ("meaning", "at least", "in float32"),
}


def _cells(line: str) -> list[str]:
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def _alternatives(row: str) -> Iterator[str]:
    """The rows that one stands for; braces with as many alternatives go together."""
    groups = [match[1].split(",") for match in _GROUP.finditer(row)]
    counts = list(dict.fromkeys(map(len, groups)))
    for places in product(*map(range, counts)):
        chosen = iter([each[places[counts.index(len(each))]] for each in groups])
        yield _GROUP.sub(lambda _, left=chosen: next(left), row)  # type: ignore[misc]


def page_module(
    page: Path,
    graphs: Mapping[str, Graph],
    name: str,
    title: str,
    slots: Mapping[str, str] | None = None,
) -> Module:
    """The module of the subject `name` with the kernels of graphs as the page tells of them.

    Raises PageError for a kernel, an input or output of which it says nothing.
    """
    return catalogue_module(name, title, page_kernels(page, graphs, name, slots))


def page_kernels(
    page: Path, graphs: Mapping[str, Graph], subject: str, slots: Mapping[str, str] | None = None
) -> list[Kernel]:
    """The kernels of graphs as the page tells of them. Raises PageError as `page_module` does."""
    words = kernel_words(page, slots)
    return [_kernel(words, kernel, graph, subject) for kernel, graph in graphs.items()]


def _kernel(words: KernelWords, name: str, graph: Graph, source: str) -> Kernel:
    said = words.of(name)
    required = said.tables.get("required") or words.general.get("required", {})
    own = said.tables.get("output", {})
    rows = {**words.general.get("output", {}), **own}
    scales = {over for _, over, _ in rows.values()} - {*rows}
    shown = [
        each
        for each in graph["outputs"]
        if not (each.endswith(SCALE) or each in scales or (each in required and each not in own))
    ]
    cells = {each: words.row(name, "output", each) for each in shown}
    given = {each: words.row(name, "input", each) for each in symbols_of(graph)}
    given = {each: given[each] for each in words.inputs(name) if each in given}
    named = graph.get("names", {})
    return Kernel(
        name=name,
        result=said.result or "".join(word.capitalize() for word in name.split("_")),
        summary=said.summary,
        equations=said.equations,
        inputs=tuple(_input(words, each, cells) for each, cells in given.items()),
        outputs=tuple(
            Output(each, meaning, over if over in graph["outputs"] else None, over == "terms")
            for each, (meaning, over, _) in cells.items()
        ),
        graph=graph,
        source=f"derivation {source}",
        cancellations={
            name: reason
            for each, (*_, reason) in cells.items()
            for name in (difference(each), f"{each}{TURN}")
            if name in named
        },
        requirements=tuple(
            Requirement(each, *row) for each, row in required.items() if each in graph["outputs"]
        ),
    )


def difference(output: str) -> str:
    """The name of the subtraction of computed values that gives an output."""
    return f"{output}_difference"


def _input(words: KernelWords, name: str, cells: tuple[str, ...]) -> Input:
    meaning, domain, single = cells
    ends, others = _DOMAIN.fullmatch(domain), _DOMAIN.fullmatch(single or domain)
    if ends is None or others is None:
        raise PageError(f"{words.place}: input {name!r}: a domain such as [1e-6, 2) is wanted")
    zero, signed, whole, start, low, high, end = ends.groups()
    return Input(
        name,
        meaning,
        _limit(low),
        None if high == "infinity" else _limit(high),
        start == "(",
        end == ")",
        bool(whole),
        (_limit(others[5]), _limit(others[6])) if single else None,
        bool(zero or signed),
        bool(signed),
    )


def _limit(text: str) -> Limit:
    """A number of a domain, a power of 2 as one."""
    match = re.fullmatch(r"2\^(-?)(\d+)", text)
    if match is None:
        return text
    return Fraction(1, 2 ** int(match[2])) if match[1] else 2 ** int(match[2])


def _with_differences(graph: Graph, names: Iterable[str]) -> Graph:
    """With the names of outputs that are sums of a node and another's negative."""
    nodes, found = graph["nodes"], dict(graph.get("names", {}))
    for name in names:
        end = graph["outputs"].get(name)
        if end is not None and nodes[end][0] == "add" and nodes[int(nodes[end][2])][0] == "neg":
            found[difference(name)] = end
    return {**graph, "names": found} if found else graph


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
        if name in nodes
        and (
            (formulas[name].kind == "call" and formulas[name].text != "unknown")
            or re.fullmatch(named, name)
        )
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
