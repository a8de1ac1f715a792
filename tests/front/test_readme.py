"""The README's examples run and print what it says; its two commands are those of .ci/run."""

from __future__ import annotations

import doctest
import os
import re
from pathlib import Path

import pytest
import shown_commands

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```$", README, flags=re.MULTILINE | re.DOTALL)


def console_examples() -> list[tuple[str, str]]:
    """Each command after `$ ` with the output below it."""
    return [
        (command, output)
        for block in blocks("console")
        for command, output in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", block, re.MULTILINE)
    ]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One working folder, with the files that the README shows, for all examples in their order."""
    path = tmp_path_factory.mktemp("readme")
    for block in [*blocks("toml"), *blocks("python")]:
        name = block.partition("\n")[0].removeprefix("# ")
        (path / name).write_text(block, encoding="utf-8")
    return path


@pytest.mark.usefixtures("all_derived")
@pytest.mark.skipif(os.name != "posix", reason="the examples use a POSIX shell")
def test_console_examples(folder: Path) -> None:
    examples = console_examples()
    assert examples
    for command, output in examples:
        shown = printed(command, folder)
        assert doctest.OutputChecker().check_output(output, shown, doctest.ELLIPSIS), shown


def printed(command: str, folder: Path) -> str:
    """What a command of the README prints; errors only if it prints nothing else."""
    out, errors = shown_commands.run(command, folder)
    return out or errors


def test_python_examples() -> None:
    text = "\n".join(blocks("pycon"))
    assert text
    example = doctest.DocTestParser().get_doctest(text, {}, "README.md", "README.md", 0)
    told: list[str] = []
    doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(example, out=told.append)
    assert not told, "".join(told)


def test_the_two_commands_are_those_of_continuous_integration() -> None:
    commands = re.findall(r"^    (.*\.venv.*)$", README, flags=re.MULTILINE)
    assert commands == [
        "python3 -m venv .venv && .venv/bin/pip install -e . && .venv/bin/gainproof run",
        ".venv/bin/pip install -e '.[test]' && .venv/bin/pytest",
    ]
    script = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    steps = re.findall(r'^step "(.*)"$', script, flags=re.MULTILINE)
    assert steps[:2] == commands


def test_lines_fit() -> None:
    prose = re.sub(r"^```.*?^```$", "", README, flags=re.MULTILINE | re.DOTALL)
    assert max(map(len, prose.splitlines())) <= 130
