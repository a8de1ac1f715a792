"""What inputs must fulfil together, as the text of a module: a block function, and its entry."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from gainproof.derive.printer.arithmetic import Arithmetic, literal
from gainproof.derive.printer.constant import constant
from gainproof.derive.printer.docstring import required_text
from gainproof.derive.printer.formats import FORMATS
from gainproof.derive.printer.kernel import Kernel, Output, Requirement
from gainproof.derive.printer.layout import WIDTH


@dataclass(frozen=True)
class Printed:
    """The lines of the function that computes what is required, and of its entry."""

    function: tuple[str, ...]
    entry: tuple[str, ...]


def requirements(kernel: Kernel) -> list[Printed]:
    """Of each requirement of a kernel, in order."""
    return [_printed(kernel, each) for each in kernel.requirements]


def _printed(kernel: Kernel, required: Requirement) -> Printed:
    block = f"_{kernel.name}_{required.name}_block"
    arithmetic = Arithmetic(replace(kernel, outputs=(Output(required.name, required.meaning),)))
    return Printed(tuple(_function(block, arithmetic)), tuple(_entry(block, arithmetic, required)))


def _function(block: str, arithmetic: Arithmetic) -> Iterator[str]:
    work = "work" if arithmetic.work else "_work"
    single = "single" if arithmetic.uses_type else "_single"
    arguments = f"given: Arrays, out: Arrays, {work}: Arrays, {single}: bool"
    head = f"def {block}({arguments}) -> None:"
    yield from [head] if len(head) <= WIDTH else [f"def {block}(", f"    {arguments}", ") -> None:"]
    yield from (f"    {line}" for line in arithmetic.lines)


def _entry(block: str, arithmetic: Arithmetic, required: Requirement) -> Iterator[str]:
    double, single = (
        literal(constant(limit).nearest(form))
        for limit, form in zip((required.least, required.single), FORMATS, strict=True)
    )
    yield "Required("
    yield f'    "{required.meaning}",'
    yield f'    "{required_text(required)}",'
    yield f"    {double},"
    yield f"    {single},"
    yield f"    {arithmetic.work},"
    yield f"    {block},"
    yield "),"
