"""Words by which parts of a verdict are known: what tells of verdicts takes them from here."""

from __future__ import annotations

from enum import StrEnum

VERDICTS = (
    "proved",
    "refuted",
    "conditional",
    "undefined",
    "held",
    "undecided",
    "definition",
    "remark",
)
"""Verdicts in the order in which they are counted."""
SETTLED = frozenset(VERDICTS) - {"held", "undecided"}


class Shown(StrEnum):
    """What a witness shows, and with it how it is told."""

    SIDES = "sides"
    """Both sides of a relation, where it fails."""
    SLOPE = "slope"
    """A derivative and 0, against a trend."""
    TRUTH = "truth of sides"
    """What each side of an equivalence or implication comes to: the note says it."""
    STABILITY = "stability"
    """Whether a filter is stable: the note says it."""
    ENTRY = "entry"
    """Both sides in one entry of a matrix, which the note names."""


LACKS_VALUE = "a side has no value"
"""The note of a witness at which a side is not defined."""
BOTH_EQUAL = "both sides are equal, exactly"
"""The note of a witness against a relation that holds of no two equal numbers."""
NOT_COMPARED = "not compared"
"""Of the sides of a relation where the note of a witness says what fails."""
NO_REPAIR = "no misprint-like repair found"
"""Within the reason of what was searched for repairs."""

# keys of certificates
ALONE = "would be true with"
"""Of a refuted claim, the convention under which it alone would hold."""
CONTRADICTED = "under the other convention"
"""Of a claim that is true, with its setting, under another convention than the source states."""
OTHERS = "against other conventions"
"""The witnesses against a claim that fits none."""
ROUNDED = "as a rounded number"
"""How a printed decimal was taken."""
STRENGTH = "would hold with"
"""Of a refuted claim, the strength of a noise with which it is proved."""
DECIDES = "decides"
"""The verdict on the statement in the certificate, where another is told of the claim."""
