"""Errata sheets as LaTeX documents of class article; they need amsmath."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.errata_entries import Entry, entries, source_line
from gainproof.lecture_latex import escaped
from gainproof.verdicts import Judgement


def document(judgements: Sequence[Judgement]) -> str:
    """The whole document, a section for each source."""
    parts = [
        r"\documentclass{article}",
        r"\usepackage[utf8]{inputenc}",
        r"\usepackage{amsmath}",
        r"\setlength{\parindent}{0pt}",
        r"\begin{document}",
        *[line for judgement in judgements for line in _section(judgement)],
        r"\end{document}",
    ]
    return "\n".join(parts) + "\n"


def _section(judgement: Judgement) -> list[str]:
    found = entries(judgement)
    lines = [
        "",
        rf"\section*{{Errata: {escaped(judgement['source']['title'])}}}",
        escaped(source_line(judgement["source"])),
    ]
    if not found:
        return [*lines, "", "No errata were found."]
    return [*lines, *[line for entry in found for line in _entry(entry)]]


def _entry(entry: Entry) -> list[str]:
    lines = ["", rf"\subsection*{{{escaped(entry.title)}}}", f"Printed ({escaped(entry.verdict)}):"]
    lines += _display(entry.printed) if entry.printed else ["(in words)"]
    for label, text in entry.remarks:
        lines += ["", rf"{escaped(label)}: {escaped(text)}"]
    if entry.repair:
        lines += ["", rf"Read instead ({escaped(entry.repair_verdict)}):", *_display(entry.repair)]
    return lines


def _display(latex: str) -> list[str]:
    return [r"\[", f"  {' '.join(latex.split())}", r"\]"]
