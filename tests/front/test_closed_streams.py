"""Standard streams that are closed: files are written all the same, and status stays status."""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

PYTHON = shlex.quote(sys.executable)

pytestmark = pytest.mark.skipif(os.name != "posix", reason="streams are closed by a shell")


def run_in_shell(words: str, place: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        ["sh", "-c", f"{PYTHON} {words}"], cwd=place, capture_output=True, text=True, check=False
    )


def test_files_are_written_without_standard_output(tmp_path: Path) -> None:
    found = run_in_shell("-m gainproof track --example . >&-", tmp_path)
    assert (found.returncode, found.stderr) == (0, "")
    assert (tmp_path / "detections.csv").read_text().startswith("time [s],")


def test_bad_input_keeps_its_status_without_standard_error(tmp_path: Path) -> None:
    found = run_in_shell("-m gainproof track none.csv 2>&-", tmp_path)
    assert (found.returncode, found.stdout) == (2, "")


def test_progress_does_not_take_standard_output_for_standard_error(tmp_path: Path) -> None:
    found = run_in_shell(
        "-c 'from gainproof import cli\nfrom gainproof.jobs import progress\n"
        'assert cli.main(["track", "--example", "."]) == 0\n'
        'progress.Progress().say("a line")\' 2>&-',
        tmp_path,
    )
    assert "a line" not in found.stdout
    assert "detections.csv" in found.stdout
