"""Claim files begun: a template, or a draft from a LaTeX file. What exists is not overwritten."""

from __future__ import annotations

import os
import re
import shlex
from pathlib import Path

from gainproof.bad_input import BadInputError
from gainproof.claims.draft import draft
from gainproof.claims.template import template
from gainproof.files import atomic_file, input_file, places

MOST_BYTES = 2**20


def begin(name: str) -> str:
    """Write the template to `name`; what to tell the user. Raises BadInputError."""
    path = new_file(name)
    write_new(path, template(_key(path)))
    shown = places.shown(path)
    return (
        f"{shown}: written; say what your source says, then: gainproof check {shlex.quote(name)}\n"
    )


def begin_from(tex: str, out: str | None) -> str:
    """Draft a claim file from a LaTeX file; to `out`, or returned. Raises BadInputError."""
    path = None if out is None else new_file(out)
    source = Path(tex)
    found = draft(_text(source), source.name, _key(path or source))
    if not found.equations:
        raise BadInputError(
            f"{places.shown(source)}: no displayed equation found (between \\[ and \\], $$, or in "
            "environments such as equation and align); nothing is drafted"
        )
    if path is None:
        return found.text
    write_new(path, found.text)
    read = found.equations - found.unread
    equations = f"{found.equations} equation{'s' if found.equations != 1 else ''}"
    return (
        f"{places.shown(path)}: {equations}, {read} read, {found.unread} left as "
        f"comments; say what is marked TODO, then: gainproof check {shlex.quote(str(out))}\n"
    )


def _key(path: Path) -> str:
    """The file's name as the key of its source, which has no spaces or signs."""
    from gainproof.verify.judge.claim.file import MOST_KEY

    shown = re.sub(r"[^\w.:+-]", "-", path.stem).lstrip("_.:+-")
    return shown[:MOST_KEY] or "source"


def new_file(name: str) -> Path:
    path = Path(name)
    if path.suffix != ".toml":
        raise BadInputError(f"a claim file is a file .toml, not {name!r}")
    if os.path.lexists(path):
        raise BadInputError(f"{name}: exists already; it is left as it is")
    return path


def write_new(path: Path, text: str) -> None:
    try:
        atomic_file.write_text(path, text)
    except OSError as error:
        shown = places.shown(path)
        raise BadInputError(f"{shown}: cannot be written: {error.strerror or error}") from None


def _text(path: Path) -> str:
    """The text of a LaTeX file; what is not UTF-8 in it is replaced."""
    content = input_file.content(path, MOST_BYTES)
    return content.decode("utf-8", errors="replace").replace("\r\n", "\n").replace("\r", "\n")
