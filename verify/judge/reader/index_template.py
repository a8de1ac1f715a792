"""Names with an index: `b_i` stands for `b_1`, `b_2`, ... where i is declared as a whole number."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple


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
