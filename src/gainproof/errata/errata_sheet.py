"""An errata sheet of a source, in Markdown or LaTeX: what is printed, why it cannot stand, what
would be true.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from gainproof.bad_input import BadInputError
from gainproof.claims.source_words import Said
from gainproof.errata.errata_entries import Block, blocks
from gainproof.files import atomic_file, places
from gainproof.formulas.sentence_formulas import written
from gainproof.pages.lecture_latex import escaped
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
    write = _latex if suffix == ".tex" else _markdown
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


_COMMANDS = {"source": "section", "part": "subsection", "entry": "subsubsection"}


def _latex(blocks: Iterable[Block]) -> str:
    """The whole document, a section for each source."""
    parts = [
        r"\documentclass{article}",
        r"\usepackage[utf8]{inputenc}",
        r"\usepackage{amsmath}",
        r"\setlength{\parindent}{0pt}",
        r"\setlength{\parskip}{3pt}",
        # paths and names in heads leave few places to break a line
        r"\setlength{\emergencystretch}{4em}",
        r"\begin{document}",
        *[line for block in blocks for line in _latex_lines(block)],
        r"\end{document}",
    ]
    return "\n".join(parts) + "\n"


def _latex_lines(block: Block) -> list[str]:
    if block.how == "formula":
        return [r"\[", f"  {block.text}", r"\]"]
    if block.how == "quote":
        lines = [escaped(line) or r"\strut" for line in block.text.split("\n")]
        return [r"\begin{quote}\ttfamily\raggedright", "\\\\\n".join(lines), r"\end{quote}"]
    if block.how == "text":
        return ["", written(block.sentence, block.symbols, escaped)]
    title = escaped(block.text)
    return ["", rf"\{_COMMANDS[block.how]}*{{{title}}}" if block.how in _COMMANDS else title]


_SPECIAL = frozenset("\\`*_{}[]#|<>~$")
_HEADS = {"source": "# ", "part": "## ", "entry": "### ", "line": ""}


def _markdown(blocks: Iterable[Block]) -> str:
    """The whole sheet, a heading for each source."""
    return "\n\n".join(map(_markdown_block, blocks)) + "\n"


def _markdown_block(block: Block) -> str:
    if block.how == "formula":
        return f"$$\n{block.text}\n$$"
    if block.how == "quote":
        return "\n".join(f"    {line}" for line in block.text.split("\n"))
    if block.how == "text":
        return written(block.sentence, block.symbols, _escaped)
    return f"{_HEADS[block.how]}{_escaped(block.text)}"


def _escaped(text: str) -> str:
    """Text that Markdown shows as it is."""
    return "".join(f"\\{character}" if character in _SPECIAL else character for character in text)
