"""Where a statement holds, told by signs of polynomials that single out its cells."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import combinations

from gainproof.verify.judge.cells.cell_truth import Part, Piece
from gainproof.verify.judge.cells.lifting import Cell
from gainproof.verify.judge.cells.parameter_polynomials import as_expr, value_at
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.polynomial import Poly
from gainproof.verify.judge.exact.truth import SKIPPED, TRUE

Signs = tuple[int, ...]
Literal = tuple[Poly, int]
"""A polynomial and the sign it has."""
MOST_TOGETHER = 3
MOST_ALTERNATIVES = 4
MOST_SIGNS = 400


def separating(part: Part) -> list[Literal] | None:
    """The fewest signs that all cells of truth have and no other cell that matters; empty if there
    is no other, None if no such signs exist.
    """
    inside = _signs(part, lambda p: p.truth == TRUE)
    outside = _signs(part, lambda p: p.truth not in (TRUE, SKIPPED))
    if not outside or not inside:
        return []
    chosen = _conjunction(inside, outside)
    if chosen is None:
        return None
    first = next(iter(inside))
    return [(part.cuts[k], first[k]) for k in chosen]


def alternatives(part: Part, labels: Mapping[str, str]) -> str:
    """The cells of truth as a few conjunctions of signs, else by their number and samples."""
    inside = _signs(part, lambda p: p.truth == TRUE)
    outside = _signs(part, lambda p: p.truth not in (TRUE, SKIPPED))
    words = _Words(part, labels)
    groups: dict[Signs, tuple[int, ...] | None] = {}
    if len(inside) <= MOST_SIGNS:
        groups = {signs: _conjunction({signs}, outside) for signs in inside}
    texts = {
        " and ".join(words.condition(k, signs[k]) for k in chosen)
        for signs, chosen in groups.items()
        if chosen
    }
    if groups and all(groups.values()) and len(texts) <= MOST_ALTERNATIVES:
        return f"({' or '.join(sorted(texts))})"
    held = [p for p in part.pieces if p.truth == TRUE]
    points = [words.point(p.place) for p in held[:MOST_ALTERNATIVES] if isinstance(p.place, Cell)]
    return f"on {len(held)} of {len(part.pieces)} cells, among them those of {'; '.join(points)}"


def _signs(part: Part, wanted: Callable[[Piece], bool]) -> set[Signs]:
    """The signs of the cuts on the wanted cells."""
    found = set()
    for piece in part.pieces:
        if wanted(piece) and isinstance(piece.place, Cell):
            point = piece.place.samples[0]
            values = (value_at(cut, point) for cut in part.cuts)
            found.add(tuple((v > 0) - (v < 0) for v in values))
    return found


def _conjunction(inside: Iterable[Signs], outside: Iterable[Signs]) -> tuple[int, ...] | None:
    """The fewest polynomials whose signs are those of all `inside` and of none `outside`."""
    kept, others = list(inside), list(outside)
    first = kept[0]
    common = [k for k in range(len(first)) if all(signs[k] == first[k] for signs in kept)]
    useful = [k for k in common if any(signs[k] != first[k] for signs in others)]
    for size in range(1, min(MOST_TOGETHER, len(useful)) + 1):
        for chosen in combinations(useful, size):
            if all(any(signs[k] != first[k] for k in chosen) for signs in others):
                return chosen
    if all(any(signs[k] != first[k] for k in useful) for signs in others):
        return _thinned(useful, first, others)
    return None


def _thinned(useful: list[int], first: Signs, others: list[Signs]) -> tuple[int, ...]:
    chosen = list(useful)
    for k in list(useful):
        less = [j for j in chosen if j != k]
        if all(any(signs[j] != first[j] for j in less) for signs in others):
            chosen = less
    return tuple(chosen)


class _Words:
    """Polynomials and points of a part in the source's own symbols."""

    def __init__(self, part: Part, labels: Mapping[str, str]) -> None:
        self.cuts: Sequence[Poly] = part.cuts
        self.names, self.labels = part.task.names, labels

    def condition(self, k: int, sign: int) -> str:
        cut = labelled(as_expr(self.cuts[k], self.names), self.labels)
        return f"{cut} {'>' if sign > 0 else '<'} 0"

    def point(self, cell: Cell) -> str:
        pairs = zip(self.names, cell.samples[0], strict=True)
        return ", ".join(f"{self.labels.get(name, name)} = {value}" for name, value in pairs)
