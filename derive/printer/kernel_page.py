"""The kernels of a module as Markdown, for people who look a function up."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gainproof.derive.printer.bound import KernelBound, OutputBound
from gainproof.derive.printer.docstring import (
    assumption,
    cancellation_texts,
    decimal_text,
    losses_of,
    number_text,
    required_text,
    rounded_up,
    scale_text,
    wanted_text,
)
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.kernel import Kernel, Output
from gainproof.derive.printer.lost_digits_text import loss_text


def kernel_page(kernel: Kernel, bounds: Sequence[KernelBound]) -> str:
    """One kernel: formulas, inputs with their domains, outputs with their proved bounds."""
    return "\n".join(_lines(kernel, bounds)) + "\n"


def _lines(kernel: Kernel, bounds: Sequence[KernelBound]) -> Iterator[str]:
    inputs = ", ".join(given.name for given in kernel.inputs)
    yield from (f"### {kernel.name}", "", kernel.summary, "", "```python")
    yield f"{', '.join(output.name for output in kernel.outputs)} = {kernel.name}({inputs})"
    yield from ("```", "", "```text", *kernel.equations, "```", "")
    yield from ("| input | meaning | domain |", "|---|---|---|")
    for given in kernel.inputs:
        yield f"| `{given.name}` | {_cell(given.meaning)} | {wanted_text(given)} |"
    yield ""
    for required in kernel.requirements:
        yield f"The {required.meaning}, of the inputs together, must be {required_text(required)}."
        yield ""
    yield f"| output | meaning | {' | '.join(f'error, {bound.format.name}' for bound in bounds)} |"
    yield f"|---|---|{'---|' * len(bounds)}"
    for row, output in enumerate(kernel.outputs):
        cells = [_bound(kernel, output, bound.outputs[row], bound.format) for bound in bounds]
        yield f"| `{output.name}` | {_cell(output.meaning)} | {' | '.join(cells)} |"
    yield ""
    for row, output in enumerate(kernel.outputs):
        said = list(cancellation_texts(kernel, bounds, row))
        if losses := losses_of(bounds, row):
            said.append(loss_text(losses))
        if said:
            yield f"`{output.name}`: {' '.join(said)}"
            yield ""
    yield f"Source: {kernel.source}"


def _bound(kernel: Kernel, output: Output, found: OutputBound, form: Format) -> str:
    """What is proved of an output in one format."""
    scale = " of its terms taken positive" if output.by_terms else ""
    if output.relative_to:
        scale = f" of {scale_text(output)}"
    text = f"{decimal_text(found)} * 2^{1 - form.digits}{scale}"
    if found.beside:
        text += f", and {rounded_up(found.beside)} beside it"
    if len(kernel.inputs) == 1:
        low, high = (number_text(end, form) for end in (found.lowest, found.highest))
        text += f", from {low} to {high}"
    return text + assumption(kernel, output.name)


def _cell(text: str) -> str:
    return text.replace("|", r"\|")
