"""Which symbols an equation holds, found by reading it: whatever the reader misses is declared,
until it reads the equation or says what it cannot read.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from gainproof.verify.judge.formula import Formula
from gainproof.verify.judge.reader.alphabet import ACCENTS, GREEK, is_letter
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.names import canonical_token
from gainproof.verify.judge.reader.reader import read_formula, read_plain

MOST_NEW_SYMBOLS = 60


@dataclass(frozen=True)
class Free:
    """A symbol of which nothing is known: no function, no matrix."""

    arguments: tuple[str, ...] = ()
    shape: tuple[int, int] | None = None
    integer: bool = False


@dataclass(frozen=True)
class Met:
    """The symbols of an equation in order of appearance, and the formula, or why there is none, at
    what the reader stopped, and the line with a mark under the place.
    """

    symbols: tuple[str, ...]
    formula: Formula | None
    problem: str = ""
    token: str = ""
    caret: str = ""


def symbols_met(text: str, *, plain: bool = False, known: Sequence[str] = ()) -> Met:
    """Read an equation in LaTeX, or as `plain` text, declaring its symbols as they come; `known`
    are names that it may hold besides, such as those of several letters.
    """
    declared = {name: Free() for name in known}
    read = read_plain if plain else read_formula
    for _ in range(MOST_NEW_SYMBOLS):
        try:
            formula = read(text, declared)
        except ReaderError as error:
            met = _names(error.token) if not plain else _plain_names(error)
            new = [name for name in met if name not in declared]
            if not new:
                return Met(tuple(declared), None, error.problem, error.token, error.caret)
            declared |= dict.fromkeys(new, Free())
        else:
            return Met(tuple(name for name in declared if name in formula.symbols), formula)
    return Met(tuple(declared), None, f"more than {MOST_NEW_SYMBOLS} symbols")


def _names(token: str) -> list[str]:
    """The symbols in a token that was not declared: a run of letters is a product of letters, of
    which the last has the subscript.
    """
    try:
        name = canonical_token(token)
    except ReaderError:
        return []
    letters = 0
    while letters < len(name) and is_letter(name[letters]):
        letters += 1
    if letters < 2:
        return [name]
    return list(dict.fromkeys([*name[: letters - 1], name[letters - 1 :]]))


_PLAIN = re.compile(r"([a-z]+)\{(\w+)\}|([A-Za-z]+)")
_BEHIND = re.compile(r"('*)(?:_(?:\{([^{}]*)\}|([A-Za-z0-9]+)))?")


def _plain_names(error: ReaderError) -> list[str]:
    """The symbol that begins where plain text was not read: LaTeX without its backslashes."""
    text, start = error.text, error.position
    if not error.problem.endswith("is not declared"):
        return []
    found = _PLAIN.match(text, start)
    if found is None:
        return []
    if found[1] is not None and f"\\{found[1]}" in ACCENTS:
        base = f"\\{found[1]}{{{_with_backslash(found[2])}}}"
    else:
        found = re.compile("[A-Za-z]+").match(text, start)
        assert found is not None
        base = _with_backslash(found[0])
    behind = _BEHIND.match(text, found.end())
    assert behind is not None
    below = behind[2] if behind[2] is not None else behind[3]
    subscript = f"_{{{_with_backslash(below)}}}" if below else ""
    try:
        return [canonical_token(f"{base}{behind[1]}{subscript}")]
    except ReaderError:
        return []


def _with_backslash(name: str) -> str:
    return f"\\{name}" if f"\\{name}" in GREEK else name
