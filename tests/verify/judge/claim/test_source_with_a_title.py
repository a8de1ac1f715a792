"""What a claim file may leave out of its source."""

from __future__ import annotations

import pytest

from gainproof.verify.judge.claim.errors import ClaimFileError
from gainproof.verify.judge.claim.file import read_claim_text

SHORT = r"""format = "gainproof claims 1"
[source]
title = "Notes"
[settings.numbers]
title = "real numbers"
kind = "algebra"
[settings.numbers.symbols]
'x' = { unit = "1", meaning = "real number" }
[[claims]]
id = "1"
place = "formula 1"
kind = "inequality"
setting = "numbers"
latex = 'x^2 \\geq 0'
"""


@pytest.mark.parametrize(
    ("path", "key"), [("a/my paper.toml", "my-paper"), ("_.toml", "source"), ("Ä.toml", "source")]
)
def test_a_source_with_a_title_has_the_key_of_its_file(path: str, key: str) -> None:
    source = read_claim_text(SHORT.replace("\\\\", "\\"), path).source
    assert (source.key, source.authors, source.publication) == (key, ("unknown",), "unpublished")


def test_a_source_has_a_title() -> None:
    with pytest.raises(ClaimFileError, match="title: this field is missing"):
        read_claim_text(SHORT.replace('title = "Notes"', "year = 2"))
