"""Names under which nothing can lie, and something else than what is wanted: one line, status 2."""

from __future__ import annotations

from pathlib import Path

import pytest

from gainproof import cli
from gainproof.bad_input import BadInputError
from gainproof.files import places
from gainproof.subjects import drift

LONG = "a" * 300  # file systems take 255 bytes; `Path.exists` raises OSError for it
COMMANDS = [
    ["check", LONG],
    ["check", f"{LONG}.toml"],
    ["check", "--new", f"{LONG}.toml"],
    ["check", "--draft", f"{LONG}.tex"],
    ["generate", "least-squares-mean", "--out", LONG],
    ["generate", f"{LONG}.py", "--out", "package"],
    ["book", "--out", LONG],
    ["campaign", "float32", "--state", LONG, "least_squares_mean"],
    ["locate", f"{LONG}.csv", f"{LONG}.csv"],
]


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: " ".join(command)[:24])
def test_a_name_that_is_too_long_is_bad_input(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    command: list[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert cli.main(command) == 2
    error = capsys.readouterr().err
    assert LONG in error
    assert error.count("\n") == 1
    assert not any(tmp_path.iterdir())


def test_only_what_is_wanted_may_lie_there(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    (tmp_path / "loop").symlink_to("loop")
    for path in (tmp_path, tmp_path / "nothing", tmp_path / "file" / "below"):
        places.require_folder(path)
    for path in (tmp_path / "file", tmp_path / "nothing"):
        places.require_file(path)
    for require, path, told in (
        (places.require_folder, tmp_path / "file", "a folder is wanted, this is none"),
        (places.require_file, tmp_path, "a regular file is wanted, this is none"),
        (places.require_file, Path("/dev/null"), "a regular file is wanted, this is none"),
        (places.require_folder, tmp_path / "loop", "a folder is wanted: Too many levels"),
        (places.require_file, Path("nul\0"), "a regular file is wanted: embedded null"),
    ):
        with pytest.raises(BadInputError, match=told):
            require(path)


def test_a_file_that_cannot_be_read_is_no_difference_of_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "kernel.py").write_text("x")

    def refuse(path: Path) -> bytes:
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr(Path, "read_bytes", refuse)
    with pytest.raises(BadInputError, match=r"kernel\.py: cannot be read: Permission denied"):
        drift.compare({"kernel.py": b"x"}, tmp_path)
