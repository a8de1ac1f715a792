"""The campaign goes on where it was interrupted, and fails when a bound does not hold."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[1] / "campaigns" / "kernel_ulp.py"
ONLY = ["--only", "least_squares_mean/sample_number", "--points", "1000", "--jobs", "1"]


def run(state: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, str(SCRIPT), *ONLY, "--state", str(state)],
        capture_output=True,
        text=True,
        check=False,
    )


def test_it_resumes_and_reports(tmp_path: Path) -> None:
    state = tmp_path / "state.json"
    whole = run(state)
    assert whole.returncode == 0, whole.stderr
    assert "4/4 chunks" in whole.stderr
    assert "least_squares_mean.gains.alpha" in whole.stdout

    whole_state = state.read_text()

    # complete: nothing is measured again
    again = run(state)
    assert "chunks" not in again.stderr
    assert again.stdout == whole.stdout

    # interrupted before the first chunk of float32 was noted
    kept = json.loads(state.read_text())
    kept["done"] = kept["done"][:3]
    state.write_text(json.dumps(kept))
    assert "1/1 chunks" in run(state).stderr

    # measurements of other kernels count for nothing
    state.write_text(json.dumps({**kept, "kernels": "others"}))
    assert "4/4 chunks" in run(state).stderr

    # a measured error above its bound is a failure
    key = "least_squares_mean/gains.alpha/float64/domain"
    kept["worst"][key][0] = 1.02
    kept["done"] = json.loads(whole_state)["done"]
    state.write_text(json.dumps(kept))
    assert run(state).returncode == 1
