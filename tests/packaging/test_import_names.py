"""The three folders are reached by one name only, in the environment that runs the tests."""

from __future__ import annotations

import importlib
import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
NAMES = ("derive", "generated", "verify")


@pytest.mark.parametrize("name", NAMES)
def test_bare_name_is_not_importable_under_pytest(name: str) -> None:
    assert importlib.util.find_spec(name) is None


@pytest.mark.parametrize("name", NAMES)
def test_bare_name_is_not_importable_where_installed(name: str, tmp_path: Path) -> None:
    script = f"import importlib.util as u; print(u.find_spec({name!r}))"
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=tmp_path)
    assert done.stdout.strip() == "None"


@pytest.mark.parametrize("name", NAMES)
def test_link_leads_to_the_folder(name: str) -> None:
    link = ROOT / "src" / "gainproof" / name
    if not link.is_symlink():
        pytest.skip("this checkout has no symbolic links")
    assert not link.readlink().is_absolute()
    assert link.resolve() == ROOT / name


@pytest.mark.parametrize("name", NAMES)
def test_a_folder_of_the_user_does_no_harm(name: str, tmp_path: Path) -> None:
    """A script beside a folder called `generated` still gets ours by its whole name."""
    (tmp_path / name).mkdir()
    (tmp_path / name / "__init__.py").write_text("raise RuntimeError('the wrong folder')\n")
    (tmp_path / "script.py").write_text(f"import gainproof.{name} as ours; print(ours.__name__)\n")
    command = [sys.executable, "script.py"]
    done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=tmp_path)
    assert done.stdout.strip() == f"gainproof.{name}"
