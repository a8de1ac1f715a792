"""What lies in a package of its own, by file name: pure, nothing is written here."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from gainproof.derive.printer.package import beside
from gainproof.standalone.licence import LICENCE
from gainproof.standalone.readme import readme
from gainproof.subjects.generated_files import together

SHIPPED = Path(__file__).with_name("shipped")
IN_C = Path(__file__).with_name("in_c")
COMPILING = ("_compiled.py", "compile.py")
TEST_OF_C = "test_c.py"
HERE = "from gainproof.standalone."
EVALUATES = "from gainproof.generated._runtime import evaluate\n"


def package_files(parts: Sequence[Mapping[str, Any]], name: str, command: str) -> dict[str, bytes]:
    """Everything but the record, from what each subject gives; `name` is the package's.

    Raises ValueError for a file of several subjects who do not agree on it.
    """
    titles = {str(part["module"]): str(part["title"]) for part in parts}
    in_c = any(name.startswith("c/") for part in parts for name in part["files"])
    texts = {name: content.decode("utf-8") for name, content in together(parts).items()}
    if in_c:
        texts |= {f"{title}.py": _computing_in_c(texts[f"{title}.py"]) for title in titles}
        texts |= {name: shipped(IN_C / name) for name in COMPILING}
    texts |= {
        **{f"tests/{path.name}": shipped(path) for path in _tests(in_c)},
        "README.md": readme(name, titles, command, in_c=in_c),
        "LICENSE": LICENCE,
        "py.typed": "",
    }
    placed = {n: beside(text) if n.endswith(".py") else text for n, text in texts.items()}
    return {name: text.encode("utf-8") for name, text in placed.items()}


def _tests(in_c: bool) -> list[Path]:
    """The tests of what there is."""
    return [path for path in sorted(SHIPPED.glob("*.py")) if in_c or path.name != TEST_OF_C]


def _computing_in_c(text: str) -> str:
    """A module whose kernels compute in C where that is compiled."""
    if EVALUATES not in text:
        raise ValueError("a module that does not evaluate its kernels by the shared runtime")
    return text.replace(EVALUATES, EVALUATES.replace("_runtime", "_compiled"))


def shipped(path: Path) -> str:
    """A file as it lies in a package, the same whatever the platform's newline."""
    text = path.read_text(encoding="utf-8")
    return text.replace(f"{HERE}{path.parent.name}.", "from .")
