"""Errata sheets in Markdown with formulas between double dollars."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.errata_entries import Entry, Part, source_line

_SPECIAL = frozenset("\\`*_{}[]#|<>~$")


def document(sources: Sequence[Part]) -> str:
    """The whole sheet, a heading for each source."""
    parts = []
    for part in sources:
        parts.append(f"# Errata: {_escaped(part.source['title'])}")
        parts.append(_escaped(source_line(part.source)))
        parts += [_entry(entry) for entry in part.entries] or ["No errata were found."]
    return "\n\n".join(parts) + "\n"


def _entry(entry: Entry) -> str:
    lines = [f"## {_escaped(entry.title)}", f"Printed ({entry.verdict}):"]
    lines.append(_display(entry.printed) if entry.printed else _escaped(entry.words))
    lines += [f"{label}: {_escaped(text)}" for label, text in entry.remarks]
    for latex, verdict in entry.repairs:
        lines += [f"Read instead ({_escaped(verdict)}):", _display(latex)]
    return "\n\n".join(lines)


def _display(latex: str) -> str:
    return f"$$\n{' '.join(latex.split())}\n$$"


def _escaped(text: str) -> str:
    """Text that Markdown shows as it is."""
    return "".join(f"\\{character}" if character in _SPECIAL else character for character in text)
