"""Sets of places as text."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import ceil, floor

from gainproof.verify.judge.exact.algebraic_numbers import compare
from gainproof.verify.judge.exact.box import interval_text
from gainproof.verify.judge.exact.places import Place


def region_text(kept: Sequence[Place], name: str, *, integer: bool = False) -> str:
    """The union of places as text: neighbouring places are joined."""
    pieces: list[list[Place]] = []
    for place in kept:
        if pieces and _adjacent(pieces[-1][-1], place, integer):
            pieces[-1].append(place)
        else:
            pieces.append([place])
    shown = _integer_text if integer else _piece_text
    return " or ".join(shown(piece, name) for piece in pieces) or "nowhere"


def _adjacent(a: Place, b: Place, integer: bool) -> bool:
    if integer:
        last, first = _ends(a)[1], _ends(b)[0]
        return last is not None and first == last + 1
    if a.is_cell:
        return b.at is not None and a.right == b.at
    return b.is_cell and a.at is not None and b.left == a.at


def _piece_text(piece: list[Place], name: str) -> str:
    if len(piece) == 1:
        return piece[0].text(name)
    first, last = piece[0], piece[-1]
    left = first.at if first.at is not None else first.left
    right = last.at if last.at is not None else last.right
    ends = ("" if end is None else end.text() for end in (left, right))
    return interval_text(name, ends, first.at is None, last.at is None)


def _ends(place: Place) -> tuple[int | None, int | None]:
    """The first and the last integer of a place that holds one; None without bound."""
    if place.at is not None:
        return int(place.at.low), int(place.at.low)
    first = last = None
    if place.left is not None:
        first = floor(place.left.low)
        while compare(place.left, Fraction(first)) >= 0:
            first += 1
    if place.right is not None:
        last = ceil(place.right.high)
        while compare(place.right, Fraction(last)) <= 0:
            last -= 1
    return first, last


def _integer_text(piece: list[Place], name: str) -> str:
    first, last = _ends(piece[0])[0], _ends(piece[-1])[1]
    if first is None and last is None:
        return f"all {name}"
    if first == last:
        return f"{name} = {first}"
    if last is None:
        return f"{name} >= {first}"
    return f"{name} <= {last}" if first is None else f"{first} <= {name} <= {last}"
