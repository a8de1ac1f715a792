"""Pages of docs/ are run from top to bottom: files are written as shown, commands print what is
shown below them.
"""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest
import shown_commands
from browser import of_changed_pages

DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGES = sorted(path for path in DOCS.glob("*.md") if "```console" in path.read_text("utf-8"))
# of Python what is a file: its name stands in the first line
BLOCK = re.compile(
    r"^```(toml|latex|csv|python(?=\n# \w+\.py\n)|console)\n(.*?)^```$", re.MULTILINE | re.DOTALL
)
COMMAND = re.compile(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", re.MULTILINE)
SECONDS = re.compile(r"\d+\.\d+ ?s\b")


def printed(command: str, folder: Path) -> str:
    """What a command writes, errors included."""
    out, errors = shown_commands.run(command, folder)
    return SECONDS.sub("? s", out + errors)


def test_there_is_a_page() -> None:
    assert "check-a-formula.md" in [page.name for page in PAGES]


@pytest.mark.alike
@pytest.mark.usefixtures("all_derived")
@pytest.mark.skipif(os.name != "posix", reason="the pages use a POSIX shell")
@pytest.mark.parametrize(
    "page",
    [
        # packages of kernels with their tests, in C too: they have tests of their own
        pytest.param(page, marks=of_changed_pages if page.name == "generate.md" else ())
        for page in PAGES
    ],
    ids=lambda page: page.name,
)
def test_page(page: Path, tmp_path: Path) -> None:
    commands = 0
    for language, content in BLOCK.findall(page.read_text("utf-8")):
        if language == "console":
            for command, output in COMMAND.findall(content):
                commands += 1
                assert printed(command, tmp_path) == SECONDS.sub("? s", output), command
        else:
            name = content.partition("\n")[0].lstrip("#% ")
            (tmp_path / name).write_text(content, encoding="utf-8")
    assert commands


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_lines_fit(page: Path) -> None:
    prose = BLOCK.sub("", page.read_text("utf-8"))
    assert max(map(len, prose.splitlines())) <= 130
