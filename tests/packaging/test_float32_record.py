"""The record of the float32 sweep says what its rows say, and of kernels as they are."""

from __future__ import annotations

import re
from dataclasses import replace

import flint
import numpy as np
import pytest
from float32_rows import KERNELS, RECORD, document, fails, rows_of, same_digest

from gainproof.bench.accuracy import ball_outputs
from gainproof.campaign.float32.reference import reference
from gainproof.campaign.float32.report import HEAD

TEXT = RECORD.read_text(encoding="utf-8")
ROWS = list(rows_of(TEXT))
LAST_DIGIT = 0.51e-4
"""Half of it, and a little more for what the reference leaves in doubt."""
CURRENT = [row for row in ROWS if row.digest in same_digest()]
SLOW = "alpha_beta_gamma.random_jerk_by_lag"
"""At large lags the map of its fixed point contracts too slowly for the balls, which hold nothing.
"""
MODULES = sorted({same_digest()[row.digest][0].partition(".")[0] for row in CURRENT})


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


@pytest.mark.thorough
@pytest.mark.parametrize(
    "module", sorted({same_digest()[r.digest][0].split(".")[0] for r in CURRENT})
)
def test_worst_errors_are_those_of_balls(module: str) -> None:
    """At the inputs that are recorded, by enclosures that share no code with the sweep."""
    for row in CURRENT:
        name = same_digest()[row.digest][0]
        if name.split(".")[0] != module:
            continue
        kernel = KERNELS[name]
        graph = reference(kernel).kernel.graph
        symbol = kernel.signature.inputs[0].name
        for place, (line, promise) in enumerate(zip(row.lines, kernel.stated, strict=True)):
            x = np.array([float(line[HEAD.index("worst at")])], np.float32)
            exact = ball_outputs(graph, {symbol: float(x[0])})
            scale = exact[promise.scale or line[3]]
            if name == SLOW and not scale.is_finite():
                continue
            error = abs((flint.arb(float(kernel.function(x)[place][0])) - exact[line[3]]) / scale)
            assert abs(float(error.mid()) * 2**23 - float(line[5])) < LAST_DIGIT, (name, line)


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
