"""The whole site written into a folder: pages set by their templates, style, scripts, search."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import jinja2

from gainproof.bad_input import BadInputError
from gainproof.book.page import Page
from gainproof.files import atomic_file, input_file, named_files, places
from gainproof.interface_words import LANGUAGES, in_language

MARK = "gainproof-book.txt"
"""A file that every site has: a folder with other things in it is never written into."""
MOST_LISTED = 10**7
"""Bytes."""
_TOLD = "Made by: gainproof book\n"
_HERE = Path(__file__).resolve().parent
STATIC = ("style.css", "play.css", "site.js", "theme.js")
INDEX = "search-index.js"


def files(
    pages: Sequence[Page], scripts: Mapping[str, str], tell: Callable[[str], None]
) -> dict[str, bytes]:
    """Every file of the site by its path. `scripts`: texts of the scripts that pages load besides
    the site's own; `tell` hears how far it is.
    """
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(_HERE / "templates"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    found = {MARK: _TOLD.encode()}
    for name in STATIC:
        found[f"static/{name}"] = (_HERE / "static" / name).read_bytes()
    for name, text in scripts.items():
        found[f"static/{name}"] = text.encode()
    found[f"static/{INDEX}"] = search_index(pages).encode()
    for number, page in enumerate(pages, 1):
        tell(f"page {number} of {len(pages)}")
        found[page.path] = _text(page, environment).encode()
    return found


def write(contents: Mapping[str, bytes], folder: Path) -> None:
    """Write the files; those of an earlier site that are no longer of it are removed.

    Raises BadInputError, and writes nothing, for a folder that holds something else, for a file
    that would lie elsewhere or behind a link; BadInputError where the folder cannot be written.
    """
    require_own(folder)
    before = _listed(folder)
    named_files.require_within(folder, {MARK, *contents, *before})
    try:
        # the mark comes first, with the names of the files: a site that was interrupted is ours
        names = "\n".join(sorted(contents))
        atomic_file.write_text(folder / MARK, f"{_TOLD}{names}\n")
        for path, content in contents.items():
            if path != MARK:
                _renew(folder / path, content)
        for path in before - set(contents):
            (folder / path).unlink(missing_ok=True)
    except OSError as error:
        shown = places.shown(error.filename or folder)
        raise BadInputError(f"{shown}: cannot be written: {error.strerror or error}") from None


def require_own(folder: Path) -> None:
    """Raises BadInputError unless the folder is new, empty or a site made before, without a link in
    it: the list of its files is a file that anybody may have altered.
    """
    places.require_folder(folder)
    try:
        empty = not folder.is_dir() or not any(folder.iterdir())
    except OSError as error:
        shown = places.shown(folder)
        raise BadInputError(f"{shown}: cannot be read: {error.strerror or error}") from None
    if not empty and not _is_mark(folder / MARK):
        raise BadInputError(
            f"{places.shown(folder)}: holds other things; a new folder, an empty one or a book "
            "made before is wanted"
        )
    if not empty:
        named_files.require_within(folder, {MARK, *_listed(folder)})


def _is_mark(path: Path) -> bool:
    try:
        return input_file.text(path, MOST_LISTED).startswith(_TOLD)
    except BadInputError:
        return False


def _listed(folder: Path) -> set[str]:
    """The files of the site that is there."""
    if not _is_mark(folder / MARK):
        return set()
    return set(input_file.text(folder / MARK, MOST_LISTED).splitlines()[1:]) - {""}


def _renew(path: Path, content: bytes) -> None:
    """Write a file unless it has this content already."""
    if not path.is_file() or path.read_bytes() != content:
        atomic_file.write_bytes(path, content)


def _text(page: Page, environment: jinja2.Environment) -> str:
    words = in_language(page.language)
    text: str = environment.get_template(page.template).render(
        {"page": page, "to": page.to, "w": words, "languages": LANGUAGES, **page.data}
    )
    return text


def search_index(pages: Iterable[Page]) -> str:
    """A script with what can be found: the site is read from a folder, where only scripts load."""
    entries: list[dict[str, Any]] = [
        {
            "title": finding.title,
            "kind": page.kind,
            "path": f"{page.path}#{finding.anchor}" if finding.anchor else page.path,
            "words": " ".join(finding.words.split()),
        }
        for page in pages
        for finding in page.findings
    ]
    lines = ",\n".join(json.dumps(entry, ensure_ascii=False) for entry in entries)
    return f"window.gainproofSearch = [\n{lines}\n];\n"
