"""Claim files: one TOML file a source, read into frozen records, everything checked.

`docs/claim-files.md` says what may stand in it; `record` holds the records.

A claim file is untrusted input: nothing in it is evaluated, and its size and the number of its
parts are limited.

Characters that such a file may not hold are looked for as they are and as escapes of TOML.
"""

from __future__ import annotations

import re
import tomllib
import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import replace
from decimal import Decimal
from pathlib import Path
from typing import Any

from gainproof.verify.judge.claim.claims import read_claims
from gainproof.verify.judge.claim.declarations import read_declarations
from gainproof.verify.judge.claim.errors import (
    MOST_FOUND,
    ClaimFileError,
    FileText,
    TooManyError,
)
from gainproof.verify.judge.claim.fields import Fields
from gainproof.verify.judge.claim.record import (
    Claim,
    ClaimFile,
    OwnModel,
    Setting,
    SourceRecord,
    SymbolEntry,
    Unit,
)
from gainproof.verify.judge.claim.settings import read_settings, symbol_error
from gainproof.verify.judge.claim.symbols import complete_symbols
from gainproof.verify.judge.claim.usual_meanings import USUAL, pruned
from gainproof.verify.judge.dimensions.declarations import shared_fault

FORMAT = "gainproof claims 1"
MOST_BYTES = 2**20
MOST_AUTHORS = 50
MOST_KEY = 80
GREATEST_BASE = 1000
TABLES = ("format", "source", "symbols", "settings", "claims")
SOURCE_FIELDS = (
    "key",
    "title",
    "authors",
    "publication",
    "year",
    "url",
    "doi",
    "repository",
    "commit",
    "note",
    "logarithm",
)

__all__ = [
    "FORMAT",
    "Claim",
    "ClaimFile",
    "ClaimFileError",
    "OwnModel",
    "Setting",
    "SourceRecord",
    "SymbolEntry",
    "Unit",
    "read_claim_file",
    "read_claim_text",
]
MOST_LINE = 8000
"""Characters of one line, which holds one formula at most."""
MOST_DOTS = 200
"""Dots in one line: the keys of TOML nest at dots, and reading them takes time that grows with the
square.
"""
ESCAPED = re.compile(
    r"""\s*(latex|plain|domain|definition|given|hint|invertible|recursion)\s*=\s*\[?\s*"""
    r""""[^"\\]*(\\\\[^"\\]*)*(?P<escape>\\[btnfr])(?=[A-Za-z])"""
)
"""A formula in double quotes with an escape that begins the name of a command."""


def read_claim_file(path: str | Path) -> ClaimFile:
    """The claim file at `path`. Raises ClaimFileError, which says where, for whatever is wrong with
    it.
    """
    name = str(path)
    try:
        if Path(path).exists() and not Path(path).is_file():
            raise ClaimFileError(name, "", "cannot be read: a regular file is wanted")
        with Path(path).open("rb") as stream:
            content = stream.read(MOST_BYTES + 1)
    except OSError as error:
        raise ClaimFileError(name, "", f"cannot be read: {error.strerror or error}") from error
    if len(content) > MOST_BYTES:
        raise ClaimFileError(name, "", f"more than {MOST_BYTES} bytes")
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        raise ClaimFileError(name, "", "the text is not UTF-8", line) from error
    return read_claim_text(text, name)


def read_claim_text(
    text: str,
    path: str = "claims",
    models: Sequence[str] | None = None,
    *,
    keep_going: bool = False,
) -> ClaimFile:
    """The claim file with this text; `path` is used in messages only. With `models`, the names of
    the catalogue, a setting may name no other.

    Raises ClaimFileError for the first error, with all others that were found. With `keep_going`
    that is so only if there is no claim that can be judged; else the errors are in the file, and
    what they are about is not.
    """
    file_text, parsed = toml_of(text, path)
    claim_file = None
    try:
        claim_file = _claim_file(file_text, parsed, models)
    except ClaimFileError as error:
        file_text.found.append(error)
    except TooManyError:
        problem = f"after {MOST_FOUND} errors no more are looked for"
        file_text.found.append(ClaimFileError(path, "", problem))
    if claim_file is None or (file_text.found and not (keep_going and claim_file.claims)):
        raise file_text.refusal()
    return replace(claim_file, errors=tuple(file_text.in_order()))


def toml_of(text: str, path: str) -> tuple[FileText, Mapping[str, Any]]:
    """A file that is not trusted, and what TOML makes of it; decimals are as they are printed.
    Raises ClaimFileError.
    """
    if len(text) > MOST_BYTES:
        raise ClaimFileError(path, "", f"more than {MOST_BYTES} characters")
    text = text.replace("\r\n", "\n")
    refuse_characters(text, path)
    refuse_escaped_latex(text, path)
    file_text = FileText(path, text)
    parsed = _parse(text, path)
    refuse_escapes(parsed, path)
    return file_text, parsed


def _claim_file(
    text: FileText, parsed: Mapping[str, Any], models: Sequence[str] | None
) -> ClaimFile | None:
    """The file, or None without a source. Errors are noted as far as others can be found."""
    document = Fields(text, "file", _with_source(parsed, text.path), TABLES)
    version = document.required_text("format")
    if version != FORMAT:
        raise document.fail("format", f"wanted {FORMAT!r}, but it is {version[:80]!r}")
    if text.found:
        return None
    source = _source(text, document.take("source"))
    text.logarithm = source.logarithm if source else None
    start = text.line_of_table("symbols") or 1
    table = document.take("symbols") or {}
    usual = table == USUAL
    declared = {} if usual else read_declarations(text, "symbols", table, start)
    symbols = complete_symbols(text, declared)
    fault = shared_fault(symbols.sound)
    if fault is not None:
        text.note(symbol_error(text, "symbols", fault))
        symbols = replace(symbols, unsound=frozenset(symbols.symbols))
    settings = read_settings(text, document.take("settings"), symbols, models, usual=usual)
    claims, unread = read_claims(text, document.take("claims"), settings)
    judged = {
        name: pruned(one.judged, one.usual, [c for c in claims if c.setting == name])
        if one.usual
        else one.judged
        for name, one in settings.items()
        if one and one.judged
    }
    if source is None:
        return None
    return ClaimFile(text.path, source, symbols.sound, judged, claims, unread=unread)


def _parse(text: str, path: str) -> Mapping[str, Any]:
    try:
        return tomllib.loads(text, parse_float=Decimal)
    except RecursionError:
        raise ClaimFileError(path, "", "tables or lists are nested too deep") from None
    except ValueError as error:
        raise _not_toml(path, text, str(error)[:300]) from error


def _not_toml(path: str, text: str, problem: str) -> ClaimFileError:
    """The parser's complaint, its place in front, and what stands there a second time."""
    what, _, place = problem.rpartition(" (at line ")
    line, _, column = place.rstrip(")").partition(", column ")
    hint = "; LaTeX stands in single quotes" if "\\" in problem else ""
    if path.endswith(".py"):
        hint = f"; models and expressions are derived: gainproof derive {path}"
    if not (line.isdigit() and column.isdigit()):
        return ClaimFileError(path, "", f"not TOML: {problem}{hint}")
    if what == "Cannot overwrite a value":
        key = text.split("\n")[int(line) - 1].partition("=")[0].strip()
        hint = f": {key[:80]} stands in this table a second time"
    return ClaimFileError(path, "", f"not TOML: {what}{hint}", int(line), int(column))


def _key(fields: Fields) -> str:
    """The key is the name of a page too: it is no path, and shows on a page as it stands."""
    key = fields.required_text("key")
    allowed = key[0].isalnum() and all(c.isalnum() or c in "-_.:+" for c in key)
    if not allowed or len(key) > MOST_KEY:
        problem = "letters, digits, - _ . : + are wanted, a letter or digit first"
        raise fields.fail("key", f"{problem}, at most {MOST_KEY}")
    return key


def _source(text: FileText, table: object) -> SourceRecord | None:
    """The record, or None where it has errors, which are noted."""
    if table is None:
        text.note(text.error("source", "this table is missing"))
        return None
    noted = text.noted
    fields = Fields(text, "source", table, SOURCE_FIELDS, text.line_of_table("source"))

    def required(field: str) -> str:
        return text.attempt(lambda: fields.required_text(field), "")

    some: tuple[str, ...] = ("",)
    authors = text.attempt(lambda: fields.texts("authors", MOST_AUTHORS), some)
    if not authors:
        text.note(fields.fail("authors", "at least one author is wanted"))
    record = SourceRecord(
        key=text.attempt(lambda: _key(fields), ""),
        title=required("title"),
        authors=authors,
        publication=required("publication"),
        year=fields.whole_number("year", 1, 9999),
        url=fields.text_or_none("url"),
        doi=fields.text_or_none("doi"),
        repository=fields.text_or_none("repository"),
        commit=fields.text_or_none("commit"),
        note=fields.text_or_none("note"),
        logarithm=fields.whole_number("logarithm", 2, GREATEST_BASE),
    )
    return record if text.noted == noted else None


def _with_source(parsed: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    """What TOML made of a claim file, with what a source has that only says its title; `name` is
    that of the file, from which the key comes.
    """
    source = parsed.get("source")
    if not isinstance(source, Mapping):
        return parsed
    return {**parsed, "source": {**_usual_source(name), **source}}


def _usual_source(name: str) -> dict[str, Any]:
    """What a source has that only says its title."""
    stem = re.sub(r"\.toml$", "", name.replace("\\", "/").rpartition("/")[2])
    key = re.sub(r"[^\w.:+-]", "-", stem, flags=re.ASCII).lstrip("_.:+-")[:80]
    return {"key": key or "source", "authors": ["unknown"], "publication": "unpublished"}


def refuse_characters(text: str, path: str) -> None:
    """Invisible and directional characters could make a file look like another."""
    for number, line in enumerate(text.split("\n"), start=1):
        if len(line) > MOST_LINE:
            raise ClaimFileError(path, "", f"more than {MOST_LINE} characters in a line", number)
        if line.count(".") > MOST_DOTS:
            raise ClaimFileError(path, "", f"more than {MOST_DOTS} dots in a line", number)
        for column, character in enumerate(line, start=1):
            problem = _invisible(character)
            if problem is not None:
                raise ClaimFileError(path, "", problem, number, column)


def refuse_escaped_latex(text: str, path: str) -> None:
    """LaTeX in double quotes, of which TOML makes something else without a word: \\beta is a
    backspace and `eta`.
    """
    for number, line in enumerate(text.split("\n"), start=1):
        found = ESCAPED.match(line)
        if found is not None:
            escape = found.group("escape")
            problem = (
                f"in double quotes {escape} is an escape of TOML; LaTeX stands in single quotes"
            )
            raise ClaimFileError(path, "", problem, number, found.start("escape") + 1)


def refuse_escapes(value: object, path: str) -> None:
    """The same characters as escapes of TOML: they would reach a terminal as they are."""
    if isinstance(value, str):
        problem = next((p for c in value if c != "\n" and (p := _invisible(c))), None)
        if problem is not None:
            raise ClaimFileError(path, "", f"{problem}, written as an escape")
    elif isinstance(value, Mapping):
        for key, inner in value.items():
            refuse_escapes(key, path)
            refuse_escapes(inner, path)
    elif isinstance(value, list):
        for inner in value:
            refuse_escapes(inner, path)


def _invisible(character: str) -> str | None:
    """What is wrong with a character, if it cannot be seen."""
    if character.isascii() and (character.isprintable() or character == "\t"):
        return None
    if unicodedata.category(character) not in ("Cc", "Cf", "Cn", "Co", "Cs", "Zl", "Zp"):
        return None
    name = unicodedata.name(character, "no name")
    return f"the invisible character U+{ord(character):04X} ({name})"
