"""Everything that lies in `generated`, as bytes: pure, nothing is written here."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from gainproof.derive.printer.canonical_json import canonical_json
from gainproof.derive.printer.kernel import Module
from gainproof.derive.printer.numpy_source import module_source, results_source

RUNTIME = Path(__file__).with_name("runtime.py")


def all_files(
    modules: Sequence[Module], certificates: Mapping[str, Mapping[str, Any]]
) -> dict[str, bytes]:
    """Content by file name: `__init__.py`, `_runtime.py`, modules, certificates, shared results.

    `certificates` are by module name. KeyError for a module without one, ValueError for two
    modules of one name, a certificate of no module, or modules that share a file of results and
    differ in them; PrintingError where a bound is not proved.
    """
    names = [module.name for module in modules]
    if len(set(names)) < len(names) or set(certificates) - set(names):
        raise ValueError(f"modules {sorted(names)} and certificates {sorted(certificates)} differ")
    files = {"__init__.py": _package(modules), "_runtime.py": runtime_source()}
    for module in sorted(modules, key=lambda module: module.name):
        files[f"{module.name}.py"] = module_source(module)
        files[f"{module.name}.json"] = canonical_json(certificates[module.name])
        if module.results:
            results = results_source(module)
            if files.setdefault(f"{module.results}.py", results) != results:
                raise ValueError(
                    f"{module.name}: its results differ from those in {module.results}"
                )
    return {name: text.encode("utf-8") for name, text in files.items()}


def runtime_source() -> str:
    """The text of the module that the kernels share, the same whatever the platform's newline."""
    return RUNTIME.read_text(encoding="utf-8")


def _package(modules: Sequence[Module]) -> str:
    listed = [f"`{module.name}`: {module.title}" for module in modules]
    lines = [
        '"""Kernels that need NumPy only, printed from derivations with proved error bounds.',
        "",
    ]
    for line in sorted(listed):
        lines += textwrap.wrap(f"- {line}", 96, subsequent_indent="  ")
    return "\n".join([*lines, '"""']) + "\n"
