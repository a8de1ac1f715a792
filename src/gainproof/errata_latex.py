"""Errata sheets as LaTeX documents of class article; they need amsmath."""

from __future__ import annotations

from collections.abc import Iterable

from gainproof.errata_entries import Block
from gainproof.lecture_latex import escaped

_COMMANDS = {"source": "section", "part": "subsection", "entry": "subsubsection"}


def document(blocks: Iterable[Block]) -> str:
    """The whole document, a section for each source."""
    parts = [
        r"\documentclass{article}",
        r"\usepackage[utf8]{inputenc}",
        r"\usepackage{amsmath}",
        r"\setlength{\parindent}{0pt}",
        r"\begin{document}",
        *[line for how, text in blocks for line in _set(how, text)],
        r"\end{document}",
    ]
    return "\n".join(parts) + "\n"


def _set(how: str, text: str) -> list[str]:
    if how == "formula":
        return [r"\[", f"  {text}", r"\]"]
    if how == "quote":
        lines = [escaped(line) or r"\strut" for line in text.split("\n")]
        return [r"\begin{quote}\ttfamily\raggedright", "\\\\\n".join(lines), r"\end{quote}"]
    if how == "text":
        return ["", escaped(text)]
    return ["", rf"\{_COMMANDS[how]}*{{{escaped(text)}}}"]
