"""The campaign over kernels goes on where it was interrupted, and fails where a bound is broken."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[1] / "campaigns" / "kernel_ulp.py"
ONLY = ["--only", "least_squares_mean/sample_number", "--points", "1000", "--jobs", "1"]


def run(state: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, str(SCRIPT), *ONLY, "--state", str(state)],
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.thorough
def test_it_resumes_and_reports(tmp_path: Path) -> None:
    state = tmp_path / "state.jsonl"
    whole = run(state)
    assert whole.returncode == 0, whole.stderr
    assert "4 blocks to do, 0 done" in whole.stderr
    assert "least_squares_mean.gains.alpha" in whole.stdout

    # complete: nothing is measured again
    again = run(state)
    assert "0 blocks to do, 4 done" in again.stderr
    assert again.stdout == whole.stdout

    # one is missing, one is of other kernels, and one has an error above its bound
    *_, other, wrong = lines = [json.loads(line) for line in state.read_text().splitlines()]
    other["block"][-1] = "others"
    wrong["result"]["gains.alpha"][0] = 1.02
    state.write_text("\n".join(map(json.dumps, lines[1:])))
    last = run(state)
    assert "2 blocks to do, 2 done" in last.stderr
    assert last.returncode == 1
