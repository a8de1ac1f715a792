"""Shapes of all parts of a formula, and zeros given the shape that their place wants."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from gainproof.verify.judge.matrices.letter import Letter
from gainproof.verify.judge.matrices.size import ONE, ZERO, Shape, Size, Sizes
from gainproof.verify.judge.matrices.tree import INNER, REGULAR, Chain, Node

MOST_NODES = 3000


class ShapeFault(ValueError):
    """Shapes that do not fit; the text says which."""


class UnsaidShapeError(ShapeFault):
    """A shape that what is printed leaves open."""


@dataclass(frozen=True)
class Shapes:
    """Shapes of the letters declared so far. A number has the shape None."""

    letters: Mapping[str, Letter]
    sizes: Sizes

    def said(self, shape: Shape | None) -> str:
        """`n x 3`."""
        if shape is None:
            return "a number"
        rows, columns = (self.sizes.shown(size) for size in shape)
        return f"{_bracketed(rows)} x {_bracketed(columns)}"

    def of(self, node: Node) -> Shape | None:
        """The shape. Raises ShapeFault."""
        found = self._found(node)
        if found == "any":
            raise UnsaidShapeError("that of a zero is not said")
        return found  # type: ignore[return-value]

    def _found(self, node: Node) -> Shape | str | None:
        """As `of`, but "any" for a zero whose shape is not said."""
        match node.kind:
            case "name":
                return self.letters[node.name].shape
            case "number":
                return None
            case "unit" | "zero":
                return node.shape or "any"
            case "negative" | "expectation":
                return self._found(node.parts[0])
            case "transpose":
                inner = self._found(node.parts[0])
                return (inner[1], inner[0]) if isinstance(inner, tuple) else inner
            case "inverse":
                inner = self.of(node.parts[0])
                if inner is not None and inner[0] != inner[1]:
                    raise ShapeFault(f"an inverse of a matrix of shape {self.said(inner)}")
                return inner
            case "sum":
                return self.common(node.parts, "are added")
            case "product":
                return self._product(node)
            case _:
                heights, widths = self.blocks(node)
                return sum(heights, ZERO), sum(widths, ZERO)

    def common(self, parts: tuple[Node, ...], what: str) -> Shape | str | None:
        """The one shape of all. A number beside a matrix is one of a single row and column."""
        shapes = [s for s in map(self._found, parts) if s != "any"]
        if not shapes:
            return "any"
        matrices = [s for s in shapes if s is not None]
        found = matrices[0] if matrices else None
        if found is not None and len(matrices) < len(shapes) and found != (ONE, ONE):
            raise ShapeFault(f"a number and a matrix of shape {self.said(found)} {what}")  # type: ignore[arg-type]
        for other in matrices:
            if other != found:
                shown = f"{self.said(found)} and {self.said(other)}"  # type: ignore[arg-type]
                raise ShapeFault(f"matrices of shapes {shown} {what}")
        return found

    def _product(self, node: Node) -> Shape | str | None:
        if node.name == INNER:
            left, right = node.parts[0].parts[0], node.parts[1]
            for part in (left, right):
                shape = self.of(part)
                if shape is None or shape[1] != ONE:
                    raise ShapeFault(f"(x, y) is of two columns, not of shape {self.said(shape)}")
        total: Shape | None = None
        for part in node.parts:
            shape = self.of(part)
            if shape is None:
                continue
            if total is not None and total[1] != shape[0]:
                if (ONE, ONE) in (total, shape):
                    larger = shape if total == (ONE, ONE) else total
                    raise UnsaidShapeError(
                        "a matrix of one row and column stands beside one of shape "
                        f"{self.said(larger)}: of numbers before a matrix of any size only those "
                        "in digits, such as 2, are within reach"
                    )
                shown = f"{self.said(total)} by one of shape {self.said(shape)}"
                raise ShapeFault(
                    f"a matrix of shape {shown} is multiplied: {shown_columns(self, total, shape)}"
                )
            total = (total[0] if total is not None else shape[0], shape[1])
        return total

    def blocks(self, node: Node) -> tuple[list[Size], list[Size]]:
        """Heights of the rows and widths of the columns of a matrix of blocks."""
        rows, columns = node.size
        heights: list[Size | None] = [None] * rows
        widths: list[Size | None] = [None] * columns
        for number, cell in enumerate(node.parts):
            shape = self._found(cell)
            if shape == "any":
                continue
            assert not isinstance(shape, str)
            height, width = (ONE, ONE) if shape is None else shape
            for sizes, at, size, what in (
                (heights, number // columns, height, "rows"),
                (widths, number % columns, width, "columns"),
            ):
                known = sizes[at]
                if known is not None and known != size:
                    pair = f"{self.sizes.shown(known)} and {self.sizes.shown(size)}"
                    raise ShapeFault(
                        f"blocks side by side have {pair} {what}"
                        if what == "rows"
                        else f"blocks above one another have {pair} {what}"
                    )
                sizes[at] = size
        if any(size is None for size in (*heights, *widths)):
            raise UnsaidShapeError("that of a row or column of zeros is not said")
        return [h for h in heights if h is not None], [w for w in widths if w is not None]

    def filled(self, node: Node, wanted: Shape | None = None) -> Node:
        """The formula with a shape for every zero, numbers among matrices made matrices. Raises
        ShapeFault.
        """
        match node.kind:
            case "name" | "unit":
                return node
            case "number":
                return node if wanted is None else Node("matrix", (node,), size=(1, 1))
            case "zero":
                return node if node.shape else replace(node, shape=wanted)
            case "transpose":
                turned = None if wanted is None else (wanted[1], wanted[0])
                return replace(node, parts=(self.filled(node.parts[0], turned),))
            case "sum" | "negative" | "expectation":
                own = self._found(node)
                shape = wanted if own in ("any", None) else own
                return replace(node, parts=tuple(self.filled(p, shape) for p in node.parts))  # type: ignore[arg-type]
            case "matrix":
                heights, widths = self.blocks(node)
                columns = node.size[1]
                cells = tuple(
                    cell
                    if cell.kind == "number"
                    else self.filled(cell, (heights[at // columns], widths[at % columns]))
                    for at, cell in enumerate(node.parts)
                )
                return replace(node, parts=cells)
            case _:
                return replace(node, parts=tuple(self.filled(p, self.of(p)) for p in node.parts))

    def chain(self, chain: Chain) -> Chain:
        """All sides of one shape, zeros filled. Raises ShapeFault."""
        if sum(1 for side in chain.sides for _ in side.walk()) > MOST_NODES:
            raise ShapeFault(f"more than {MOST_NODES} parts")
        shape = self.common(chain.sides, "are compared")
        if shape == "any":
            raise UnsaidShapeError("that of a zero is not said")
        wanted = (ONE, ONE) if shape is None else shape
        sides = tuple(self.filled(side, wanted) for side in chain.sides)  # type: ignore[arg-type]
        if chain.operators == (REGULAR,) and wanted[0] != wanted[1]:
            raise ShapeFault(f"an inverse of a matrix of shape {self.said(wanted)}")  # type: ignore[arg-type]
        if any(op not in ("=", REGULAR) for op in chain.operators) and wanted[0] != wanted[1]:
            raise ShapeFault(f"an order of matrices of shape {self.said(wanted)}")  # type: ignore[arg-type]
        return replace(chain, sides=sides)


def shown_columns(shapes: Shapes, left: Shape, right: Shape) -> str:
    """Why they do not fit."""
    return f"{shapes.sizes.shown(left[1])} columns, {shapes.sizes.shown(right[0])} rows"


def _bracketed(text: str) -> str:
    return f"({text})" if " " in text and not text.replace(" ", "").isalnum() else text
