"""The one way a certificate fails, and the limits that keep every failure quick.

A certificate is untrusted input: whatever it holds, checking it ends in bounded time and memory.
The limits are far above what an honest certificate needs.
"""

from __future__ import annotations

MAXIMUM_PLAIN_VALUES = 1_000_000
MAXIMUM_DEPTH = 24
MAXIMUM_STATEMENTS = 1_000
MAXIMUM_ELEMENTS = 500
MAXIMUM_VARIABLES = 24
MAXIMUM_NODES = 4_000
MAXIMUM_TERMS = 40_000
MAXIMUM_EXPONENT = 1_000
MAXIMUM_POWER = 64
MAXIMUM_ROOT = 12
MAXIMUM_COEFFICIENT_BITS = 8_192
MAXIMUM_NUMBER_TEXT = 2 * (MAXIMUM_COEFFICIENT_BITS * 30_103 // 100_000 + 1) + 2
"""Of the longest quotient within the bits: a bit is log10(2) of a digit; a sign and a bar."""
MAXIMUM_TEXT = max(4_000, MAXIMUM_NUMBER_TEXT)
MAXIMUM_ORDER = 8
MAXIMUM_WORK = 16_000_000


class RejectedError(Exception):
    """The certificate, or one statement of it, is not accepted; the text says what was wanted."""


class MalformedError(RejectedError):
    """It is not even written as the format wants it, so nothing was decided."""


class GivenUpError(RejectedError):
    """It is beyond the limits, so that nothing was decided: it may well be right."""


class Meter:
    """Counts the products of terms formed so far and rejects when there are too many.

    One meter serves a whole check, so that a hostile file is given up after a bounded effort.
    """

    __slots__ = ("remaining",)

    def __init__(self) -> None:
        self.remaining = MAXIMUM_WORK

    def spend(self, work: int) -> None:
        """Count ``work`` more products. Raises RejectedError when the allowance is used up."""
        self.remaining -= work
        if self.remaining < 0:
            raise GivenUpError("given up: more arithmetic than any certificate needs")

    def reset(self) -> None:
        """Allow the full effort again, for a check of its own over towers already read."""
        self.remaining = MAXIMUM_WORK
