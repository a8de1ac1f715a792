"""Sizes as text: `6 + n - n_b`, `2n`."""

from __future__ import annotations

from gainproof.verify.judge.matrices.printed_names import (
    scan_subscript,
    scan_symbol,
    skip_blanks,
    with_subscript,
)
from gainproof.verify.judge.matrices.size import Size, Sizes
from gainproof.verify.judge.reader.errors import ReaderError, nearest_names

MOST_SIZE = 99
MOST_TERMS = 20


def read_size(text: str, sizes: Sizes, may_be_negative: bool = False) -> Size:
    """The size over steps. Raises ReaderError for what is none, or may be below 0."""
    total, position, first = Size(), 0, True
    count = 0
    while True:
        position = skip_blanks(text, position)
        if position == len(text) and not first:
            break
        sign = 1
        if text[position : position + 1] in ("+", "-"):
            sign = 1 if text[position] == "+" else -1
            position = skip_blanks(text, position + 1)
        elif not first:
            raise ReaderError("a size is a sum such as 6 + n - n_b", text, position)
        term, position = _term(text, position, sizes)
        total, first = total + term.times(sign), False
        count += 1
        if count > MOST_TERMS:
            raise ReaderError(f"more than {MOST_TERMS} terms in a size", text, position)
    if abs(total.constant) > MOST_SIZE or any(abs(f) > MOST_SIZE for _, f in total.terms):
        raise ReaderError(f"a number beyond {MOST_SIZE} in a size", text, 0)
    if not total.is_never_negative and not may_be_negative:
        raise ReaderError(f"the size {sizes.shown(total)} may be negative", text, 0)
    return total


def _term(text: str, position: int, sizes: Sizes) -> tuple[Size, int]:
    end = position
    while text[end : end + 1].isascii() and text[end : end + 1].isdigit():
        end += 1
    if end - position > 3:
        raise ReaderError(f"a number beyond {MOST_SIZE} in a size", text, position)
    number = int(text[position:end]) if end > position else None
    after = skip_blanks(text, end)
    found = scan_symbol(text, after) if after < len(text) else None
    if found is None:
        if number is None:
            raise ReaderError("a size is a sum such as 6 + n - n_b", text, position)
        return Size(number), end
    base, after_base = found
    subscript, stop = scan_subscript(text, after_base)
    name = with_subscript(base, subscript)
    if name not in sizes.names:
        near = nearest_names(name, sizes.names)
        raise ReaderError(f"there is no size {name}", text, after, name, near)
    return sizes.names[name].times(1 if number is None else number), stop
