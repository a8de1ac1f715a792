"""Shapes of all parts of a formula, and zeros given the shape that their place wants."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from gainproof.verify.judge.matrices.letters import Letter, MatrixSetting
from gainproof.verify.judge.matrices.size import ONE, ZERO, Shape, Size, Sizes
from gainproof.verify.judge.matrices.tree import FRACTION, INNER, REGULAR, Chain, Node

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
    added: dict[str, Letter] = field(default_factory=dict)
    """Letters that are a number times a unit matrix, made where a number stands before a matrix."""

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
                return (self.added.get(node.name) or self.letters[node.name]).shape
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
                if node.name == FRACTION and inner not in (None, (ONE, ONE)):
                    raise ShapeFault(f"a fraction over a matrix of shape {self.said(inner)}")
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
        return self._placed(self._arranged(node))[0]

    def _arranged(self, node: Node) -> tuple[Node, ...]:
        """The factors of a product; a number made of columns, as that below the line in
        P x x' P/(1 + x' P x), between a column and a row.
        """
        try:
            self._placed(node.parts)
        except UnsaidShapeError:
            flat = [q for p in node.parts for q in (p.parts if p.kind == "product" else (p,))]
            numbers = [p for p in flat if self.of(p) == (ONE, ONE) and self.spread(p, ONE) is None]
            others = [p for p in flat if p not in numbers]
            shapes = [self.of(p) for p in others]
            cut = next(
                (k for k, shape in enumerate(shapes[:-1], 1) if shape and shape[1] == ONE), 0
            )
            if not numbers or not cut:
                raise
            return (*others[:cut], *numbers, *others[cut:])
        return node.parts

    def _placed(self, parts: Sequence[Node]) -> tuple[Shape | None, dict[int, Size]]:
        """The shape of a product, and the sizes of the unit matrices that numbers in it are to be
        multiplied by.
        """
        total: Shape | None = None
        placed: dict[int, Size] = {}
        numbers: list[int] = []  # the parts so far, if all are numbers
        for at, part in enumerate(parts):
            shape = self.of(part)
            if shape is None:
                continue
            if total is None or total[1] == shape[0]:
                only = len(numbers) == at and self.spread(part, ONE) is not None
                numbers += [at] if only else []
            elif total == (ONE, ONE) and len(numbers) == at:
                placed |= dict.fromkeys(numbers, shape[0])
                total = (shape[0], shape[0])
            elif shape == (ONE, ONE) and self.spread(part, ONE) is not None:
                placed[at] = total[1]
                shape = (total[1], total[1])
            elif (ONE, ONE) in (total, shape):
                larger = shape if total == (ONE, ONE) else total
                raise UnsaidShapeError(
                    "a matrix of one row and column stands beside one of shape "
                    f"{self.said(larger)}: of numbers before a matrix of any size only letters and "
                    "what is made of these and digits are within reach"
                )
            else:
                shown = f"{self.said(total)} by one of shape {self.said(shape)}"
                raise ShapeFault(
                    f"a matrix of shape {shown} is multiplied: {shown_columns(self, total, shape)}"
                )
            total = (total[0] if total is not None else shape[0], shape[1])
        return total, placed

    def spread(self, node: Node, size: Size) -> Node | None:
        """A number made of letters and digits times the unit matrix of a size; None for others."""
        match node.kind:
            case "name":
                letter = self.letters[node.name]
                if letter.variance is not None or letter.shape != (ONE, ONE):
                    return None
                own = letter.spread(size, self.sizes)
                if own.name not in self.added:
                    if letter.definition is not None:
                        inner = self.spread(letter.definition, size)
                        if inner is None:
                            return None
                        own = replace(own, facts=(), definition=inner, scalar="")
                    self.added[own.name] = own
                return node if size == ONE else replace(node, name=own.name)
            case "number":
                return Node("product", (node, Node("unit", shape=(size, size))))
            case "unit" | "zero" if node.shape in (None, (ONE, ONE)):
                return replace(node, shape=(size, size))
            case "sum" | "product" | "negative" | "inverse" | "transpose":
                parts = [self.spread(part, size) for part in node.parts]
                known = tuple(part for part in parts if part is not None)
                return replace(node, parts=known) if len(known) == len(parts) else None
            case "matrix" if node.size == (1, 1):
                return self.spread(node.parts[0], size)
            case _:
                return None

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
            case "product":
                factors = self._arranged(node)
                placed = self._placed(factors)[1]
                parts = [
                    self.spread(p, placed[at]) if at in placed else self.filled(p, self.of(p))
                    for at, p in enumerate(factors)
                ]
                return replace(node, parts=tuple(p for p in parts if p is not None))
            case _:
                return replace(node, parts=tuple(self.filled(p, self.of(p)) for p in node.parts))

    def with_added(self, setting: MatrixSetting, *, every: bool = False) -> MatrixSetting:
        """The setting with numbers times unit matrices of all sizes: those numbers of which one was
        made, or every one.
        """
        made = [letter for letter in self.added.values() if letter.shape != (ONE, ONE)]
        scalars = {letter.scalar for letter in made}
        sizes = dict.fromkeys(s for letter in self.letters.values() for s in letter.shape)
        spread = [
            letter.spread(size, self.sizes)
            for name, letter in self.letters.items()
            if name in scalars or (every and self.spread(Node("name", name=name), ONE) is not None)
            for size in sizes
            if size != ONE and letter.definition is None
        ]
        spread += [letter for letter in made if letter.definition is not None]
        return replace(setting, letters={**setting.letters, **{one.name: one for one in spread}})

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
