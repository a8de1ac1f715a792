"""What worker processes do: functions of plain data, by name. Everything heavy is imported inside."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

Plain = dict[str, Any]


def derive(name: str) -> Plain:
    """Derive one subject of the catalogue: `Derived` as plain data. SymPy is imported here."""
    from gainproof.deriving import derive_subject

    return derive_subject(name).plain()


TASKS: Mapping[str, Callable[..., Any]] = {"derive": derive}
