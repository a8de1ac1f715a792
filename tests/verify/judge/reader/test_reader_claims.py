"""Every formula of every claim file is printed, as LaTeX and as plain text, and read again as it
was.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from one_of_each import cases

import gainproof.verify.claims
from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.reader.latex_printer import reading_to_latex
from gainproof.verify.judge.reader.plain_printer import reading_to_plain
from gainproof.verify.judge.reader.reader import read_formula, read_plain

FOLDER = Path(gainproof.verify.claims.__path__[0])
FILES = sorted(FOLDER.rglob("*.toml"))
LONG = ("kosuge-slides", "patent-4869403", "suzuki")


def test_there_are_files() -> None:
    assert len(FILES) > 20


@pytest.mark.alike
@pytest.mark.parametrize(
    "path",
    cases(FILES, lambda path: path.stem in LONG or path in FILES[::3]),
    ids=lambda path: path.stem,
)
def test_printed_and_read_again(path: Path) -> None:
    file = read_claim_text(path.read_text(encoding="utf-8"), path.name)
    for claim in file.claims:
        symbols = file.settings[claim.setting].symbols
        for reading in () if claim.formula is None else claim.formula.readings:
            for again in (
                read_formula(reading_to_latex(reading), symbols),
                read_plain(reading_to_plain(reading), symbols),
            ):
                (found,) = again.readings
                assert found.relations == reading.relations, claim.id
                assert found.conditions == reading.conditions, claim.id
                assert found.connective == reading.connective, claim.id
