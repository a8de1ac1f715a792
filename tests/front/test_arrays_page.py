"""The page on arrays of other libraries: its blocks run where the library is installed."""

from __future__ import annotations

import doctest
import re
import sys
from pathlib import Path
from typing import Any

import pytest

from gainproof import cli

PAGE = Path(__file__).resolve().parents[2] / "docs" / "arrays.md"
LIBRARIES = {"JAX": "jax", "The array API standard": "array_api_strict"}


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder in which the page's command has put its package."""
    text = PAGE.read_text(encoding="utf-8")
    (line,) = re.findall(r"^\$ gainproof (generate [^|]*) \|", text, flags=re.MULTILINE)
    folder = tmp_path_factory.mktemp("page") / "filters"
    assert cli.main([str(folder) if word == "filters" else word for word in line.split()]) == 0
    return folder.parent


@pytest.mark.parametrize("section", LIBRARIES)
def test_examples(section: str, package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    library = pytest.importorskip(LIBRARIES[section])
    monkeypatch.syspath_prepend(package)
    text = PAGE.read_text(encoding="utf-8").partition(f"\n## {section}\n")[2].partition("\n## ")[0]
    (block,) = re.findall(r"^```pycon\n(.*?)^```$", text, flags=re.MULTILINE | re.DOTALL)
    names: dict[str, Any] = {}
    example = doctest.DocTestParser().get_doctest(block, names, section, str(PAGE), 0)
    told: list[str] = []
    outcome = doctest.DocTestRunner(verbose=False).run(example, out=told.append)
    if section == "JAX":
        library.config.update("jax_enable_x64", False)
    for name in [each for each in sys.modules if each.partition(".")[0] == "filters"]:
        monkeypatch.delitem(sys.modules, name)
    assert outcome.attempted
    assert not outcome.failed, "".join(told)
