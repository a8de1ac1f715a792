"""A derivation as a notebook: sentences and formulas, and cells that have each step checked."""

from __future__ import annotations

import importlib
import inspect
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from gainproof.notebook.cells import Cell
from gainproof.notebook.markup import lines_of, markdown_escaped, model_lines, sentence
from gainproof.pages.lecture_items import Item, items, numbers
from gainproof.subjects.derived import Derived

_TRIED = ("0.5", "1.0", "2.0", "5.0")
"""Arguments that are tried, each for all inputs; a kernel that takes none of them is only named."""
_PLOT = """\
import numpy as np

try:
    import matplotlib.pyplot as plt
except ImportError:
    print("no picture: matplotlib is not installed")
else:
    {argument} = np.geomspace(0.01, 100.0, 200)
    for name, values in zip(
        {module}.{kernel}(1.0)._fields, {module}.{kernel}({argument}), strict=True
    ):
        plt.semilogx({argument}, values, label=name)
    plt.xlabel("{label}")
    plt.legend()
    plt.show()"""


def derivation_cells(derived: Derived, subject: str) -> list[Cell]:
    """The cells. `subject`: the name, or the model file, by which the notebook asks for it."""
    found = items(derived.steps)
    known = numbers(found)
    opening = sentence(derived.opening, derived.symbols, known, markdown_escaped)
    told = "The cells below each line ask the checker, which uses no computer algebra, anew."
    cells = [
        Cell("markdown", "\n\n".join([f"# {derived.title}", opening, told])),
        Cell(
            "code",
            f"import gainproof\n\nderivation = gainproof.derivation({subject!r})\n"
            "print(repr(derivation))",
        ),
    ]
    lead = model_lines(derived, markdown_escaped)
    if lead:
        cells.append(Cell("markdown", "\n\n".join(lead)))
    for item in found:
        cells += [_line(item, derived, known), _asked(item)]
    cells += [
        Cell("markdown", "## The certificate as a whole\n\nWith the steps that only repeat."),
        Cell(
            "code",
            "from collections import Counter\n\nmarks = derivation.check()\n"
            "assert marks.accepted and derivation.accepted\nCounter(marks.words.values())",
        ),
    ]
    return [*cells, *_kernels(derived)]


def _line(item: Item, derived: Derived, known: Mapping[str, int]) -> Cell:
    said, why = (
        sentence(text, derived.symbols, known, markdown_escaped)
        for text in (item.first.sentence, item.first.reason)
    )
    formulas = lines_of(item, derived.symbols, markdown_escaped)
    heading = [f"## {markdown_escaped(item.first.heading)}"] if item.first.heading else []
    parts = [*heading, f"**{item.number}.** {said}", *formulas, *([why] if why else [])]
    return Cell("markdown", "\n\n".join(parts))


def _asked(item: Item) -> Cell:
    ids = ", ".join(repr(step.id) for step in item.steps)
    if len(ids) > 70:
        ids = "\n    " + ",\n    ".join(repr(step.id) for step in item.steps) + ",\n"
    return Cell("code", f"derivation.check({ids})")


def _kernels(derived: Derived) -> list[Cell]:
    """Each kernel evaluated at a point that it takes, and one picture."""
    if not derived.kernels:
        return []
    modules = sorted({str(kernel["module"]) for kernel in derived.kernels})
    names = ", ".join(modules)
    cells = [
        Cell("markdown", "## Kernels\n\nPrinted from these formulas; NumPy only."),
        Cell("code", f"from gainproof.generated import {names}"),
    ]
    for kernel in derived.kernels:
        cells += _kernel(kernel)
    return [*cells, *_picture(derived.kernels)]


def _kernel(kernel: Mapping[str, Any]) -> list[Cell]:
    module, name = str(kernel["module"]), str(kernel["name"])
    words = Cell("markdown", f"`{module}.{name}`: {markdown_escaped(str(kernel['summary']))}")
    for text in _TRIED:
        count = len(_inputs(module, name))
        arguments = ", ".join([text] * count)
        try:
            _function(module, name)(*[float(text)] * count)
        except (ValueError, TypeError):
            continue
        return [words, Cell("code", f"{module}.{name}({arguments})")]
    return [words, Cell("code", f"print({module}.{name}.__doc__)")]


def _picture(kernels: Sequence[Mapping[str, Any]]) -> Iterator[Cell]:
    """The values of the first kernel of one input that takes all positive numbers."""
    for kernel in kernels:
        module, name = str(kernel["module"]), str(kernel["name"])
        inputs = _inputs(module, name)
        if len(inputs) != 1:
            continue
        try:
            ends = _function(module, name)([0.01, 100.0])
        except (ValueError, TypeError):
            continue
        if hasattr(ends, "_fields"):
            text = _PLOT.format(
                argument=inputs[0], module=module, kernel=name, label=inputs[0].replace("_", " ")
            )
            yield Cell("code", text)
            return


def _function(module: str, name: str) -> Any:
    return getattr(importlib.import_module(f"gainproof.generated.{module}"), name)


def _inputs(module: str, name: str) -> list[str]:
    """The inputs of a kernel; `out` and the like are keywords."""
    parameters = inspect.signature(_function(module, name)).parameters.values()
    return [each.name for each in parameters if each.kind is not each.KEYWORD_ONLY]
