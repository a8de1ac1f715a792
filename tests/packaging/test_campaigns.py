"""Every campaign is named in CONTRIBUTING.md and says how it is called."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
CAMPAIGNS = sorted((ROOT / "tests" / "campaigns").glob("*.py"))


def test_each_is_in_the_list() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    (part,) = re.findall(r"^## Campaigns$(.*?)^## ", text, re.MULTILINE | re.DOTALL)
    assert CAMPAIGNS
    assert set(re.findall(r"`(\w+\.py)`", part)) == {path.name for path in CAMPAIGNS}


@pytest.mark.parametrize("path", CAMPAIGNS, ids=lambda path: path.stem)
def test_each_has_help(path: Path) -> None:
    done = subprocess.run(
        [sys.executable, str(path), "--help"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert path.name in done.stdout
