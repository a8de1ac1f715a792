"""`cite` names works, derivations, kernels, and claim files of anybody."""

from __future__ import annotations

from pathlib import Path

import pytest

from gainproof import cli
from gainproof.claims.template import template
from gainproof.pages import citing

Capture = pytest.CaptureFixture[str]


def test_a_claim_file_of_ones_own(tmp_path: Path, capsys: Capture) -> None:
    path = tmp_path / "own.toml"
    path.write_text(template("own").replace("# year, doi", "year = 2001\ncommit = 'abc'\n# doi"))
    assert cli.main(["cite", str(path)]) == 0
    text = capsys.readouterr().out
    assert text.startswith("A. Author, B. Author: Title of the paper. Journal 1, 23-45, 2001.\n")
    assert "  commit: abc\n" in text
    assert "  2 claims in " in text


@pytest.mark.parametrize("name", ["none.toml", "no/such/file"])
def test_a_claim_file_that_is_not_there(name: str, capsys: Capture) -> None:
    assert cli.main(["cite", name]) == 2
    assert "cannot be read" in capsys.readouterr().err


def test_a_bad_claim_file(tmp_path: Path, capsys: Capture) -> None:
    path = tmp_path / "own.toml"
    path.write_text(template("own").replace("[source]", "[sorce]"))
    assert cli.main(["cite", str(path)]) == 2
    assert "the nearest is source" in capsys.readouterr().err


def test_lines_fit_a_terminal() -> None:
    text = citing.listing(80) + citing.citation("gains", 80)
    words = [line for line in text.splitlines() if ".toml" not in line]
    assert max(map(len, words)) <= 80
