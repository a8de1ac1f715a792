"""The limit on the text of a number follows from that on its bits."""

from __future__ import annotations

from fractions import Fraction

import pytest

from gainproof.verify.certificate.rejection import (
    MAXIMUM_COEFFICIENT_BITS,
    MAXIMUM_TEXT,
    GivenUpError,
)
from gainproof.verify.certificate.schema import number

GREATEST = (1 << MAXIMUM_COEFFICIENT_BITS) - 1


@pytest.mark.parametrize(
    "value", [GREATEST, Fraction(-GREATEST, GREATEST - 1), Fraction(1, GREATEST)]
)
def test_whatever_has_the_bits_has_the_text(value: Fraction) -> None:
    assert len(str(value)) <= MAXIMUM_TEXT
    assert number(str(value), "here") == value


def test_what_is_longer_is_given_up_and_not_called_wrong() -> None:
    with pytest.raises(GivenUpError, match=r"given up: a number of \d+ characters"):
        number("7" * (MAXIMUM_TEXT + 1), "here")
