"""Drift: every way in which generated files can be wrong is seen, and the cure is named."""

from __future__ import annotations

from pathlib import Path

import pytest

from gainproof.subjects import drift, generated_files
from gainproof.subjects.drift import Difference

FRESH = {"__init__.py": b"", "random_velocity.py": b"one\ntwo\nthree\n", "sub/x.json": b"{}\n"}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, content in FRESH.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(content)
    return tmp_path


def test_equal_files_do_not_differ(folder: Path) -> None:
    (folder / "__pycache__").mkdir()
    (folder / "__pycache__" / "x.pyc").touch()
    assert drift.compare(FRESH, folder) == []


def test_one_altered_byte_is_seen(folder: Path) -> None:
    (folder / "random_velocity.py").write_bytes(b"one\ntwo \nthree\n")
    (difference,) = drift.compare(FRESH, folder)
    assert (difference.name, difference.kind) == ("random_velocity.py", "different")
    assert difference.text().endswith("first in line 2: 'two ' instead of 'two'")


def test_changed_line_ends_are_seen(folder: Path) -> None:
    (folder / "random_velocity.py").write_bytes(b"one\r\ntwo\r\nthree\r\n")
    assert [d.kind for d in drift.compare(FRESH, folder)] == ["different"]


def test_a_missing_last_line_is_seen(folder: Path) -> None:
    (folder / "random_velocity.py").write_bytes(b"one\ntwo\nthree\n\n")
    (difference,) = drift.compare(FRESH, folder)
    assert difference.detail == "5 lines instead of 4"


def test_a_missing_file_is_seen(folder: Path) -> None:
    (folder / "sub" / "x.json").unlink()
    assert drift.compare(FRESH, folder) == [Difference("sub/x.json", "missing", "")]


@pytest.mark.parametrize("name", ["old_family.py", "old_family.json", "sub/.hidden", "x.partial"])
def test_a_stale_file_is_seen(folder: Path, name: str) -> None:
    (folder / name).touch()
    assert [(d.name, d.kind) for d in drift.compare(FRESH, folder)] == [(name, "stale")]
    assert drift.compare(FRESH, folder, only=True) == []


def test_a_missing_folder_is_all_missing(tmp_path: Path) -> None:
    kinds = {d.kind for d in drift.compare(FRESH, tmp_path / "none")}
    assert kinds == {"missing"}


def test_mending_leaves_no_difference(folder: Path) -> None:
    (folder / "stale.py").touch()
    (folder / "__init__.py").write_text("# edited")
    (folder / "sub" / "x.json").unlink()
    differences = drift.compare(FRESH, folder)
    assert generated_files.put(FRESH, differences, folder) == 3
    assert drift.compare(FRESH, folder) == []
