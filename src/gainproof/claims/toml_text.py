"""Texts as TOML writes them, LaTeX in literal quotes wherever that is possible."""

from __future__ import annotations


def quoted(text: str) -> str:
    """A TOML string of one line with this content; invisible characters become question marks."""
    shown = printable(text)
    if "'" not in shown:
        return f"'{shown}'"
    return '"' + shown.replace("\\", "\\\\").replace('"', '\\"') + '"'


def comment(text: str) -> str:
    """A comment of one line."""
    return f"# {printable(text)}"


def printable(text: str) -> str:
    """The text without line ends and characters that cannot be seen."""
    return "".join(c if c.isprintable() else " " if c in "\n\t" else "?" for c in text)
