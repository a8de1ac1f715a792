"""What inputs must fulfil together, as the text of a module: a block function, and its entry."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace

from gainproof.derive.printer.arithmetic import Arithmetic, literal
from gainproof.derive.printer.docstring import required_text
from gainproof.derive.printer.formats import FORMATS
from gainproof.derive.printer.graph import Graph, operands
from gainproof.derive.printer.kernel import Kernel, Output, Requirement, least_admitted


@dataclass(frozen=True)
class Printed:
    """The lines of the function of what is required, and of its entry; what it calls of NumPy."""

    function: tuple[str, ...]
    entry: tuple[str, ...]
    numpys: frozenset[str]


def requirements(kernel: Kernel, own: Collection[str] = ()) -> list[Printed]:
    """Of each requirement of a kernel, in order; `own` are the names of its module."""
    return [_printed(kernel, each, own) for each in kernel.requirements]


def _printed(kernel: Kernel, required: Requirement, own: Collection[str]) -> Printed:
    block = f"_{kernel.name}_{required.name}_block"
    outputs = (Output(required.name, required.meaning),)
    arithmetic = Arithmetic(replace(kernel, outputs=outputs), own)
    names = [each.name for each in kernel.inputs]
    leg = tuple(names.index(name) for name in first_leg(kernel.graph, required.name))
    return Printed(
        tuple(_function(block, arithmetic)),
        tuple(_entry(block, arithmetic, required, leg)),
        frozenset(arithmetic.numpys),
    )


def first_leg(graph: Graph, name: str) -> tuple[str, ...]:
    """Of an output that is the root of a sum of squares, the names of the two inputs whose
    difference is squared first, or none: the output is nowhere less than its magnitude.
    """
    nodes = graph["nodes"]
    root = nodes[graph["outputs"][name]]
    if root[0] != "pow" or root[2] != "1/2":
        return ()
    terms, squared = list(operands(root)), list[int]()
    while terms:
        node = nodes[terms.pop()]
        sides = operands(node)
        if node[0] == "add":
            terms += reversed(sides)
        elif node[0] == "mul" and len(sides) == 2 and sides[0] == sides[1]:
            squared.append(sides[0])
        else:
            return ()
    first = nodes[squared[0]]
    parts = [nodes[part] for part in operands(first)]
    signs = sorted(part[0] for part in parts)
    inner = [nodes[operands(part)[0]] if part[0] == "neg" else part for part in parts]
    difference = first[0] == "add" and signs == ["neg", "symbol"]
    if not difference or any(each[0] != "symbol" for each in inner):
        return ()
    return tuple(str(each[1]) for each in inner)


def _function(block: str, arithmetic: Arithmetic) -> Iterator[str]:
    yield from arithmetic.head(block)
    yield from (f"    {line}" for line in arithmetic.lines)


def _entry(
    block: str, arithmetic: Arithmetic, required: Requirement, leg: tuple[int, ...]
) -> Iterator[str]:
    double, single = (literal(least_admitted(required, form)) for form in FORMATS)
    yield "Required("
    yield f'    "{required.meaning}",'
    yield f'    "{required_text(required)}",'
    yield f"    {double},"
    yield f"    {single},"
    yield f"    {arithmetic.work},"
    yield f"    {block},"
    if leg:
        yield f"    {leg},"
    yield "),"
