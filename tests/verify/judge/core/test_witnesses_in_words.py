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


@pytest.mark.parametrize(
    ("domain", "claimed", "told"),
    [
        ("b^2 = 2 a^2", "b < a", {"a": "sqrt(1/2)", "b": "1"}),
        ("b^2 = 5 a^2", "b < a", {"a": "sqrt(1/5)", "b": "1"}),
        ("7 a^2 = 3 b^2", "b < a", {"a": "sqrt(3/7)", "b": "1"}),
    ],
)
def test_numbers_side_by_side_are_multiplied(
    domain: str, claimed: str, told: dict[str, str]
) -> None:
    letters = {k: f"{{ unit = '1', domain = '{k} > 0', meaning = 'length' }}" for k in "ab"}
    found = judged("inequality", f"latex = '{claimed}'\ndomain = '{domain}'", letters)
    assert found.witness is not None
    assert found.witness["point"] == told
