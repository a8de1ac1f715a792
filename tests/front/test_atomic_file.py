"""Files are whole or not there."""

from __future__ import annotations

import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from gainproof.files import atomic_file


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


@pytest.mark.skipif(os.name != "posix", reason="links of POSIX systems")
def test_links_stay_and_what_they_lead_to_is_written(tmp_path: Path) -> None:
    """A link to a link to a file, and one to a file that is not there yet."""
    (tmp_path / "far").mkdir()
    (tmp_path / "far" / "x").write_text("old")
    (tmp_path / "second").symlink_to(Path("far", "x"))
    (tmp_path / "first").symlink_to(tmp_path / "second")
    (tmp_path / "open").symlink_to(Path("far", "new"))
    for link in ("first", "open"):
        atomic_file.write_bytes(tmp_path / link, link.encode())
        assert (tmp_path / link).is_symlink()
        assert (tmp_path / link).read_bytes() == link.encode()
    assert (tmp_path / "second").is_symlink()
    assert sorted(path.name for path in (tmp_path / "far").iterdir()) == ["new", "x"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["far", "first", "open", "second"]


@pytest.mark.skipif(os.name != "posix", reason="links of POSIX systems")
def test_a_link_that_leads_to_itself_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "x").symlink_to("x")
    with pytest.raises(OSError, match="x"):
        atomic_file.write_bytes(tmp_path / "x", b"new")
    assert [path.is_symlink() for path in tmp_path.iterdir()] == [True]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no FIFOs")
@pytest.mark.parametrize("name", ["pipe", "link"])
def test_what_is_no_regular_file_is_written_to_and_stays(tmp_path: Path, name: str) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "link").symlink_to("pipe")
    reader = os.open(tmp_path / "pipe", os.O_RDONLY | os.O_NONBLOCK)
    try:
        atomic_file.write_bytes(tmp_path / name, b"through")
        assert os.read(reader, 100) == b"through"
    finally:
        os.close(reader)
    assert stat.S_ISFIFO((tmp_path / "pipe").lstat().st_mode)
    assert (tmp_path / "link").is_symlink()
    assert len(list(tmp_path.iterdir())) == 2


WRITES = """
import sys
from pathlib import Path
from gainproof.files import atomic_file
print("before")
atomic_file.write_text(Path(sys.argv[1]), "content\\n")
print("after")
"""


@pytest.mark.parametrize("name", ["/dev/stdout", "out.txt"])
def test_the_file_of_standard_output_is_written_in_turn(tmp_path: Path, name: str) -> None:
    with (tmp_path / "out.txt").open("w") as stream:
        subprocess.run(
            [sys.executable, "-c", WRITES, name], stdout=stream, check=True, cwd=tmp_path
        )
    assert (tmp_path / "out.txt").read_text() == "before\ncontent\nafter\n"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no FIFOs")
def test_nothing_goes_through_where_another_file_cannot_be_written(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "folder").mkdir()
    reader = os.open(tmp_path / "pipe", os.O_RDONLY | os.O_NONBLOCK)
    try:
        with pytest.raises(IsADirectoryError):
            atomic_file.write_together({tmp_path / "pipe": b"through", tmp_path / "folder": b""})
        assert os.read(reader, 100) == b""
    finally:
        os.close(reader)
