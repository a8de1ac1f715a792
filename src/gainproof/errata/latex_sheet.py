"""Errata sheets as LaTeX documents of class article; they need amsmath."""

from __future__ import annotations

from collections.abc import Iterable

from gainproof.errata.errata_entries import Block
from gainproof.formulas.sentence_formulas import written
from gainproof.pages.lecture_latex import escaped

_COMMANDS = {"source": "section", "part": "subsection", "entry": "subsubsection"}


def document(blocks: Iterable[Block]) -> str:
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
        *[line for block in blocks for line in _set(block)],
        r"\end{document}",
    ]
    return "\n".join(parts) + "\n"


def _set(block: Block) -> list[str]:
    if block.how == "formula":
        return [r"\[", f"  {block.text}", r"\]"]
    if block.how == "quote":
        lines = [escaped(line) or r"\strut" for line in block.text.split("\n")]
        return [r"\begin{quote}\ttfamily\raggedright", "\\\\\n".join(lines), r"\end{quote}"]
    if block.how == "text":
        return ["", written(block.sentence, block.symbols, escaped)]
    title = escaped(block.text)
    return ["", rf"\{_COMMANDS[block.how]}*{{{title}}}" if block.how in _COMMANDS else title]
