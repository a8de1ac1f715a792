"""Who may import whom: the table of arrows, held against the syntax tree of every file of ours."""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from gainproof.derive.catalogue import CATALOGUE

ROOT = Path(__file__).resolve().parents[2]
TOP_LEVEL = ("derive", "generated", "verify")


@dataclass(frozen=True)
class Border:
    """What the files under `folder` may import: `ours` by prefix, `others` by top-level name.

    `others` = None allows every third-party package but those in `never`.
    """

    folder: str
    ours: tuple[str, ...]
    others: frozenset[str] | None = None
    never: frozenset[str] = frozenset()


# The longest matching folder decides.
ARROWS = (
    Border("derive", ("gainproof.derive",), frozenset({"sympy", "mpmath", "numpy"})),
    # common factors of polynomials: SymPy's own took a sixth of all derivations
    Border(
        "derive/algebra/common_factor.py",
        ("gainproof.derive",),
        frozenset({"sympy", "mpmath", "numpy", "flint"}),
    ),
    # the printer works on plain graphs: no computer algebra behind a printed number
    Border("derive/printer", ("gainproof.derive",), frozenset({"numpy", "mpmath", "flint"})),
    # copied into generated/: it may lean on NumPy alone
    Border("derive/printer/shipped", ("gainproof.derive.printer.shipped",), frozenset({"numpy"})),
    Border(
        "generated",
        tuple(
            f"gainproof.generated.{name}"
            for name in (
                *("_bits", "_blocks", "_double_word", "_guards", "_inputs", "_numbers"),
                *("_outputs", "_result", "_runtime", "_signature", "_threads"),
                "_two_state_results",
            )
        ),
        frozenset({"numpy"}),
    ),
    Border("verify", ("gainproof.verify",), frozenset({"flint", "lark", "mpmath"})),
    Border(
        "verify/oracles",
        ("gainproof.verify.oracles",),
        frozenset({"numpy", "mpmath", "flint", "scipy"}),
    ),
    Border("src/gainproof", ("gainproof",), None, frozenset({"sympy"})),
    # measures SymPy's lambdify and SciPy's solver beside our kernels
    Border("src/gainproof/bench", ("gainproof",), None),
    Border("tests", ("gainproof",), None),
)


AT_RUN_TIME = ("src/gainproof", "tests", "derive/catalogue.py")
"""Where the name of a module may be computed: the catalogue has those of its subjects as text."""


def border_of(path: str) -> Border:
    matching = [b for b in ARROWS if path == b.folder or path.startswith(b.folder + "/")]
    if not matching:
        raise LookupError(f"no border is stated for {path}; add its folder to ARROWS")
    return max(matching, key=lambda border: len(border.folder))


def statements(tree: ast.AST) -> Iterator[ast.AST]:
    """All of a tree but expressions, which hold most of it and no import that is not a call."""
    waiting = [tree]
    while waiting:
        node = waiting.pop()
        yield node
        inner = ast.iter_child_nodes(node)
        waiting += (each for each in inner if not isinstance(each, ast.expr))


def imported_names(source: str) -> list[tuple[int, str]]:
    """Line and dotted name of every import, wherever it stands; a relative one starts with a dot.

    `import_module` and `__import__` with a literal argument count; without one they come as `?`.
    """
    found: list[tuple[int, str]] = []
    calls = "import_module" in source or "__import__" in source
    for node in (ast.walk if calls else statements)(ast.parse(source)):
        if isinstance(node, ast.Import):
            found += [(node.lineno, alias.name) for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            stem = "." * node.level + (node.module or "")
            # `from gainproof import derive` names gainproof.derive; `from x.y import z` may too
            ours = stem == "gainproof" or stem.startswith("gainproof.")
            names = [f"{stem}.{alias.name}" for alias in node.names] if ours else [stem]
            found += [(node.lineno, name) for name in names]
        elif isinstance(node, ast.Call):
            named = node.func
            function = named.attr if isinstance(named, ast.Attribute) else getattr(named, "id", "")
            if function in {"import_module", "__import__"}:
                first = node.args[0] if node.args else None
                literal = first.value if isinstance(first, ast.Constant) else "?"
                found.append((node.lineno, str(literal)))
    return found


def standard(name: str) -> bool:
    return name in sys.stdlib_module_names


def violations(path: str, source: str) -> list[str]:
    border = border_of(path)
    found = []
    for line, name in imported_names(source):
        top = name.split(".")[0]
        place = f"{path}:{line}: import of {name}"
        if name.startswith("."):
            found.append(f"{place}: relative; write the whole name")
        elif name == "?":
            if not path.startswith(AT_RUN_TIME):
                found.append(f"{place}: computed at run time, cannot be judged")
        elif top in TOP_LEVEL:
            found.append(f"{place}: a second copy of gainproof.{top}")
        elif top == "gainproof":
            if not any(name == p or name.startswith(p + ".") for p in border.ours):
                found.append(f"{place}: {border.folder} may import of ours only {border.ours}")
        elif not standard(top):
            allowed = top not in border.never if border.others is None else top in border.others
            if not allowed:
                found.append(f"{place}: not among what {border.folder} may import")
    return found


def our_files() -> list[Path]:
    found = []
    for folder in ("derive", "generated", "verify", "tests", "src/gainproof"):
        for path in sorted((ROOT / folder).rglob("*.py")):
            inner = path.relative_to(ROOT)
            if not any((ROOT / parent).is_symlink() for parent in inner.parents):
                found.append(inner)
    return found


def test_the_modules_of_the_catalogue_are_derivations() -> None:
    assert all(entry.module.startswith("gainproof.derive.") for entry in CATALOGUE)


def test_no_arrow_is_crossed() -> None:
    found = [
        text
        for path in our_files()
        for text in violations(path.as_posix(), (ROOT / path).read_text(encoding="utf-8"))
    ]
    assert not found, "\n" + "\n".join(found)


def test_every_folder_is_walked_once() -> None:
    files = our_files()
    assert len(files) == len(set(files))
    assert {path.parts[0] for path in files} >= {"derive", "verify", "tests", "src"}


@pytest.mark.parametrize(
    ("path", "source"),
    [
        ("derive/families/x.py", "from gainproof.verify import certificate"),
        ("derive/families/x.py", "def f():\n    import gainproof.generated._runtime"),
        ("derive/families/x.py", "from gainproof import verify"),
        ("derive/families/x.py", "import scipy"),
        ("derive/printer/x.py", "import sympy"),
        ("derive/printer/shipped/x.py", "from gainproof.derive.printer.graph import GraphBuilder"),
        ("generated/x.py", "import mpmath"),
        ("generated/x.py", "from gainproof.generated import random_velocity"),
        ("generated/x.py", "from gainproof.generated._runtimes import x"),
        ("verify/certificate.py", "import sympy"),
        ("verify/certificate.py", "if True:\n    from sympy.polys import Poly"),
        ("verify/certificate.py", "import importlib\nimportlib.import_module('sympy')"),
        ("verify/certificate.py", "__import__('sym' + 'py')"),
        ("verify/certificate.py", "from gainproof.derive.model import Model"),
        ("verify/certificate.py", "import gainproof"),
        ("verify/oracles/x.py", "from gainproof.verify.certificate import check"),
        ("verify/oracles/x.py", "from gainproof.generated.random_velocity import gains"),
        ("src/gainproof/commands/x.py", "import sympy"),
        ("src/gainproof/x.py", "from derive.model import Model"),
        ("tests/front/x.py", "import generated"),
        ("tests/front/x.py", "from .y import z"),
        ("derive/x.py", "from . import model"),
    ],
)
def test_a_crossed_arrow_is_seen(path: str, source: str) -> None:
    assert violations(path, source)


@pytest.mark.parametrize(
    ("path", "source"),
    [
        ("derive/families/x.py", "import sympy as sp\nfrom gainproof.derive.model import Model"),
        ("generated/x.py", "import numpy as np\nfrom gainproof.generated._runtime import evaluate"),
        ("generated/x.py", "from gainproof.generated import _runtime"),
        ("verify/oracles/x.py", "import mpmath\nfrom gainproof.verify.oracles.doubling import run"),
        ("verify/judge/x.py", "from fractions import Fraction\nimport flint"),
        ("src/gainproof/x.py", "from gainproof.derive.catalogue import CATALOGUE"),
        ("tests/derive/x.py", "import sympy, pytest, scipy.linalg"),
    ],
)
def test_an_allowed_import_passes(path: str, source: str) -> None:
    assert violations(path, source) == []


def test_a_file_without_a_border_is_an_error() -> None:
    with pytest.raises(LookupError, match="add its folder"):
        border_of("elsewhere/x.py")
