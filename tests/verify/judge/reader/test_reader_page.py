"""Every row of the page on the reader: what it says is read is read, what it says is refused is
refused.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from declared import Declared

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.latex_printer import reading_to_latex
from gainproof.verify.judge.reader.plain_printer import reading_to_plain
from gainproof.verify.judge.reader.printed_names import canonical_token
from gainproof.verify.judge.reader.reader import read_formula, read_plain
from gainproof.verify.judge.reader.source_code import PREFIXES, SAME
from gainproof.verify.judge.reader.words import FUNCTION_COMMANDS, FUNCTION_WORDS, PLAIN_FORMS

PAGE = Path(__file__).parents[4] / "docs" / "reader.md"
NUMBERS = r"a b c k n x y T \alpha \beta \theta \sigma_v \dot{x}_{sk-1} x' \hat{x}_k(+) x^{-}"
INDEXED = "b_i b_1 b_2 b_n"
DIFFERENCE = r"\Delta x"
SYMBOLS = {
    **{
        canonical_token(name): Declared()
        for name in [*NUMBERS.split(), *INDEXED.split(), DIFFERENCE]
    },
    "i": Declared(integer=True),
    **{
        canonical_token(name): Declared(shape=(2, 2))
        for name in [r"A", r"B", r"\Phi", r"\underline{x}"]
    },
    "f": Declared(("x",)),
    "g": Declared(("x", "y")),
    canonical_token(r"\hat{P}"): Declared(("n",), (2, 2)),
}


def rows(columns: int) -> list[tuple[str, ...]]:
    """The rows of the table with that many columns, without its heading."""
    found = []
    for line in PAGE.read_text(encoding="utf-8").splitlines():
        cells = line.replace("\\|", "\0").split("|")[1:-1]
        if len(cells) == columns and "`" in line:
            found.append(tuple(c.replace("\0", "|").strip().strip("`") for c in cells))
    return found


READ, REFUSED = rows(3), rows(2)


def test_both_tables_are_found() -> None:
    assert len(READ) > 40
    assert len(REFUSED) > 10


def test_every_function_and_every_prefix_is_on_the_page() -> None:
    found = rows(4)
    commands, words = (
        {name for row in found for name in re.findall(r"`?([^`, ]+)`?", row[column])}
        for column in (1, 2)
    )
    assert words == {*FUNCTION_WORDS, *PLAIN_FORMS, *SAME, "sqrt", "lg", "log2", "log10"}
    assert set(FUNCTION_COMMANDS) < commands
    text = PAGE.read_text(encoding="utf-8")
    assert all(f"`{prefix}`" in text or f".{prefix}`" in text for prefix in PREFIXES)


def test_all_names_of_the_page_are_those_declared_here() -> None:
    text = PAGE.read_text(encoding="utf-8").replace("\n", " ")
    head = text[text.index("Declared here") : text.index("| what |")]
    named = {canonical_token(piece) for piece in head.split("`")[1::2]}
    assert named == set(SYMBOLS)


@pytest.mark.parametrize(("what", "latex", "plain"), READ, ids=[row[0] for row in READ])
def test_a_row_is_read_alike_from_latex_and_from_plain_text(
    what: str, latex: str, plain: str
) -> None:
    printed = read_formula(latex, SYMBOLS).readings
    typed = read_plain(plain, SYMBOLS).readings
    assert len(printed) == len(typed) == (2 if "two readings" in what else 1)
    for reading, other in zip(printed, typed, strict=True):
        assert reading.relations == other.relations
        assert reading.conditions == other.conditions
        assert reading.connective == other.connective


@pytest.mark.parametrize(("what", "latex", "plain"), READ, ids=[row[0] for row in READ])
def test_a_row_is_printed_and_read_again(what: str, latex: str, plain: str) -> None:
    for reading in read_formula(latex, SYMBOLS).readings:
        for again in (
            read_formula(reading_to_latex(reading), SYMBOLS),
            read_plain(reading_to_plain(reading), SYMBOLS),
        ):
            (found,) = again.readings
            assert found.relations == reading.relations
            assert found.conditions == reading.conditions


@pytest.mark.parametrize(("latex", "why"), REFUSED, ids=[row[0] for row in REFUSED])
def test_a_row_is_refused(latex: str, why: str) -> None:
    with pytest.raises(ReaderError) as caught:
        read_formula(latex, SYMBOLS)
    assert why in caught.value.problem
