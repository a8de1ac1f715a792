"""What the modules of `generated` share: the list of them, and the code beside the kernels."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from pathlib import Path

RUNTIME = Path(__file__).with_name("runtime.py")
LIST, CODE = "__init__.py", "_runtime.py"
"""Names of the two files."""


def shared_files(titles: Mapping[str, str]) -> dict[str, str]:
    """Text of both files by name; `titles` of all modules are by module name."""
    return {LIST: _list(titles), CODE: runtime_source()}


def runtime_source() -> str:
    """The text of the module that the kernels share, the same whatever the platform's newline."""
    return RUNTIME.read_text(encoding="utf-8")


def _list(titles: Mapping[str, str]) -> str:
    lines = [
        '"""Kernels that need NumPy only, printed from derivations with proved error bounds.',
        "",
    ]
    for line in sorted(f"`{name}`: {title}" for name, title in titles.items()):
        lines += textwrap.wrap(f"- {line}", 96, subsequent_indent="  ")
    return "\n".join([*lines, '"""']) + "\n"
