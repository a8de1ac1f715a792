"""Which symbols an equation holds, found by reading it: whatever the reader misses is declared,
until it reads the equation or says what it cannot read.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field

from gainproof.verify.judge.formula import Formula
from gainproof.verify.judge.reader.alphabet import ACCENTS, GREEK, is_letter
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.printed_names import canonical_token, names_in
from gainproof.verify.judge.reader.reader import read_formula, read_plain

MOST_NEW_SYMBOLS = 60
_MOST_RUN = 4
_MOST_BACK = 60
"""Letters of a run that are taken for names, and characters in which the last name is sought."""


@dataclass(frozen=True)
class Free:
    """A symbol of which nothing is known: no function, no matrix."""

    arguments: tuple[str, ...] = ()
    shape: tuple[int, int] | None = None
    integer: bool = False


@dataclass(frozen=True)
class Met:
    """The symbols of an equation in order of appearance, and the formula, or why there is none, at
    what the reader stopped, and the line with a mark under the place. `matrices` are letters under
    a transpose, with the arguments of one that is a function.
    """

    symbols: tuple[str, ...]
    formula: Formula | None
    problem: str = ""
    token: str = ""
    caret: str = ""
    matrices: Mapping[str, tuple[str, ...]] = field(default_factory=dict)


def symbols_met(
    text: str,
    *,
    plain: bool = False,
    known: Sequence[str] = (),
    transposes: bool = False,
    is_number: Callable[[str], bool] = lambda _: True,
) -> Met:
    """Read an equation in LaTeX, or as `plain` text, declaring its symbols as they come; `known`
    are names that it may hold besides, such as those of several letters. With `transposes` what
    stands under one is declared as a matrix, and so is each letter that `is_number` denies.
    """

    def free(name: str) -> Free:
        return Free() if is_number(name) else Free(shape=(1, 1))

    declared = {name: free(name) for name in known}
    read = read_plain if plain else read_formula
    for _ in range(MOST_NEW_SYMBOLS):
        try:
            formula = read(text, declared)
        except ReaderError as error:
            met = _names(error.token) if not plain else _plain_names(error)
            new = {name: free(name) for name in met if name not in declared}
            if transposes and error.token == "^T":
                new = _transposed(text[: error.position], declared)
            if not new:
                return Met(tuple(declared), None, error.problem, error.token, error.caret)
            declared |= new
        else:
            symbols = tuple(name for name in declared if name in formula.symbols)
            matrices = {n: declared[n].arguments for n in symbols if declared[n].shape is not None}
            return Met(symbols, formula, matrices=matrices)
    return Met(tuple(declared), None, f"more than {MOST_NEW_SYMBOLS} symbols")


def _transposed(before: str, declared: Mapping[str, Free]) -> dict[str, Free]:
    """The letters that a transpose behind the text stands over, as matrices: one letter, all in a
    bracket, or a function of one letter.
    """
    before = before.rstrip(" ^_{")
    if not before.endswith((")", "]")):
        name = _last_name(before, declared)
        return {name: Free(shape=(1, 1))} if name and declared[name].shape is None else {}
    depth, start = 0, len(before)
    while start > 0 and (depth or start == len(before)):
        start -= 1
        depth += (before[start] in ")]") - (before[start] in "([")
    inner = before[start + 1 : -1].removesuffix("\\right")
    within = [name for name in names_in(inner, _MOST_RUN) if name in declared]
    function = _last_name(before[:start].removesuffix("\\left"), declared)
    if len(within) == 1 and function and inner.strip() == _last_text(inner, within[0]):
        return {function: Free((within[0],), (1, 1))}
    return {name: Free(shape=(1, 1)) for name in within if declared[name].shape is None}


def _last_name(text: str, declared: Mapping[str, Free]) -> str:
    """The longest declared name that the text ends with; empty without one."""
    text = text.rstrip()
    for start in range(max(0, len(text) - _MOST_BACK), len(text)):
        with suppress(ReaderError):
            name = canonical_token(text[start:])
            if name in declared:
                return name
    return ""


def _last_text(text: str, name: str) -> str:
    """The text without blanks around, if it is that name alone."""
    with suppress(ReaderError):
        return text.strip() if canonical_token(text) == name else ""
    return ""


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
