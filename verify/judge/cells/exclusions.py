"""Borders inside the domain on which a statement fails or has no value, in words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gainproof.verify.judge.cells.names import shown
from gainproof.verify.judge.cells.pieces import Piece
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.truth import SKIPPED, TRUE

Chain = tuple[Expr, ...]


def exclusions(pieces: Sequence[Piece], labels: Mapping[str, str]) -> list[str]:
    """`... != 0` for each border that is left out, or where on it."""
    present = [p for p in pieces if p.task.border and p.truth != SKIPPED]
    found: dict[str, None] = {}
    for chain in _chains(present, ()):
        if len(chain) == 1:
            found[f"{shown(chain[0], labels)} != 0"] = None
        else:
            zeros = " and ".join(f"{shown(expr, labels)} = 0" for expr in chain)
            found[f"except where {zeros}"] = None
    return list(found)


def _chains(pieces: Sequence[Piece], above: Chain) -> list[Chain]:
    """The shortest chains of borders below which everything is wrong.

    Where a border is wrong in some of its cells only it is named whole.
    """
    found: list[Chain] = []
    size = len(above)
    for here in dict.fromkeys(p.task.border[size] for p in pieces if len(p.task.border) > size):
        below = [p for p in pieces if p.task.border[size : size + 1] == (here,)]
        wrong = [p for p in below if p.truth != TRUE]
        if not wrong:
            continue
        chain = (*above, here)
        direct = any(len(p.task.border) == size + 1 for p in wrong)
        found += [chain] if direct or len(wrong) == len(below) else _chains(below, chain)
    return found
