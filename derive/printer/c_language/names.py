"""What the C functions of one kernel are called, and the constants that they return."""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.derive.printer.c_language.real_types import Flavour, arguments
from gainproof.derive.printer.kernel import Kernel


@dataclass(frozen=True)
class Names:
    """What a kernel's functions are called: `stem` with the endings of type and entry."""

    stem: str
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]

    def function(self, flavour: Flavour, entry: str = "") -> str:
        return f"{self.stem}{entry}{flavour.ending}"

    def code(self, name: str) -> str:
        """The constant that says that an input, or what is required of all, is not as wanted."""
        return f"{self.stem}_refuses_{name}".upper()


def names_of(module: str, kernel: Kernel) -> Names:
    """All names of a kernel of a module."""
    inputs, outputs = arguments(kernel)
    return Names(f"{module}_{kernel.name}", tuple(inputs), tuple(outputs))


def codes(kernel: Kernel, names: Names) -> list[str]:
    """The constants of a kernel, in order from 1 on."""
    checked = [each.name for each in kernel.inputs] + [each.name for each in kernel.requirements]
    return [names.code(name) for name in checked]
