"""What a text may say: declared symbols, which branch of `\\pm` is meant, and which logarithm.

Names with an index: `b_i` stands for `b_1`, `b_2`, ... where i is declared as a whole number.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, Protocol

from gainproof.verify.judge.reader.formula_limits import MOST_NAME_CHARACTERS
from gainproof.verify.judge.reader.plain_names import plain_table
from gainproof.verify.judge.reader.words import BASED, BRANCHES


class Declared(Protocol):
    """What the reader asks of a declared symbol: the names of its arguments, none unless it is a
    function; its shape, None unless it is a matrix; whether it is a whole number.
    """

    @property
    def arguments(self) -> tuple[str, ...]:
        """Names of the arguments."""
        ...

    @property
    def shape(self) -> object | None:
        """Rows and columns, or None for a number."""
        ...

    @property
    def integer(self) -> bool:
        """Whether it takes whole numbers only."""
        ...


@dataclass(frozen=True)
class Vocabulary:
    """Declared symbols by canonical token, the branch of `\\pm`, if one is declared, and the base
    of `\\log` where none is printed, a whole number; None for the natural logarithm.
    """

    symbols: Mapping[str, Declared]
    branch: str | None = None
    logarithm: int | None = None

    def __post_init__(self) -> None:
        if self.branch not in (None, *BRANCHES):
            wanted = " or ".join(map(repr, BRANCHES))
            raise ValueError(f"branch: wanted {wanted}, got {self.branch!r}")

    def __contains__(self, name: object) -> bool:
        return name in self.symbols

    def is_function(self, name: str) -> bool:
        """Whether a declared name takes arguments."""
        return bool(self.symbols[name].arguments)

    def is_integer(self, name: str) -> bool:
        """Whether a declared name is a whole number."""
        return name in self.symbols and self.symbols[name].integer

    @property
    def logarithm_name(self) -> str:
        """What `\\log` without a base is called in graphs."""
        return "log" if self.logarithm is None else f"{BASED}{self.logarithm}"

    @cached_property
    def longest(self) -> int:
        """Most letters that one name may take."""
        return min(MOST_NAME_CHARACTERS, max(map(len, (*self.symbols, "and"))))

    @cached_property
    def plain_names(self) -> dict[str, tuple[str, ...]]:
        """What names in plain text may stand for."""
        return plain_table(self.symbols)

    @cached_property
    def index_templates(self) -> tuple[IndexTemplate, ...]:
        """Declared names with a whole number as index."""
        indices = [name for name in self.symbols if self.is_integer(name)]
        return tuple(index_templates(list(self.symbols), indices))

    @cached_property
    def matrices(self) -> frozenset[str]:
        """The names whose value is a matrix."""
        return frozenset(name for name, entry in self.symbols.items() if entry.shape is not None)


class IndexTemplate(NamedTuple):
    """A name, the symbol in it that is its index, and what stands before and behind the index."""

    name: str
    symbol: str
    before: str
    after: str

    def inner(self, name: str) -> str:
        """What stands in place of the index in another name; empty if that is made otherwise."""
        text = _with_braces(name)
        if not (text.startswith(self.before) and text.endswith(self.after)):
            return ""
        return text[len(self.before) : len(text) - len(self.after)]


def index_templates(names: Sequence[str], indices: Sequence[str]) -> Iterator[IndexTemplate]:
    """Every way to see one of the whole numbers `indices` in the subscript or the brackets of a
    name.
    """
    for name in names:
        text = _with_braces(name)
        starts = [place + 1 for place in (text.find("_{") + 1, text.find("(")) if place > 0]
        for index in indices if starts else ():
            place = text.find(index, starts[0])
            if place >= 0:
                yield IndexTemplate(name, index, text[:place], text[place + len(index) :])


def _with_braces(name: str) -> str:
    """`b_1` as `b_{1}`."""
    place = name.rfind("_")
    return f"{name[:place]}_{{{name[place + 1]}}}" if place == len(name) - 2 > 0 else name
