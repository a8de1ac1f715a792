"""Notebook files: Markdown and code, the same bytes for the same cells."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec

from gainproof.bad_input import BadInputError


@dataclass(frozen=True)
class Cell:
    """One cell: `kind` is "markdown" or "code"."""

    kind: str
    text: str


def require_nbformat() -> None:
    """Raises BadInputError where the library that writes notebooks is missing."""
    if find_spec("nbformat") is None:
        raise BadInputError("nbformat is missing: pip install 'gainproof[notebook]'")


def notebook(cells: Sequence[Cell]) -> str:
    """The file as text. Ids are numbers in order and nothing of this machine or day is in it.

    Raises BadInputError where nbformat is missing.
    """
    require_nbformat()
    # the library has no types
    nbformat = import_module("nbformat")
    made = nbformat.v4.new_notebook(
        metadata={
            "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
            "language_info": {"name": "python"},
        },
        cells=[
            getattr(nbformat.v4, f"new_{cell.kind}_cell")(cell.text, id=f"cell-{number}")
            for number, cell in enumerate(cells, 1)
        ],
    )
    nbformat.validate(made)
    return f"{nbformat.writes(made)}\n"
