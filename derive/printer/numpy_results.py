"""The classes of results of NumPy kernels, in their module or in a file for several modules."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence

from gainproof.derive.printer.kernel import Kernel, Module
from gainproof.derive.printer.layout import WIDTH

NAMED = ("else:", "    from gainproof.generated._result import NamedTuple")
"""Results are what type checkers know well; when kernels are imported, what is made fast."""


def results_source(module: Module) -> str:
    """The text of the file that holds the classes of a module's results."""
    lines = [
        "# Made by: gainproof generate",
        '"""Results of kernels, the same for several modules."""',
        "",
        "from __future__ import annotations",
        "",
        "from typing import TYPE_CHECKING",
        "",
        "if TYPE_CHECKING:",
        "    from typing import NamedTuple",
        "",
        "    from gainproof.generated._signature import Real",
        *NAMED,
    ]
    for kernel in module.kernels:
        lines += ["", "", *result_class(kernel)]
    return "\n".join(lines) + "\n"


def imported_results(module: str, names: Sequence[str]) -> list[str]:
    """The import of classes from the file that holds them for several modules."""
    return [
        f"from gainproof.generated.{module} import (",
        *(f"    {name}," for name in sorted(names, key=str.lower)),
        ")",
    ]


def result_class(kernel: Kernel) -> Iterator[str]:
    """The class of a kernel's result."""
    yield f"class {kernel.result}(NamedTuple):"
    yield f'    """Result of `{kernel.name}`."""'
    yield ""
    for output in kernel.outputs:
        yield f"    {output.name}: Real"
        text = f'"""{output.meaning[:1].upper()}{output.meaning[1:]}."""'
        yield from (f"    {line}" for line in textwrap.wrap(text, WIDTH - 4))
