"""Which symbols an equation holds, found by reading it: whatever the reader misses is declared,
until it reads the equation or says what it cannot read.
"""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.verify.judge.formula import Formula
from gainproof.verify.judge.reader.alphabet import is_letter
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.names import canonical_token
from gainproof.verify.judge.reader.reader import read_formula

MOST_NEW_SYMBOLS = 60


@dataclass(frozen=True)
class Free:
    """A symbol of which nothing is known: no function, no matrix."""

    arguments: tuple[str, ...] = ()
    shape: tuple[int, int] | None = None
    integer: bool = False


@dataclass(frozen=True)
class Met:
    """The symbols of an equation in order of appearance, and the formula, or why there is none and
    at what the reader stopped.
    """

    symbols: tuple[str, ...]
    formula: Formula | None
    problem: str = ""
    token: str = ""


def symbols_met(latex: str) -> Met:
    """Read an equation, declaring its symbols as they come."""
    declared: dict[str, Free] = {}
    for _ in range(MOST_NEW_SYMBOLS):
        try:
            formula = read_formula(latex, declared)
        except ReaderError as error:
            new = [name for name in _names(error.token) if name not in declared]
            if not new:
                return Met(tuple(declared), None, error.problem, error.token)
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
