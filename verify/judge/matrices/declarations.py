"""The symbols of a setting of matrices, from the tables of a claim file."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.claim.errors import FileText
from gainproof.verify.judge.claim.fields import Fields
from gainproof.verify.judge.matrices.letters import (
    DEFINITE,
    FACTS,
    SEMIDEFINITE,
    SYMMETRIC,
    Letter,
    MatrixSetting,
)
from gainproof.verify.judge.matrices.notation import RELATIONS
from gainproof.verify.judge.matrices.printed_names import SQUARE, canonical
from gainproof.verify.judge.matrices.reader import read_matrix
from gainproof.verify.judge.matrices.shapes import ShapeFault, Shapes
from gainproof.verify.judge.matrices.size import ONE, Shape, Size, Sizes, sizes_of
from gainproof.verify.judge.matrices.size_text import read_size
from gainproof.verify.judge.matrices.tree import Node, product, transposed
from gainproof.verify.judge.reader.errors import ReaderError

MOST_LETTERS = 120
MOST_CHAINS = 10
MOST_DEEP = 40
FIELDS = ("meaning", "shape", "is", "definition", "blocks", "variance")
MOST_BLOCKS = 6


def read_sizes(fields: Fields) -> Sizes:
    """The field `sizes`: chains such as `n_b \\leq n`."""
    chains = []
    for text in fields.texts("sizes", MOST_CHAINS):
        names = [text]
        for command, operator in RELATIONS.items():
            if operator == "<=":
                names = [part for name in names for part in name.split(command + " ")]
        try:
            chains.append(tuple(canonical(name.strip()) for name in names))
        except ReaderError as error:
            raise fields.fail("sizes", f"wanted names such as 'n_b \\leq n': {error}") from error
    every = [name for chain in chains for name in chain]
    if len(set(every)) < len(every):
        raise fields.fail("sizes", "a size stands in two places")
    return sizes_of(tuple(chains))


def read_letters(text: FileText, where: str, table: object, sizes: Sizes) -> MatrixSetting:
    """All letters. Raises ClaimFileError with the place."""
    line = text.line_of_table(where)
    if not isinstance(table, Mapping) or not table:
        raise text.error(where, "a table of symbols is wanted", line)
    if len(table) > MOST_LETTERS:
        raise text.error(where, f"more than {MOST_LETTERS} symbols", line)
    entries: dict[str, Fields] = {}
    for token, content in table.items():
        at = text.line_of_key(token, line or 1)
        try:
            name = canonical(token)
        except ReaderError as error:
            raise text.error(
                f"{where}.{token[:80]}", f"not a symbol: {error.problem}", at
            ) from error
        if name in entries or name in sizes.names:
            raise text.error(f"{where}.{token[:80]}", f"{name} is declared twice", at)
        entries[name] = Fields(text, f"{where}.{token[:80]}", content, FIELDS, at)
    return _Declaring(entries, sizes).all()


class _Declaring:
    """Letters declared in the order in which definitions need them."""

    def __init__(self, entries: Mapping[str, Fields], sizes: Sizes) -> None:
        self._entries = entries
        self._sizes = sizes
        self._letters: dict[str, Letter] = {}
        self._shapes = Shapes(self._letters, sizes)
        self._blocks: dict[str, tuple[str, int, int]] = {}
        for owner in entries:
            for name, place in cells_of(owner, entries):
                if name in self._blocks:
                    other = self._blocks[name][0]
                    raise entries[owner].fail("blocks", f"{name} is already a block of {other}")
                self._blocks[name] = place
        self._open: list[str] = []

    def all(self) -> MatrixSetting:
        for name in self._entries:
            self._declare(name)
        return self._shapes.with_added(MatrixSetting(self._sizes, dict(self._letters)))

    def _declare(self, name: str) -> None:
        if name in self._letters:
            return
        fields = self._entries[name]
        if name in self._open or len(self._open) > MOST_DEEP:
            raise fields.fail(
                "definition", f"definitions go in a circle: {' -> '.join(self._open)}"
            )
        self._open.append(name)
        try:
            self._letters[name] = self._letter(name, fields)
        except ShapeFault as fault:
            raise fields.fail("definition", str(fault)) from fault
        self._open.pop()

    def _letter(self, name: str, fields: Fields) -> Letter:
        letter = self._declared(name, fields)
        root = name.removesuffix(SQUARE)
        if root != name and letter.shape != (ONE, ONE):
            raise fields.fail("shape", "a letter with a square behind it has one row and column")
        if root != name and root in self._entries:
            raise fields.fail("meaning", f"{root} is declared too: its square would be two things")
        return letter

    def _declared(self, name: str, fields: Fields) -> Letter:
        meaning = fields.required_text("meaning")
        said, facts = self._said_shape(fields), fields.texts("is", len(FACTS))
        definition = self._node(fields, "definition")
        if name in self._blocks:
            if definition is not None:
                raise fields.fail("definition", f"it is already a block of {self._blocks[name][0]}")
            definition = self._block(name, fields)
        if definition is not None:
            if facts or fields.has("variance"):
                field = "is" if facts else "variance"
                raise fields.fail(field, "of a letter with a definition nothing else can be said")
            shape = self._shapes.of(definition) or (ONE, ONE)
            if said not in (None, shape):
                problem = f"the definition has the shape {self._shapes.said(shape)}"
                raise fields.fail("shape", problem)
            return Letter(name, meaning, shape, definition=self._shapes.filled(definition, shape))
        if said is None:
            raise fields.fail("shape", "this field is missing")
        for fact in facts:
            if fact not in FACTS:
                raise fields.fail("is", f"known are {', '.join(FACTS)}")
            if said[0] != said[1]:
                raise fields.fail("is", f"it has the shape {self._shapes.said(said)}")
        variance = self._node(fields, "variance")
        if variance is not None:
            if said[1] != ONE or self._shapes.of(variance) != (said[0], said[0]):
                raise fields.fail(
                    "variance", "a column, and a square matrix of its size are wanted"
                )
            covariance = variance.kind == "name" and self._letters[variance.name].facts
            if not covariance or not {DEFINITE, SEMIDEFINITE} & set(covariance):
                raise fields.fail(
                    "variance", "a letter that is positive definite or semidefinite is wanted"
                )
        return Letter(name, meaning, said, facts, None, variance)

    def _said_shape(self, fields: Fields) -> Shape | None:
        texts = fields.texts("shape", 2)
        if not texts:
            return None
        if len(texts) != 2:
            raise fields.fail("shape", "rows and columns are wanted")
        try:
            return read_size(texts[0], self._sizes), read_size(texts[1], self._sizes)
        except ReaderError as error:
            raise fields.fail("shape", error.problem) from error

    def _node(self, fields: Fields, field: str) -> Node | None:
        text = fields.text_or_none(field)
        if text is None:
            return None
        try:
            node = read_matrix(text, self._entries, self._sizes)
        except ReaderError as error:
            raise fields.text.formula_error(
                f"{fields.where}.{field}", text, error, fields.line
            ) from error
        for part in node.walk():
            if part.kind == "name":
                self._declare(part.name)
        return node

    def _block(self, name: str, fields: Fields) -> Node:
        """Rows and columns picked from the matrix: R' X C."""
        owner, i, j = self._blocks[name]
        self._declare(owner)
        heights, widths = self._cuts(owner)
        said = self._said_shape(fields)
        if said != (heights[i], widths[j]):
            raise fields.fail("shape", f"a block of {owner} of another shape is wanted")
        return product(transposed(picked(heights, i)), Node("name", name=owner), picked(widths, j))

    def _cuts(self, owner: str) -> tuple[list[Size], list[Size]]:
        fields = self._entries[owner]
        rows = fields.take("blocks")
        heights: list[Size | None] = [None] * len(rows)
        widths: list[Size | None] = [None] * len(rows[0])
        for other, (matrix, i, j) in self._blocks.items():
            if matrix == owner:
                shape = self._said_shape(self._entries[other])
                if shape is None:
                    raise self._entries[other].fail("shape", "this field is missing")
                heights[i], widths[j] = heights[i] or shape[0], widths[j] or shape[1]
        whole = self._letters[owner].shape
        square = whole[0] == whole[1] and len(rows) == len(rows[0])
        for at in range(len(heights) if square else 0):
            heights[at], widths[at] = heights[at] or widths[at], widths[at] or heights[at]
        known = [size for size in (*heights, *widths) if size is not None]
        if len(known) < len(heights) + len(widths) or (
            (sum(known[: len(heights)], Size()), sum(known[len(heights) :], Size())) != whole
        ):
            raise fields.fail("blocks", f"blocks do not fill {self._shapes.said(whole)}")
        return known[: len(heights)], known[len(heights) :]


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
