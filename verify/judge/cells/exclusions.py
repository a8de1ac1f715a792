"""Borders inside the domain on which a statement fails or has no value, in words."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

from gainproof.verify.judge.cells.ground import as_expr
from gainproof.verify.judge.cells.one_sign import keeps_sign
from gainproof.verify.judge.cells.piece import Part, Piece, all_pieces
from gainproof.verify.judge.cells.task import Task
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.place import Place
from gainproof.verify.judge.exact.region import region_text
from gainproof.verify.judge.exact.tidy import tidied
from gainproof.verify.judge.exact.truth import SKIPPED, TRUE

Chain = tuple[Expr, ...]
"""The polynomials that are zero on a border, a border of this, and so on."""


def exclusions(
    found: Sequence[Part],
    above: int,
    used: set[Expr],
    elsewhere: Callable[[Task], bool],
    labels: Mapping[str, str],
) -> tuple[list[str], bool]:
    """What is left out of the set of truth; False if more is left out than need be, as far as
    `elsewhere` can tell for a border: whether it holds on no smaller border of it.

    `above` is the length of the chain of the task itself; borders in `used` are named elsewhere.
    """
    texts: dict[str, None] = {}
    exact = True
    gone: set[Chain] = set()

    def here(chain: Chain) -> list[Part]:
        return [p for p in found if p.task.border[above:] == chain]

    def below(chain: Chain) -> list[Piece]:
        return all_pieces([p for p in found if p.task.border[above:][: len(chain)] == chain])

    def of_lines(chain: Chain) -> bool:
        kept = any(p.truth == TRUE for p in below(chain))
        return kept and all(_is_small(p) for p in here(chain))

    chains = {p.task.border[above:]: None for p in found if len(p.task.border) > above}
    # what is left out as a whole comes first, and is not named again point by point
    for chain in sorted(chains, key=lambda chain: (len(chain), of_lines(chain))):
        if chain[0] in used or any(chain[:k] in gone for k in range(1, len(chain) + 1)):
            continue
        whole = {link[0] for link in gone if len(link) == 1}
        kept = [p for p in below(chain) if p.truth == TRUE]
        # where it has no point but on smaller borders, these are named unless it fails on them all
        pieces = all_pieces(here(chain)) if kept else below(chain)
        if all(_lies_on(p, whole) for p in _wrong(pieces)):
            continue
        if of_lines(chain):
            told = (t for part in here(chain) for t in _of_line(part, chain, whole, labels))
            texts |= dict.fromkeys(told)
            continue
        # on a border with cells of both kinds the borders of these were not all looked at
        parts = here(chain)
        exact = (
            exact
            and not kept
            and all(p.sampled or _is_small(p) or elsewhere(p.task) for p in parts)
        )
        gone.add(chain)
        texts[_whole(chain, labels)] = None
    return list(texts), exact


def _is_small(part: Part) -> bool:
    """Whether it is a line, with all its places."""
    return len(part.task.names) < 2


def _wrong(pieces: Sequence[Piece]) -> list[Piece]:
    return [p for p in pieces if p.truth not in (TRUE, SKIPPED)]


def _lies_on(piece: Piece, borders: Iterable[Expr]) -> bool:
    """Whether it is seen that a polynomial of these is zero on a piece."""
    values = list(piece.task.solved)
    at = piece.place.at
    if at is not None and at.is_rational:
        values += [(name, number(at.low)) for name in piece.task.names[:1]]
    for border in borders:
        moved = border
        for name, value in values:
            moved = substituted(moved, {name: value})
        if tidied(moved) == number(0):
            return True
    return False


def zeros(chain: Chain, labels: Mapping[str, str]) -> str:
    """The equations of a border."""
    return " and ".join(f"{labelled(expr, labels)} = 0" for expr in chain)


def _whole(chain: Chain, labels: Mapping[str, str]) -> str:
    if len(chain) == 1:
        return f"{labelled(chain[0], labels)} != 0"
    return f"except where {zeros(chain, labels)}"


def _of_line(
    part: Part, chain: Chain, whole: Iterable[Expr], labels: Mapping[str, str]
) -> list[str]:
    """What is left out of a border with one parameter, or of a point, and lies on none of the
    borders that are left out as a `whole`.
    """
    wrong = [p for p in _wrong(part.pieces) if not _lies_on(p, whole)]
    if not wrong:
        return []
    solved, value = part.task.solved[-1]
    where = f"{labels.get(solved, solved)} = {labelled(value, labels)}"
    before = f"{zeros(chain[:-1], labels)} and {where}" if len(chain) > 1 else where
    name = next(iter(part.task.names), None)
    if name is None or len(wrong) == len([p for p in part.pieces if p.truth != SKIPPED]):
        return [f"except where {before}"]
    places = [p.place for p in wrong if isinstance(p.place, Place)]
    return [f"except where {before} and ({region_text(places, labels.get(name, name))})"]


def apart_from_borders(part: Part, labels: Mapping[str, str]) -> list[str]:
    """That nothing is said about any border."""
    if part.question is None:
        return []
    boxes = [part.task.boxes[name] for name in part.task.names]
    met = [p for p in part.question.borders() if not keeps_sign(p, boxes, closed=True)]
    borders = [labelled(as_expr(p, part.task.names), labels) for p in met]
    return [f"and none of these zero: {'; '.join(borders)}"] if borders else []
