"""Printed source has the layout that the formatter gives, whatever the number of names."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from gainproof.derive.printer.layout import WIDTH, call, listed, row

NAMES = ["diagonal_1", "diagonal_2", "first_shear", "second_shear", "measurement_variance", "tau"]


def printed(count: int, wide: str = "") -> list[str]:
    names = [name + wide for name in NAMES[:count]]
    return [
        "def function():",
        *call("Result", "_SIGNATURE", names),
        "",
        "",
        "kept = Signature(",
        *row("    ", names, ","),
        ")",
        *listed("names = [", names, "]"),
    ]


@pytest.mark.parametrize("wide", ["", "_over_variance", "_over_the_variance_of_a_measurement"])
@pytest.mark.parametrize("count", range(1, 7))
def test_no_line_is_too_long(count: int, wide: str) -> None:
    text = printed(count, wide)
    compile("\n".join(text), "printed", "exec")
    assert max(map(len, text)) <= WIDTH


@pytest.mark.skipif(not shutil.which("ruff", path=Path(sys.executable).parent), reason="no ruff")
@pytest.mark.parametrize("count", range(1, 7))
def test_the_formatter_changes_nothing(count: int) -> None:
    for wide in ("", "_over_variance", "_over_the_variance_of_a_measurement"):
        text = "\n".join(printed(count, wide)) + "\n"
        ruff = shutil.which("ruff", path=Path(sys.executable).parent) or "ruff"
        command = [ruff, "format", "--isolated", "--line-length", str(WIDTH), "-"]
        done = subprocess.run(command, input=text, capture_output=True, text=True, check=True)
        assert done.stdout == text
