"""What `track` and `locate` write is never what they read, and all of it is written or nothing."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from gainproof import cli

Capture = pytest.CaptureFixture[str]
TRACK = ["track", "detections.csv"]
LOCATE = ["locate", "observations.csv", "stations.csv"]


@pytest.fixture(name="folder")
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> Path:
    """With both examples in it, a picture's name for each of their files, and a second name."""
    monkeypatch.chdir(tmp_path)
    assert cli.main(["track", "--example", "."]) == 0
    assert cli.main(["locate", "--example", "."]) == 0
    for path in list(tmp_path.iterdir()):
        path.with_suffix(".svg").write_bytes(path.read_bytes())
    (tmp_path / "link.svg").symlink_to("detections.svg")
    os.link("detections.csv", "second.csv")
    capsys.readouterr()
    return tmp_path


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


@pytest.mark.parametrize(
    ("command", "message"),
    [
        ([*TRACK, "--out", "detections.csv"], "--out and DETECTIONS name one file"),
        ([*TRACK, "--out", "./x/../detections.csv"], "--out and DETECTIONS name one file"),
        ([*TRACK, "--out", "second.csv"], "--out and DETECTIONS name one file"),
        (["track", "detections.svg", "--plot", "detections.svg"], "--plot and DETECTIONS name"),
        (["track", "detections.svg", "--plot", "link.svg"], "--plot and DETECTIONS name one"),
        ([*TRACK, "--out", "a.svg", "--plot", "a.svg"], "--plot and --out name one file, a.svg"),
        ([*TRACK, "--out", "a.svg", "--plot", "x/../a.svg"], "--plot and --out name one file"),
        (
            ["locate", "observations.svg", "stations.csv", "--plot", "observations.svg"],
            "--plot and OBSERVATIONS name one file",
        ),
        (
            ["locate", "observations.csv", "stations.svg", "--plot", "stations.svg"],
            "--plot and STATIONS name one file",
        ),
        ([*LOCATE, "--covariance", "link.svg", "--plot", "link.svg"], "--plot and --covariance"),
    ],
)
def test_one_file_for_two_things_is_refused(
    folder: Path, command: list[str], message: str, capsys: Capture
) -> None:
    before = contents(folder)
    assert cli.main(command) == 2
    captured = capsys.readouterr()
    assert message in captured.err
    assert captured.out == ""
    assert contents(folder) == before


@pytest.mark.parametrize(
    ("command", "name"),
    [("track", "detections.csv"), ("locate", "observations.csv"), ("locate", "stations.csv")],
)
def test_an_example_leaves_files_as_they_are(
    tmp_path: Path, command: str, name: str, capsys: Capture
) -> None:
    own = tmp_path / name
    for make in (lambda: own.write_text("mine"), lambda: own.symlink_to("nowhere")):
        make()
        assert cli.main([command, "--example", str(tmp_path)]) == 2
        assert "exists already; it is left as it is" in capsys.readouterr().err
        assert [path.name for path in tmp_path.iterdir()] == [name]
        assert own.is_symlink() or own.read_text() == "mine"
        own.unlink()


@pytest.mark.parametrize("bad", ["p.svg", "below/p.svg"])
def test_where_one_file_cannot_be_written_none_is(folder: Path, bad: str, capsys: Capture) -> None:
    """A folder stands in its place, or a file in that of its folder."""
    pytest.importorskip("matplotlib")
    if "/" in bad:
        (folder / "below").write_text("")
    else:
        (folder / bad).mkdir()
    before = contents(folder)
    assert cli.main([*TRACK, "--out", "o.csv", "--plot", bad]) == 2
    captured = capsys.readouterr()
    assert f"{bad}: cannot be written: " in captured.err
    assert captured.out == ""
    assert contents(folder) == before


def test_both_are_written(folder: Path, capsys: Capture) -> None:
    pytest.importorskip("matplotlib")
    assert cli.main([*TRACK, "--out", "o.csv", "--plot", "p.svg"]) == 0
    assert capsys.readouterr().out.splitlines()[-2:] == ["o.csv", "p.svg"]
    assert (folder / "o.csv").read_text().startswith("line,time [s]")
    assert "<svg" in (folder / "p.svg").read_text()
