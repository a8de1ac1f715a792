"""The package needs NumPy; its tests mpmath and pytest besides."""

from __future__ import annotations

import ast
import sys
from pathlib import Path

import pytest

from gainproof.standalone.shipped._package import FOLDER, PACKAGE

FILES = [*sorted(PACKAGE.glob("*.py")), *sorted(FOLDER.glob("*.py"))]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_nothing_else_is_imported(path: Path) -> None:
    allowed = {"numpy", *(("mpmath", "pytest") if path.parent == FOLDER else ())}
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
        if isinstance(node, ast.ImportFrom) and node.level == 0:
            names = [node.module or ""]
        for name in names:
            top = name.partition(".")[0]
            assert top in allowed or top in sys.stdlib_module_names, name
