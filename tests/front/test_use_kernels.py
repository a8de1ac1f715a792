"""The page on other libraries: its blocks run where the library of their section is installed."""

from __future__ import annotations

import doctest
import re
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

PAGE = Path(__file__).resolve().parents[2] / "docs" / "use-kernels.md"
LIBRARIES = {"FilterPy": "filterpy", "Stone Soup": "stonesoup", "python-control": "control"}


def sections() -> dict[str, str]:
    """The block of each section; that above the first is called "" and comes before each."""
    parts = re.split(r"^## (.*)$", PAGE.read_text(encoding="utf-8"), flags=re.MULTILINE)
    named = dict(zip(["", *parts[1::2]], parts[::2], strict=True))
    found = {}
    for name, text in named.items():
        (block,) = re.findall(r"^```pycon\n(.*?)^```$", text, flags=re.MULTILINE | re.DOTALL)
        found[name] = block
    return found


def run(text: str, name: str) -> None:
    """Run the examples; what is printed must be what is shown."""
    names: dict[str, Any] = {}
    example = doctest.DocTestParser().get_doctest(text, names, name, str(PAGE), 0)
    told: list[str] = []
    outcome = doctest.DocTestRunner(verbose=False).run(example, out=told.append)
    assert outcome.attempted
    assert not outcome.failed, "".join(told)


def test_every_section_has_a_library() -> None:
    assert list(sections()) == ["", *LIBRARIES]


def test_gains() -> None:
    run(sections()[""], "gains")


@pytest.mark.parametrize("section", LIBRARIES)
def test_handed_over(section: str) -> None:
    if find_spec(LIBRARIES[section]) is None:
        pytest.skip(f"{LIBRARIES[section]} is not installed")
    blocks = sections()
    run(blocks[""] + "\n" + blocks[section], section)
