"""`check --new` and `check --draft`: files that can be worked with, and none overwritten."""

from __future__ import annotations

import shlex
from pathlib import Path

import pytest

from gainproof import cli
from gainproof.claims.template import template
from gainproof.verify.judge.claim.file import read_claim_file
from gainproof.verify.judge.claim.settings import SETTING_KINDS
from gainproof.verify.judge.kinds.catalogue import KINDS

Capture = pytest.CaptureFixture[str]
TEX = r"\begin{equation} \beta = \frac{\alpha^2}{2 - \alpha} \end{equation}"


def test_the_template_checks_as_it_is(tmp_path: Path, capsys: Capture) -> None:
    path = tmp_path / "my paper's.toml"
    assert cli.main(["check", "--new", str(path)]) == 0
    assert f"gainproof check {shlex.quote(str(path))}" in capsys.readouterr().out
    assert cli.main(["check", str(path)]) == 0
    assert "2 claims: 2 proved" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("name", "key"),
    [
        ("my paper's", "my-paper-s"),
        ("..x", "x"),
        ("(1)", "1-"),
        ("?", "source"),
        ("a" * 99, "a" * 80),
    ],
)
def test_the_key_of_what_is_begun_is_one(name: str, key: str, tmp_path: Path) -> None:
    """Any name of a file will do."""
    path = tmp_path / f"{name}.toml"
    assert cli.main(["check", "--new", str(path)]) == 0
    assert read_claim_file(path).source.key == key
    paper, drafted = tmp_path / "p.tex", tmp_path / "d" / path.name
    paper.write_text(TEX, encoding="utf-8")
    assert cli.main(["check", "--draft", str(paper), "--out", str(drafted)]) == 0
    assert f"key = '{key}'" in drafted.read_text(encoding="utf-8")


def test_the_template_names_every_kind() -> None:
    begun = template("paper")
    words = begun.replace("\n# ", " ")
    assert all(f"\n#   {kind} " in begun for kind in SETTING_KINDS)
    assert f"kind is one of {', '.join(kind.name for kind in KINDS)};" in words


def test_a_claim_file_is_no_paper(tmp_path: Path, capsys: Capture) -> None:
    path, out = tmp_path / "claims.toml", tmp_path / "new.toml"
    path.write_text(template("paper"))
    assert cli.main(["check", "--draft", str(path), "--out", str(out)]) == 2
    assert "no displayed equation found" in capsys.readouterr().err
    assert not out.exists()


def test_a_draft_is_written_or_printed(tmp_path: Path, capsys: Capture) -> None:
    tex, out = tmp_path / "paper.tex", tmp_path / "paper.toml"
    tex.write_text(TEX)
    assert cli.main(["check", "--draft", str(tex), "--out", str(out)]) == 0
    assert "1 equation, 1 read, 0 left as comments" in capsys.readouterr().out
    assert cli.main(["check", "--draft", str(tex)]) == 0
    assert capsys.readouterr().out == out.read_text()
    assert cli.main(["check", str(out)]) == 2
    assert "still marked TODO" in capsys.readouterr().err


@pytest.mark.parametrize("option", ["--new", "--out"])
def test_nothing_is_overwritten(option: str, tmp_path: Path, capsys: Capture) -> None:
    tex, path = tmp_path / "paper.tex", tmp_path / "paper.toml"
    tex.write_text(TEX)
    path.write_text("mine")
    arguments = [option, str(path)] + (["--draft", str(tex)] if option == "--out" else [])
    assert cli.main(["check", *arguments]) == 2
    assert "exists already" in capsys.readouterr().err
    assert path.read_text() == "mine"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--new", "a.txt"], "a claim file is a file .toml"),
        (["--new", "a.toml", "--draft", "a.tex"], "--new writes a template"),
        (["--out", "a.toml"], "--draft PAPER.tex is missing"),
        (["--draft", "none.tex"], "cannot be read"),
        (["--draft", "."], "a regular file is wanted"),
        (["b.toml", "--new", "a.toml"], "they do not judge one"),
        (["--draft", "a.tex", "--json"], "they do not judge one"),
        (["--new", "x" * 300 + ".toml"], "cannot be written"),
    ],
)
def test_what_cannot_be_begun(
    arguments: list[str],
    message: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: Capture,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert cli.main(["check", *arguments]) == 2
    assert message in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_a_file_that_is_no_text_is_no_danger(tmp_path: Path, capsys: Capture) -> None:
    tex = tmp_path / "image.tex"
    tex.write_bytes(bytes(range(256)) * 100)
    assert cli.main(["check", "--draft", str(tex)]) == 2
    assert "no displayed equation found" in capsys.readouterr().err
    tex.write_bytes(b"x" * (2**20 + 1))
    assert cli.main(["check", "--draft", str(tex)]) == 2
    assert "more than 1048576 bytes" in capsys.readouterr().err
