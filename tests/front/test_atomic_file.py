"""Files are whole or not there."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from gainproof import atomic_file


def test_file_and_folders_are_made(tmp_path: Path) -> None:
    path = tmp_path / "a" / "b" / "report.txt"
    atomic_file.write_text(path, "σ\n")
    assert path.read_bytes() == "σ\n".encode()


def test_old_content_is_replaced(tmp_path: Path) -> None:
    path = tmp_path / "x"
    path.write_text("a longer text")
    atomic_file.write_bytes(path, b"new")
    assert path.read_bytes() == b"new"


@pytest.mark.parametrize("error", [KeyboardInterrupt, OSError])
@pytest.mark.parametrize("moment", ["replace", "chmod"])
def test_an_interrupt_leaves_the_old_file_and_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: type[BaseException], moment: str
) -> None:
    path = tmp_path / "x"
    path.write_text("old")

    def interrupted(*_: object) -> None:
        raise error

    monkeypatch.setattr(os, moment, interrupted)
    with pytest.raises(error):
        atomic_file.write_bytes(path, b"new")
    monkeypatch.undo()
    assert [p.name for p in tmp_path.iterdir()] == ["x"]
    assert path.read_text() == "old"


@pytest.mark.skipif(os.name != "posix", reason="permissions of POSIX systems")
def test_permissions_are_those_of_any_new_file(tmp_path: Path) -> None:
    (tmp_path / "plain").write_text("")
    atomic_file.write_bytes(tmp_path / "ours", b"")
    assert (tmp_path / "ours").stat().st_mode == (tmp_path / "plain").stat().st_mode
