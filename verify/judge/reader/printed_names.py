"""Symbols as printed: accents, letters, primes and subscripts, scanned by hand into one canonical
spelling.

No regular expression: one with nested optional parts can take minutes on a few thousand accents.
`\\dot x_{s k-1}`, `\\dot{x}_{sk-1}` and `\\dot{{x}}_{sk-1}` are one name, canonically
`\\dot{x}_{sk-1}`.
"""

from __future__ import annotations

from gainproof.verify.judge.reader.alphabet import (
    ACCENTS,
    DIGITS,
    GREEK,
    command_at,
    is_letter,
    skip_space,
)
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_NAME_CHARACTERS
from gainproof.verify.judge.reader.name_marks import Mark, scan_mark_above, scan_mark_behind
from gainproof.verify.judge.reader.subscripts import scan_subscript

_MOST_ACCENTS = 6
DIFFERENCE = "\\Delta"
"""Before another symbol it makes a name with it, where that is declared: `\\Delta R_i`."""


def scan_base(text: str, position: int, accents: int = 0) -> tuple[str, int] | None:
    """One accented or plain letter at `position` as (canonical text, end), or None where no symbol
    begins. Under an accent a digit is a letter too: `\\mathbf{0}`.
    """
    if position < len(text) and (
        is_letter(text[position]) or (accents and text[position] in DIGITS)
    ):
        return text[position], position + 1
    if position >= len(text) or text[position] != "\\":
        return None
    command = command_at(text, position)
    end = position + len(command)
    if command in GREEK:
        return command, end
    if command not in ACCENTS:
        return None
    if accents >= _MOST_ACCENTS:
        raise ReaderError(
            f"more than {_MOST_ACCENTS} accents on one symbol", text, position, command
        )
    inner, end = _accent_argument(text, skip_space(text, end), command, accents)
    return f"{command}{{{inner}}}", end


def _accent_argument(text: str, position: int, command: str, accents: int) -> tuple[str, int]:
    if text[position : position + 1] != "{":
        found = scan_base(text, position, accents + 1)
        if found is None:
            raise ReaderError(
                f"{command} needs a letter", text, position, text[position : position + 1]
            )
        return found
    opening = position
    while text[position : position + 1] == "{":
        position = skip_space(text, position + 1)
        if position - opening > MOST_NAME_CHARACTERS:
            raise ReaderError("a name is too long", text, opening, command)
    braces = text[opening:position].count("{")
    found = _accented_word(text, position) or scan_base(text, position, accents + 1)
    if found is None:
        raise ReaderError(
            f"{command} needs a letter", text, position, text[position : position + 1]
        )
    inner, position = scan_decorations(text, *found)
    for _ in range(braces):
        position = skip_space(text, position)
        if text[position : position + 1] != "}":
            raise ReaderError(
                f"{command}{{...}} must hold one symbol",
                text,
                position,
                text[position : position + 1],
            )
        position += 1
    return inner, position


def scan_word(text: str, position: int) -> tuple[str, int] | None:
    """A run of Latin letters at `position`, or None."""
    end = position
    while end < len(text) and is_letter(text[end]):
        end += 1
    return (text[position:end], end) if end > position else None


def _accented_word(text: str, position: int) -> tuple[str, int] | None:
    """A run of Latin letters with digits behind them: `\\operatorname{atan2}`."""
    found = scan_word(text, position)
    if found is None:
        return None
    end = found[1]
    while text[end : end + 1] in DIGITS:
        end += 1
    return text[position:end], end


def scan_decorations(text: str, base: str, position: int) -> tuple[str, int]:
    """Primes and a subscript after `base`, which ends at `position`, as (canonical name, end)."""
    primes, subscript, start = "", "", position
    while True:
        following = skip_space(text, position)
        character = text[following : following + 1]
        if character == "'":
            primes += "'"
            position = following + 1
        elif character == "^" and (end := _prime_above(text, following)) is not None:
            primes += "'"
            position = end
        elif character == "_" and not subscript:
            subscript, position = scan_subscript(text, following + 1)
        else:
            break
        if position - start > MOST_NAME_CHARACTERS:
            raise ReaderError(f"a name of more than {MOST_NAME_CHARACTERS} characters", text, start)
    return base + primes + subscript, position


def _prime_above(text: str, position: int) -> int | None:
    """The end of `^\\prime` or `^{\\prime}` at `position`, or None."""
    start = skip_space(text, position + 1)
    for spelling in ("\\prime", "{\\prime}"):
        end = start + len(spelling)
        if text.startswith(spelling, start) and not is_letter(text[end : end + 1]):
            return end
    return None


def scan_names(text: str, base: str, position: int) -> list[tuple[str, int]]:
    """The names that may begin with `base`, which ends at `position`, as (canonical name, end):
    those of a difference first, then the one with most marks, the one without marks last.
    """
    plain, end = scan_decorations(text, base, position)
    found = [(plain, end)]
    above = scan_mark_above(text, end)
    if above is not None:
        name, after = plain, above.end
        if plain.rstrip("'") == base:
            # the subscript may be printed after the mark
            name, after = scan_decorations(text, plain, above.end)
        found.append((name + above.text, after))
    with_behind = [_with_behind(text, name, after) for name, after in found]
    found += [item for item in with_behind if item is not None]
    if any(after - position > MOST_NAME_CHARACTERS for _, after in found):
        found = [item for item in found if item[1] - position <= MOST_NAME_CHARACTERS]
    return [*_differences(text, base, position), *found[::-1]]


def _differences(text: str, base: str, position: int) -> list[tuple[str, int]]:
    """The names of a difference that may begin with a Delta, which ends at `position`."""
    if base != DIFFERENCE:
        return []
    inner = scan_base(text, skip_space(text, position))
    if inner is None or inner[0] == DIFFERENCE:
        return []
    return [(f"{DIFFERENCE} {name}", end) for name, end in scan_names(text, *inner)]


def _with_behind(text: str, name: str, end: int) -> tuple[str, int] | None:
    behind: Mark | None = scan_mark_behind(text, end)
    return None if behind is None else (name + behind.text, behind.end)


def names_in(text: str, longest_run: int) -> set[str]:
    """The names that the symbols of a formula may have, each with all its marks; of a run of
    letters each part's, of at most `longest_run` letters. What cannot be scanned is passed over.
    """
    found: set[str] = set()
    position = 0
    while position < len(text):
        end = position + len(command_at(text, position) if text[position] == "\\" else " ")
        try:
            base = scan_base(text, position)
            word = scan_word(text, position)
            ends = range(position + 1, word[1] + 1)[:longest_run] if word else ()
            bases = [(text[position:last], last) for last in ends]
            for name, last in bases or ([base] if base else []):
                longest = max(scan_names(text, name, last), key=lambda item: item[1])
                found.add(longest[0])
                # behind a letter its run goes on, behind a Delta what it may be the change of
                if not (last > position + 1 if word else name == DIFFERENCE):
                    end = max(end, longest[1])
        except ReaderError:
            pass
        position = end
    return found


def canonical_token(text: str) -> str:
    """The canonical spelling of one declared symbol; ReaderError if `text` is not one symbol."""
    start = skip_space(text, 0)
    found = scan_word(text, start) or scan_base(text, start)
    if found is None:
        raise ReaderError(
            "a symbol begins with a letter, a Greek letter or an accent",
            text,
            start,
            text[start : start + 1],
        )
    readings = scan_names(text, *found)
    ends = [skip_space(text, end) for _, end in readings]
    if len(text) not in ends:
        end = max(ends, default=found[1])
        raise ReaderError("more follows after the symbol", text, end, text[end : end + 1])
    name = readings[ends.index(len(text))][0]
    if len(name) > MOST_NAME_CHARACTERS:
        raise ReaderError(f"a name of more than {MOST_NAME_CHARACTERS} characters", text, start)
    return name
