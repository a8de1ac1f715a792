"""What the modules of `generated` share: the list of them, and the code beside the kernels."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from pathlib import Path

SHIPPED = Path(__file__).with_name("shipped")
PLACE, HERE = "gainproof.generated", "gainproof.derive.printer.shipped"
"""The package in which the kernels lie, and the one in which what they share is kept."""
LIST = "__init__.py"
CODE = (
    "_bits.py",
    "_blocks.py",
    "_double_word.py",
    "_guards.py",
    "_inputs.py",
    "_numbers.py",
    "_outputs.py",
    "_result.py",
    "_runtime.py",
    "_signature.py",
    "_threads.py",
)
"""Names of the files."""


def shared_files(titles: Mapping[str, str]) -> dict[str, str]:
    """Text of the files by name; `titles` of all modules are by module name."""
    return {LIST: _list(titles), **{name: code_source(name) for name in CODE}}


def code_source(name: str) -> str:
    """The text of a file that the kernels share, the same whatever the platform's newline; it
    differs from that in `shipped` by the package alone.
    """
    return (SHIPPED / name).read_text(encoding="utf-8").replace(HERE, PLACE)


def beside(text: str) -> str:
    """A file of `generated` for a package of its own: what it imports of ours lies beside it."""
    return text.replace(f"from {PLACE}.", "from .")


def _list(titles: Mapping[str, str]) -> str:
    lines = [
        '"""Kernels that need NumPy only, printed from derivations with proved error bounds.',
        "",
    ]
    for line in sorted(f"`{name}`: {title}" for name, title in titles.items()):
        lines += textwrap.wrap(f"- {line}", 96, subsequent_indent="  ")
    return "\n".join([*lines, '"""']) + "\n"
