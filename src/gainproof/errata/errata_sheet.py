"""An errata sheet of a source: what is printed, why it cannot stand, what would be true."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from gainproof.bad_input import BadInputError
from gainproof.claims.source_words import Said
from gainproof.errata import latex_sheet, markdown_sheet
from gainproof.errata.errata_entries import blocks
from gainproof.files import atomic_file, places
from gainproof.verdicts.verdict_snapshot import Judgement

ClaimsSaid = Mapping[str, Said]
MARKS: Mapping[str, str] = {
    ".md": "<!-- errata sheet made by gainproof check -->",
    ".tex": "% errata sheet made by gainproof check",
}
"""First line of each kind of sheet; a file that begins otherwise is not overwritten."""


def sheet(judgements: Sequence[Judgement], said: Sequence[ClaimsSaid], suffix: str = ".md") -> str:
    """The sheet of all sources, in Markdown or as a LaTeX document; `said` is what their files say
    of each claim beside its formula, for each source.
    """
    write = latex_sheet.document if suffix == ".tex" else markdown_sheet.document
    return f"{MARKS[suffix]}\n{write(blocks(judgements, said))}"


def target(name: str) -> Path:
    """Where to write a sheet. Raises BadInputError for a file of another kind, or of somebody's."""
    path = Path(name)
    if path.suffix not in MARKS:
        raise BadInputError(
            f"an errata sheet is a file .md or .tex, not {name!r} (the claim file comes first: "
            "gainproof check FILE --errata SHEET)"
        )
    places.require_file(path)
    try:
        with path.open(encoding="utf-8", errors="replace") as stream:
            first = stream.readline(200).rstrip("\n")
    except FileNotFoundError:
        return path
    except OSError as error:
        raise BadInputError(f"{name}: cannot be read: {error.strerror or error}") from None
    if first != MARKS[path.suffix]:
        raise BadInputError(f"{name}: exists and is no errata sheet; it is left as it is")
    return path


def write(judgements: Sequence[Judgement], said: Sequence[ClaimsSaid], path: Path) -> None:
    """Write the sheet. Raises BadInputError where that is not possible."""
    try:
        atomic_file.write_text(path, sheet(judgements, said, path.suffix))
    except OSError as error:
        shown = places.shown(path)
        raise BadInputError(f"{shown}: cannot be written: {error.strerror or error}") from None
