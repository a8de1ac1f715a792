"""Symbols for the reader without a claim file: what it asks of a table of symbols, and no more."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Declared:
    """A symbol as the reader asks for it."""

    arguments: tuple[str, ...] = ()
    shape: object | None = None
    integer: bool = False
