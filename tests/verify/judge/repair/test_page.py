"""The page on repairs says what the judge does."""

from __future__ import annotations

from pathlib import Path

import pytest
from claim_texts import judged, steady

PAGE = Path(__file__).parents[4] / "docs" / "conventions-and-repairs.md"
ROWS = [
    [cell.strip().strip("`") for cell in line.strip("| \n").split(" | ")]
    for line in PAGE.read_text(encoding="utf-8").splitlines()
    if line.startswith("| `")
]


@pytest.mark.parametrize(("printed", "repaired", "change"), ROWS)
def test_row(printed: str, repaired: str, change: str) -> None:
    kind = "inequality" if ">" in printed else "identity"
    (verdict,) = judged(steady("random-velocity"), (kind, printed))
    assert verdict.repair is not None
    found = verdict.repair["latex"].replace("\\left", "").replace("\\right", "")
    assert " ".join(found.split()) == repaired
    assert verdict.repairs[0]["changes"][0].startswith(change)


def test_there_are_rows() -> None:
    assert len(ROWS) >= 6
