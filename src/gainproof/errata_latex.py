"""Errata sheets as LaTeX documents of class article; they need amsmath."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.errata_entries import Entry, Part, source_line
from gainproof.lecture_latex import escaped


def document(sources: Sequence[Part]) -> str:
    """The whole document, a section for each source."""
    parts = [
        r"\documentclass{article}",
        r"\usepackage[utf8]{inputenc}",
        r"\usepackage{amsmath}",
        r"\setlength{\parindent}{0pt}",
        r"\begin{document}",
        *[line for part in sources for line in _section(part)],
        r"\end{document}",
    ]
    return "\n".join(parts) + "\n"


def _section(part: Part) -> list[str]:
    lines = [
        "",
        rf"\section*{{Errata: {escaped(part.source['title'])}}}",
        escaped(source_line(part.source)),
    ]
    if not part.entries:
        return [*lines, "", "No errata were found."]
    return [*lines, *[line for entry in part.entries for line in _entry(entry)]]


def _entry(entry: Entry) -> list[str]:
    lines = ["", rf"\subsection*{{{escaped(entry.title)}}}", f"Printed ({escaped(entry.verdict)}):"]
    lines += _display(entry.printed) if entry.printed else [escaped(entry.words)]
    for label, text in entry.remarks:
        lines += ["", rf"{escaped(label)}: {escaped(text)}"]
    for latex, verdict in entry.repairs:
        lines += ["", rf"Read instead ({escaped(verdict)}):", *_display(latex)]
    return lines


def _display(latex: str) -> list[str]:
    return [r"\[", f"  {' '.join(latex.split())}", r"\]"]
