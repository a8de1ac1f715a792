"""Claim files in short form read as what they stand for, errors at their places included."""

from __future__ import annotations

import pytest

from gainproof.verify.judge.claim.errors import ClaimFileError
from gainproof.verify.judge.claim.file import read_claim_text

SHORT = r"""format = "gainproof claims 1"
claims = ['\beta = \frac{\alpha^2}{2 - \alpha}', 'x + 1/x >= 2',
  '\alpha \to 1 \quad (\Lambda \to \infty)']
[source]
title = "Notes"
"""
LONG = r"""format = "gainproof claims 1"
[source]
key = "notes"
title = "Notes"
authors = ["unknown"]
publication = "unpublished"
[settings.filter]
title = "a Kalman filter in its steady state"
kind = "steady_state"
model = "search"
[settings.filter.symbols]
'\beta' = { quantity = "gain.2", meaning = "gain of the velocity" }
'\alpha' = { quantity = "gain.1", meaning = "gain of the position" }
'\Lambda' = { quantity = "tracking_index", meaning = "tracking index" }
[settings.numbers]
title = "real numbers"
kind = "algebra"
[settings.numbers.symbols]
'x' = { unit = "1", meaning = "real number" }
[[claims]]
id = "1"
place = "formula 1"
kind = "identity"
setting = "filter"
latex = '\beta = \frac{\alpha^2}{2 - \alpha}'
[[claims]]
id = "2"
place = "formula 2"
kind = "inequality"
setting = "numbers"
plain = 'x + 1/x >= 2'
[[claims]]
id = "3"
place = "formula 3"
kind = "limit"
setting = "filter"
latex = '\alpha \to 1 \quad (\Lambda \to \infty)'
"""


def test_the_short_form_is_the_long_one() -> None:
    short, long = (read_claim_text(text, "a folder/notes.toml") for text in (SHORT, LONG))
    assert short.source == long.source
    assert dict(short.settings) == dict(long.settings)
    for one, other in zip(short.claims, long.claims, strict=True):
        # the lines differ
        assert (one.id, one.kind, one.setting, one.formula) == (
            *(other.id, other.kind, other.setting),
            other.formula,
        )


@pytest.mark.parametrize(
    ("path", "key"), [("a/my paper.toml", "my-paper"), ("_.toml", "source"), ("Ä.toml", "source")]
)
def test_a_source_with_a_title_has_the_key_of_its_file(path: str, key: str) -> None:
    assert read_claim_text(SHORT, path).source.key == key


def test_usual_symbols_beside_those_that_are_said() -> None:
    text = LONG.replace("[settings.filter.symbols]", "[symbols]").replace(
        'model = "search"\n', 'model = "search"\nsymbols = "usual"\n'
    )
    text = text.replace(
        "'\\beta' = { quantity = \"gain.2\"", "'\\beta' = { quantity = \"filter_gain.2\""
    )
    text = text.replace(
        '\'\\alpha\' = { quantity = "gain.1", meaning = "gain of the position" }\n', ""
    )
    symbols = read_claim_text(text).settings["filter"].symbols
    assert symbols["\\beta"].quantity == "filter_gain.2"
    assert symbols["\\alpha"].quantity == "gain.1"


@pytest.mark.parametrize(
    ("old", "new", "message", "line"),
    [
        ("x + 1/x >= 2", "x + 1/ >= 2", "wanted", 2),
        (r"\frac{\alpha^2}{2 - \alpha}", r"\fraction{\alpha^2}{2 - \alpha}", "fraction", 2),
        ("'x + 1/x >= 2'", "7", "claims", None),
        ('title = "Notes"', 'title = "Notes"\n[settings.a]\n[settings.b]', "setting", None),
        ('title = "Notes"', "year = 2", "title: this field is missing", 4),
        ("'x + 1/x >= 2'", "", "", None),
    ],
)
def test_errors_have_their_places(old: str, new: str, message: str, line: int | None) -> None:
    text = SHORT.replace(old, new)
    if not message:
        assert len(read_claim_text(text.replace(", ,", ",")).claims) == 2
        return
    with pytest.raises(ClaimFileError, match=message) as found:
        read_claim_text(text)
    if line is not None:
        assert found.value.line == line
