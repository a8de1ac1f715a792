"""Names for the blocks of a letter, from the field `blocks` of its table."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.claim.fields import Fields
from gainproof.verify.judge.matrices.letter import DEFINITE, FACTS, SEMIDEFINITE, SYMMETRIC
from gainproof.verify.judge.matrices.size import Size
from gainproof.verify.judge.matrices.symbol import canonical
from gainproof.verify.judge.matrices.tree import Node
from gainproof.verify.judge.reader.errors import ReaderError

MOST_BLOCKS = 6


def cells_of(owner: str, entries: Mapping[str, Fields]) -> list[tuple[str, tuple[str, int, int]]]:
    """Names of blocks, each with the matrix it is a block of, its row and column."""
    fields = entries[owner]
    value = fields.take("blocks")
    if value is None:
        return []
    rows = value if isinstance(value, list) else []
    width = len(rows[0]) if rows and isinstance(rows[0], list) else 0
    if (
        not 1 <= width <= MOST_BLOCKS
        or len(rows) > MOST_BLOCKS
        or any(not isinstance(row, list) or len(row) != width for row in rows)
    ):
        raise fields.fail("blocks", "rows of names of one length are wanted")
    found: list[tuple[str, tuple[str, int, int]]] = []
    mirrored: list[tuple[str, tuple[str, int, int]]] = []
    for i, row in enumerate(rows):
        for j, cell in enumerate(row):
            bare = str(cell).strip()
            turned = bare.endswith(("^T", "^{T}"))
            try:
                name = canonical(bare.removesuffix("^T").removesuffix("^{T}"))
            except ReaderError as error:
                raise fields.fail("blocks", f"not a symbol: {error.problem}") from error
            if name not in entries:
                raise fields.fail("blocks", f"{name} is not declared")
            (mirrored if turned else found).append((name, (owner, *((j, i) if turned else (i, j)))))
    names = [name for name, _ in found]
    if len(set(names)) < len(names):
        raise fields.fail("blocks", "a name stands in two places")
    for entry in mirrored:
        if entry not in found:
            raise fields.fail("blocks", f"{entry[0]}^T is not opposite to {entry[0]}")
    facts = {DEFINITE, SEMIDEFINITE, SYMMETRIC} & set(fields.texts("is", len(FACTS)))
    if mirrored and not facts and not fields.has("definition"):
        raise fields.fail("blocks", f"{owner} is not said to be symmetric")
    return found


def picked(sizes: list[Size], at: int) -> Node:
    """The columns of the unit matrix that belong to one of its blocks."""
    cells = tuple(
        Node("unit", shape=(size, size)) if number == at else Node("zero", shape=(size, sizes[at]))
        for number, size in enumerate(sizes)
    )
    return Node("matrix", cells, size=(len(cells), 1))
