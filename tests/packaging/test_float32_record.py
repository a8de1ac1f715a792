"""The record of the float32 sweep says what its rows say, and of kernels as they are."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest
from float32_rows import KERNELS, RECORD, document, fails, rows_of, same_digest

TEXT = RECORD.read_text(encoding="utf-8")
ROWS = list(rows_of(TEXT))
CURRENT = [row for row in ROWS if row.digest in same_digest()]


def test_the_head_counts_the_rows() -> None:
    (found,) = re.findall(r"completed: (\d+) of \d+ kernels of one input,\n(\d+) inputs", TEXT)
    names = [row.lines[0][0].count(".") for row in ROWS]
    inputs = sum(row.inputs * count for row, count in zip(ROWS, names, strict=True))
    assert found == (str(sum(names)), str(inputs))
    assert all(row.whole for row in ROWS)


def test_rows_of_kernels_as_they_are_keep_what_is_stated() -> None:
    """Those of kernels that have changed since say nothing of them."""
    for row in CURRENT:
        (name, *others) = same_digest()[row.digest]
        promised = KERNELS[name].stated
        assert row.lines[0][0] == f"{', '.join([name, *others])} `{row.digest}`"
        assert [line[3] for line in row.lines] == list(KERNELS[name].signature.outputs)
        for line, promise in zip(row.lines, promised, strict=True):
            assert not fails(line, promise), (name, line)


def test_the_document_is_that_of_its_rows() -> None:
    text = document(CURRENT)
    assert list(rows_of(text)) == CURRENT
    if len(CURRENT) == len(ROWS):
        left = re.compile(r" of \d+ kernels|## Not recorded.*", re.DOTALL)
        assert left.sub("", text) == left.sub("", TEXT)
    assert "\nNone." not in text or sum(map(len, same_digest().values())) == len(KERNELS)


def test_a_row_that_is_not_as_stated_is_seen() -> None:
    row = CURRENT[0]
    (line, *rest) = row.lines
    promise = KERNELS[same_digest()[row.digest][0]].stated[0]
    assert not fails(line, promise)
    for column, text in ((5, f"{promise.bound:.4f}"), (5, "inf"), (9, "1")):
        wrong = (*line[:column], text, *line[column + 1 :])
        assert fails(wrong, promise)
        assert "is stated: 1." in document([replace(row, lines=(wrong, *rest))])
    part = TEXT.replace("` |", "`, 2 of 9 blocks |", 1)
    assert [each.whole for each in rows_of(part)] == [False, *(True for _ in ROWS[1:])]
    with pytest.raises(ValueError, match="no row of a kernel"):
        list(rows_of(TEXT.replace(ROWS[0].digest, "none")))
