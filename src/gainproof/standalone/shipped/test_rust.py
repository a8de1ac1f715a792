"""The crates of Rust: every value as proved, and what is outside of a domain refused."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from gainproof.standalone.shipped._package import PACKAGE, VALUES


@pytest.mark.parametrize("module", VALUES)
def test_the_crate_finds_every_value_as_proved(module: str, tmp_path: Path) -> None:
    command = shutil.which("cargo")
    if command is None:
        pytest.skip("needs cargo")
    crate = tmp_path / module
    shutil.copytree(PACKAGE / "rust" / module, crate)  # cargo leaves a file beside the manifest
    own = {**os.environ, "CARGO_TARGET_DIR": str(tmp_path / "target"), "RUSTFLAGS": "-D warnings"}
    run = [command, "test", "--offline", "--quiet"]
    done = subprocess.run(run, cwd=crate, env=own, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
