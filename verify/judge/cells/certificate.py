"""What is kept of a decision over cells: projections, isolating intervals, samples, borders."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.verify.judge.cells.cell_truth import Part, Piece
from gainproof.verify.judge.cells.irrational_points import Corner
from gainproof.verify.judge.cells.lifting import Between, Cell
from gainproof.verify.judge.exact.algebraic_numbers import Algebraic
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.certificate import statement_data
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.exact.statement import Statement

Data = dict[str, Any]
MOST_PIECES = 200
MOST_ON_A_BORDER = 20
MOST_BORDERS = 60


def cells_certificate(
    statement: Statement, boxes: Mapping[str, Box], found: Sequence[Part], labels: Mapping[str, str]
) -> Data:
    """Everything another program needs to go through the same steps."""
    first = found[0]
    names = {f"x{k}": name for k, name in enumerate(first.task.names, start=1)}
    return {
        "checked": "replayed",
        "engine": "cells",
        "statement": statement_data(statement, boxes, None, labels),
        "variables": {short: labels.get(full, full) for short, full in names.items()},
        **_part(first, MOST_PIECES, labels),
        "count of borders": len(found) - 1,
        "borders": [
            {
                "zero": [f"{labelled(expr, labels)} = 0" for expr in part.task.border],
                "put in": [
                    f"{labels.get(name, name)} = {labelled(expr, labels)}"
                    for name, expr in part.task.solved
                ],
                "parameters": [labels.get(name, name) for name in part.task.names],
                **_part(part, MOST_ON_A_BORDER, labels),
            }
            for part in found[1 : 1 + MOST_BORDERS]
        ],
    }


def _part(part: Part, most: int, labels: Mapping[str, str]) -> Data:
    """The first pieces as they are, and how many there are of each truth."""
    found: Data = {"tower": part.pieces[0].local.tower.relations_text() if part.pieces else []}
    if part.projection is not None:
        found["candidates"] = [str(cut) for cut in part.cuts]
        found["of one sign"] = [str(p) for p in part.projection.dropped]
        found["projection"] = [
            {"variable": f"x{level.index + 1}", "polynomials": [str(p) for p in level.polys]}
            for level in part.projection.levels
        ]
    found["count"] = dict(sorted(Counter(piece.truth for piece in part.pieces).items()))
    found["places"] = [_piece(piece, labels) for piece in part.pieces[:most]]
    return found


def _piece(piece: Piece, labels: Mapping[str, str]) -> Data:
    names = piece.task.names
    label = labels.get(names[0], names[0]) if names else ""
    place = piece.place
    found: Data = {"found": piece.truth, "balls": list(dict.fromkeys(piece.local.steps))[:4]}
    if isinstance(place, Cell):
        found["between"] = {f"x{side.index + 1}": _sides(side) for side in place.sides}
        found["samples"] = [", ".join(str(v) for v in sample) for sample in place.samples]
        found["place"] = ", ".join(
            f"{labels.get(name, name)} = {value}"
            for name, value in zip(names, place.samples[0], strict=True)
        )
    elif isinstance(place, Corner):
        texts = [a.text() for a in place.coordinates]
        found["samples"] = [", ".join(texts)]
        found["place"] = ", ".join(
            f"{labels.get(name, name)} = {text}" for name, text in zip(names, texts, strict=True)
        )
    elif isinstance(place, Place):
        found["samples"] = [str(sample) for sample in place.samples]
        found["place"] = place.text(label)
    return found


def _sides(side: Between) -> list[str | None]:
    return [None if number is None else _interval(number) for number in (side.left, side.right)]


def _interval(number: Algebraic) -> str:
    return str(number.low) if number.is_rational else f"[{number.low}, {number.high}]"
