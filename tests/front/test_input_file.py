"""Files that a user names and that are none, and places that cannot be written: one line each."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

from gainproof import cli
from gainproof.bad_input import BadInputError
from gainproof.files import atomic_file, input_file, named_files, places
from gainproof.verification import findings
from gainproof.verification.report import Findings

Capture = pytest.CaptureFixture[str]
READERS = [
    ["track", "FILE.csv"],
    ["locate", "FILE.csv", "stations.csv"],
    ["locate", "observations.csv", "FILE.csv"],
    ["derive", "FILE.py"],
    ["generate", "FILE.py", "--out", "package"],
    ["check", "FILE.toml"],
    ["check", "suzuki", "--errata", "FILE.md"],
    ["check", "--draft", "FILE.tex"],
    ["explain", "FILE.toml", "1"],
    ["cite", "FILE.toml"],
    ["campaign", "float32", "--state", "FILE.json"],
]


def pipe(path: Path) -> None:
    """Whoever opened it would wait for a sender."""
    os.mkfifo(path)


def endless(path: Path) -> None:
    path.symlink_to("/dev/zero")


def folder(path: Path) -> None:
    path.mkdir()


@pytest.mark.alike
@pytest.mark.parametrize("make", [pipe, endless, folder])
@pytest.mark.parametrize("command", READERS, ids=lambda words: f"{words[0]} {words[-1]}")
def test_what_is_no_file_is_refused_before_it_is_read(
    command: list[str],
    make: object,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: Capture,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert cli.main(["locate", "--example", "."]) == 0
    capsys.readouterr()
    name = next(word for word in command if word.startswith("FILE"))
    assert callable(make)
    make(tmp_path / name)
    before = set(tmp_path.iterdir())
    assert cli.main(command) == 2
    assert capsys.readouterr().err == f"gainproof: {name}: a regular file is wanted, this is none\n"
    assert set(tmp_path.iterdir()) == before


def test_a_whole_file_is_read_and_no_more_than_the_limit(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_bytes(b"\xc3\xa4\n")
    assert input_file.content(path, 3) == b"\xc3\xa4\n"
    assert input_file.text(path, 3) == "ä\n"
    with pytest.raises(BadInputError, match="more than 2 bytes"):
        input_file.content(path, 2)
    path.write_bytes(b"a\nb\xff")
    with pytest.raises(BadInputError, match="file, line 2: cannot be read: is no UTF-8 text"):
        input_file.text(path, 9)


def test_what_takes_the_place_of_a_file_is_seen(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Between the look at it and its opening."""
    monkeypatch.setattr(places, "require_file", lambda _: None)
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(BadInputError, match="a regular file is wanted, this is none"):
        input_file.content(tmp_path / "pipe", 9)


@pytest.mark.parametrize("more", [b"", b"b", b"b" * 100])
def test_a_file_that_changes_while_it_is_read_is_refused(
    more: bytes, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "file"
    path.write_bytes(b"a" * 50)
    looked = os.fstat

    def look(handle: int) -> os.stat_result:
        found = looked(handle)
        path.write_bytes(b"c" * 50 + more)  # after each look, the first one too
        os.utime(path, ns=(0, found.st_mtime_ns + 1))
        return found

    monkeypatch.setattr(os, "fstat", look)
    with pytest.raises(BadInputError, match=r"file: (changes while it is read|more than)"):
        input_file.content(path, 99)


NOWHERE = ["/proc/report", "file/report", "/dev/null/report"]


@pytest.mark.parametrize("place", NOWHERE)
def test_a_folder_that_cannot_be_written_is_told_before_the_work(
    place: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("file").write_text("")
    with pytest.raises(BadInputError, match="cannot be written: "):
        places.require_writable(Path(place))
    for good in ("", "new/report"):
        places.require_writable(Path(good))
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


@pytest.mark.parametrize("good", [True, False])
@pytest.mark.parametrize("place", NOWHERE)
def test_run_says_at_once_that_there_will_be_no_report_and_prints_its_summary(
    place: str, good: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("file").write_text("")

    def find(*_: object, **__: object) -> Findings:
        told = capsys.readouterr()
        assert told.err.startswith(f"gainproof: {place}: cannot be written: ")
        assert told.err.count("\n") == 1
        changes = {} if good else {"a.toml": ("1: proved, was refuted",)}
        counts: dict[str, Any] = {"bounds": (0, 0), "taken": {}, "done": {}, "trials": (0, 0)}
        return Findings({}, 7, (), (), (), (), (), (), changes, accepted=False, **counts)

    monkeypatch.setattr(findings, "find", find)
    assert cli.main(["run", "--report", place]) == (2 if good else 1)
    out = capsys.readouterr().out
    assert "generated files:  7, each byte as derived\n" in out
    assert f"report:           none: {place}/report" in out


def test_the_book_says_at_once_that_its_folder_cannot_be_written(capsys: Capture) -> None:
    pytest.importorskip("jinja2")
    assert cli.main(["book", "--out", "/proc/book"]) == 2
    assert "/proc/book: cannot be written" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["../x", "/x", "a/../../x", "..", "c:x", "a\\x", ""])
def test_names_that_lie_elsewhere(name: str, tmp_path: Path) -> None:
    assert not named_files.is_within(name)
    with pytest.raises(BadInputError, match="would lie outside"):
        named_files.require_within(tmp_path, ["a", name])
    assert named_files.is_within("a/b..html")


@pytest.mark.parametrize("through", ["sources", "sources/x.html"])
def test_a_link_and_a_pipe_on_the_way_are_seen(through: str, tmp_path: Path) -> None:
    outside, inside = tmp_path / "outside", tmp_path / "inside"
    outside.mkdir()
    (inside / through).parent.mkdir(parents=True)
    (inside / through).symlink_to(outside / "x.html" if "." in through else outside)
    with pytest.raises(BadInputError, match=f"inside: {through} in it is a link"):
        named_files.require_within(inside, ["sources/x.html"])
    (inside / through).unlink()
    os.mkfifo(inside / through)
    with pytest.raises(BadInputError, match=f"inside: {through} in it is no file"):
        named_files.require_within(inside, ["sources/x.html"])
    (inside / through).unlink()
    atomic_file.write_bytes(inside / "sources" / "x.html", b"")
    named_files.require_within(inside, ["sources/x.html"])
