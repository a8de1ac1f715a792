"""What the tests read: values and certificates, by module, and the functions of these modules."""

from __future__ import annotations

import importlib
import json
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

FOLDER = Path(__file__).resolve().parent
PACKAGE = FOLDER.parent

VALUES: dict[str, dict[str, Any]] = {
    path.stem.removeprefix("values_"): json.loads(path.read_text(encoding="utf-8"))
    for path in sorted(FOLDER.glob("values_*.json"))
}
"""Of each module, of each of its kernels: inputs, outputs with their bounds, points."""
FORMATS = tuple(
    form
    for form in ("float64", "float32")
    if any(form in each["points"] for kernels in VALUES.values() for each in kernels.values())
)
"""Those that this package has, one or both."""
KERNELS = [(module, kernel) for module, kernels in VALUES.items() for kernel in kernels]
CASES = [(module, kernel, form) for module, kernel in KERNELS for form in FORMATS]


def function(module: str, kernel: str) -> Callable[..., Any]:
    """A kernel of the package that these tests lie in."""
    found: Callable[..., Any] = getattr(imported(f"..{module}"), kernel)
    return found


def formulas() -> list[tuple[str, str, Callable[..., Any]]]:
    """Modules, kernels, and what they are over intervals, where a formula of theirs is known."""
    found = []
    for path in sorted(FOLDER.glob("formulas_*.py")):
        known = vars(imported(f".{path.stem}"))
        module = path.stem.removeprefix("formulas_")
        found += [(module, kernel, known[kernel]) for kernel in VALUES[module] if kernel in known]
    return found


def imported(name: str) -> ModuleType:
    """A module by its place from here on."""
    return importlib.import_module(name, __name__.rpartition(".")[0])


def certificate(module: str) -> dict[str, Any]:
    """The certificate of a module."""
    found: dict[str, Any] = json.loads((PACKAGE / f"{module}.json").read_text(encoding="utf-8"))
    return found
