"""Every campaign is named in CONTRIBUTING.md and says how it is called."""

from __future__ import annotations

import re
import runpy
import subprocess
import sys
from pathlib import Path

import pytest
from one_of_each import cases

ROOT = Path(__file__).resolve().parents[2]
CAMPAIGNS = sorted((ROOT / "tests" / "campaigns").glob("*.py"))
STEMS = [path.stem for path in CAMPAIGNS]


def test_each_is_in_the_list() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    (part,) = re.findall(r"^## Campaigns$(.*?)^## ", text, re.MULTILINE | re.DOTALL)
    assert CAMPAIGNS
    assert set(re.findall(r"`(\w+\.py)`", part)) == {path.name for path in CAMPAIGNS}


@pytest.mark.parametrize("path", CAMPAIGNS, ids=lambda path: path.stem)
def test_each_has_help(
    path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "argv", [str(path), "--help"])
    monkeypatch.setattr(sys, "path", [*sys.path])
    with pytest.raises(SystemExit) as end:
        runpy.run_path(str(path), run_name="__main__")
    assert end.value.code == 0
    assert path.name in capsys.readouterr().out


@pytest.mark.parametrize("stem", cases(STEMS, lambda stem: stem == "fuzz_reader"))
def test_each_is_a_command_of_its_own(stem: str) -> None:
    """Without what the tests have on their path."""
    path = CAMPAIGNS[STEMS.index(stem)]
    done = subprocess.run(
        [sys.executable, str(path), "--help"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert path.name in done.stdout


def test_each_finds_what_tests_share() -> None:
    shared = {path.stem for path in (CAMPAIGNS[0].parent.parent / "support").iterdir()}
    for path in CAMPAIGNS:
        text = path.read_text("utf-8")
        imported = set(re.findall(r"^(?:from|import) (\w+)", text, re.MULTILINE))
        if imported & shared:
            assert re.search(r"^sys\.path\.insert\(.*support", text, re.MULTILINE)
