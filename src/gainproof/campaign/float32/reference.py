"""What a kernel is compared with: its graph as a C loop in double precision, and its bounds.

The loop rounds as the float64 kernel does (see `c_loop`), whose proved error is some units of
2^-52: a few 1e-9 of what float32 can tell. It rests on the same graph: it shows the rounding of the
float32 kernel, and not that the graph is right, which its certificate proves.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from gainproof.bad_input import BadInputError
from gainproof.bench.compiler import Loop, compiled, compiler
from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.c_language.loop import c_loop
from gainproof.derive.printer.formats import FLOAT32
from gainproof.derive.printer.kernel import Kernel, Output
from gainproof.derive.subject import Subject
from gainproof.deriving import build


@dataclass(frozen=True)
class Compared:
    """An output: the rows of its value and scale in what the loop gives; the error over the scale
    is at most `bound` * 2^-23 for inputs from `lowest` to `highest`.
    """

    name: str
    value: int
    scale: int
    bound: float
    lowest: float
    highest: float


@dataclass(frozen=True)
class Reference:
    """`loop` fills `rows` arrays of doubles from one."""

    loop: Loop
    rows: int
    outputs: tuple[Compared, ...]


@cache
def reference(module: str, name: str) -> Reference:
    """That of a kernel, derived and compiled on this machine.

    Raises BadInputError where there is no C compiler.
    """
    if compiler() is None:
        raise BadInputError("the sweep needs a C compiler: cc, gcc or clang")
    (kernel,) = (each for each in _subject(module).module.kernels if each.name == name)
    names = [output.name for output in kernel.outputs]
    scales = {output.relative_to for output in kernel.outputs if output.relative_to} - {*names}
    rows = [*names, *sorted(scales)]
    with TemporaryDirectory() as folder:
        loop = compiled(c_loop(_with(kernel, rows)), name, Path(folder))
    bounds = prove(kernel, FLOAT32).outputs
    outputs = tuple(
        Compared(
            output.name,
            rows.index(output.name),
            rows.index(output.relative_to or output.name),
            float(bound.bound),
            bound.lowest,
            bound.highest,
        )
        for output, bound in zip(kernel.outputs, bounds, strict=True)
    )
    return Reference(loop, len(rows), outputs)


def _with(kernel: Kernel, rows: list[str]) -> Kernel:
    """The kernel with these outputs of its graph."""
    return replace(kernel, outputs=tuple(Output(row, "") for row in rows))


@cache
def _subject(module: str) -> Subject:
    """A subject is called as its module, with hyphens."""
    return build(module.replace("_", "-"))
