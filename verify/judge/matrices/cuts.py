"""Where sizes are cut into blocks, so that all block matrices of a statement fit together."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise

from gainproof.verify.judge.matrices.instance import Unsupported
from gainproof.verify.judge.matrices.letter import MatrixSetting
from gainproof.verify.judge.matrices.opened import opened
from gainproof.verify.judge.matrices.shapes import Shapes
from gainproof.verify.judge.matrices.size import ZERO, Size
from gainproof.verify.judge.matrices.tree import Node

MOST_ATOMS = 12
MOST_ROUNDS = 50
Piece = tuple[Size, Size, Size]
"""A size, the place in it where a block begins, the size of the block."""


def pieces_of(nodes: Iterable[Node], setting: MatrixSetting) -> set[Piece]:
    """The blocks of all matrices in formulas and in the definitions that they use."""
    shapes = Shapes(setting.letters, setting.sizes)
    found: set[Piece] = set()
    for part in opened(nodes, setting.letters, variances=True):
        if part.kind == "matrix":
            for sizes in shapes.blocks(part):
                whole, place = sum(sizes, ZERO), ZERO
                for size in sizes:
                    if size not in (whole, ZERO):
                        found.add((whole, place, size))
                    place = place + size
    return found


def cuts_of(pieces: Iterable[Piece]) -> dict[Size, list[Size]]:
    """The sizes of the blocks of each size that is cut, the finest that any matrix wants; a block
    is not cut again. Raises Unsupported where places cannot be compared for every size.
    """
    pieces = sorted(pieces, key=str)
    places: dict[Size, set[Size]] = {}
    for whole, start, size in pieces:
        places.setdefault(whole, set()).update(p for p in (start, start + size) if inside(p, whole))
    for _ in range(MOST_ROUNDS):
        before = {size: set(found) for size, found in places.items()}
        for whole, start, size in pieces:
            within = {p - start for p in places[whole] if inside(p - start, size)}
            if within or size in places:
                places.setdefault(size, set()).update(within)
                places[whole] |= {start + p for p in places[size]}
        for whole in list(places):
            start = ZERO
            for size in _between(whole, places[whole]):
                if size != whole:
                    places[whole] |= {start + p for p in places.get(size, ())}
                start = start + size
        if places == before:
            return {size: _between(size, found) for size, found in places.items() if found}
    raise Unsupported("blocks are cut again and again")


def inside(place: Size, whole: Size) -> bool:
    """Whether a place lies between 0 and the whole, at neither."""
    if place in (ZERO, whole):
        return False
    if place.is_never_negative and (whole - place).is_never_negative:
        return True
    if place.times(-1).is_never_negative or (place - whole).is_never_negative:
        return False
    raise Unsupported(f"whether blocks of size {whole} overlap at {place} depends on the sizes")


def _between(whole: Size, places: set[Size]) -> list[Size]:
    """The sizes between neighbouring places."""
    if len(places) >= MOST_ATOMS:
        raise Unsupported(f"more than {MOST_ATOMS} blocks")
    ordered: list[Size] = []
    for place in sorted(places, key=str):
        at = 0
        while at < len(ordered) and not (ordered[at] - place).is_never_negative:
            if not (place - ordered[at]).is_never_negative:
                raise Unsupported(
                    f"which of {place} and {ordered[at]} is larger depends on the sizes"
                )
            at += 1
        ordered.insert(at, place)
    ends = [ZERO, *ordered, whole]
    return [after - before for before, after in pairwise(ends)]
