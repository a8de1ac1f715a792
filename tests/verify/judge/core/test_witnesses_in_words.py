"""A witness says what it shows, from which its words are made."""

from __future__ import annotations

import pytest
from small_claims import judged

from gainproof.verdicts.witness_text import in_words

FALLING = "about = ['3 - 2 x', 'x']\ntrend = 'increasing'\ntext = 'it rises'"
ROWS = r"\begin{pmatrix} x & 1 \end{pmatrix} = \begin{pmatrix} x & 2 \end{pmatrix}"


@pytest.mark.parametrize(
    ("kind", "fields", "shows", "told"),
    [
        ("monotone", FALLING, "slope", "the derivative is -2, not above 0"),
        ("equivalence", r"x > 0 \Leftrightarrow x > 1", "truth of sides",
         "the left side of the equivalence holds, the right does not hold"),
        ("identity", ROWS, "entry", "in entry (1, 2) the left side is 1, the right 2"),
        ("identity", "x + 1 = x", None, "at x = 0 the left side is 1, the right 0"),
    ],
)  # fmt: skip
def test_what_is_shown_is_told(kind: str, fields: str, shows: str | None, told: str) -> None:
    found = judged(kind, fields)
    assert found.witness is not None
    assert found.witness.get("shows") == shows
    assert told in in_words(found.witness)
