"""What lies in a package of its own, by file name: pure, nothing is written here."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from gainproof.derive.printer.package import beside
from gainproof.generated_files import together
from gainproof.standalone.licence import LICENCE
from gainproof.standalone.readme import readme

SHIPPED = Path(__file__).with_name("shipped")
IN_C = "test_c.py"
HERE = "from gainproof.standalone.shipped."


def package_files(parts: Sequence[Mapping[str, Any]], name: str, command: str) -> dict[str, bytes]:
    """Everything but the record, from what each subject gives; `name` is the package's.

    Raises ValueError for a file of several subjects who do not agree on it.
    """
    titles = {str(part["module"]): str(part["title"]) for part in parts}
    texts = {
        **{name: content.decode("utf-8") for name, content in together(parts).items()},
        **{f"tests/{path.name}": shipped(path) for path in _tests(parts)},
        "README.md": readme(name, titles, command),
        "LICENSE": LICENCE,
        "py.typed": "",
    }
    placed = {n: beside(text) if n.endswith(".py") else text for n, text in texts.items()}
    return {name: text.encode("utf-8") for name, text in placed.items()}


def _tests(parts: Sequence[Mapping[str, Any]]) -> list[Path]:
    """The tests of what there is."""
    in_c = any(name.startswith("c/") for part in parts for name in part["files"])
    return [path for path in sorted(SHIPPED.glob("*.py")) if in_c or path.name != IN_C]


def shipped(path: Path) -> str:
    """A test as it lies in a package, the same whatever the platform's newline."""
    return path.read_text(encoding="utf-8").replace(HERE, "from .")
