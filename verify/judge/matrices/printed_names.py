"""Names of matrices and of sizes as printed: accents, a letter, primes, a subscript."""

from __future__ import annotations

from gainproof.verify.judge.reader.alphabet import ACCENTS, BLANKS, GREEK, command_at, is_letter
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_NAME_CHARACTERS

MOST_ACCENTS = 6
SQUARE = "^2"
_SPACES = frozenset(("\\,", "\\;", "\\:", "\\!", "\\ "))


def skip_blanks(text: str, position: int) -> int:
    """The first position from here on that prints something."""
    while position < len(text):
        if text[position] in BLANKS or text[position] == "~":
            position += 1
        elif text[position] == "\\" and text[position : position + 2] in _SPACES:
            position += 2
        else:
            break
    return position


def scan_symbol(text: str, position: int) -> tuple[str, int] | None:
    """The canonical name at `position` and its end, without a subscript; None where none begins.
    Accents come in one order, since they are printed above one another or not at all so.
    """
    accents: list[str] = []
    open_braces = 0
    start = position
    while True:
        position = skip_blanks(text, position)
        command = command_at(text, position) if text[position : position + 1] == "\\" else ""
        if command in ACCENTS:
            accents.append(command)
            position += len(command)
            if len(accents) > MOST_ACCENTS:
                raise ReaderError(f"more than {MOST_ACCENTS} accents", text, start, command)
        elif accents and text[position : position + 1] == "{":
            open_braces += 1
            position += 1
            if open_braces > MOST_NAME_CHARACTERS:
                raise ReaderError("a name is too long", text, start)
        else:
            break
    if command in GREEK:
        base, position = command, position + len(command)
    elif position < len(text) and (
        is_letter(text[position]) or (accents and text[position] == "0")
    ):
        base, position = text[position], position + 1
    elif accents:
        raise ReaderError(f"{accents[-1]} needs a letter", text, position)
    else:
        return None
    base, position = _with_primes(text, base, position)
    inner = ""
    if open_braces:
        inner, position = scan_subscript(text, position)
    for _ in range(open_braces):
        position = skip_blanks(text, position)
        if text[position : position + 1] != "}":
            raise ReaderError("an accent over more than one symbol", text, position)
        position += 1
    for accent in sorted(accents, reverse=True):
        base = f"{accent}{{{base}}}"
    return with_subscript(base, inner), position


def _with_primes(text: str, base: str, position: int) -> tuple[str, int]:
    while text[position : position + 1] == "'":
        base, position = base + "'", position + 1
    return base, position


def with_subscript(base: str, subscript: str) -> str:
    """The canonical spelling."""
    if not subscript:
        return base
    single = len(subscript) == 1 or subscript in GREEK
    return f"{base}_{subscript}" if single else f"{base}_{{{subscript}}}"


def scan_subscript(text: str, position: int) -> tuple[str, int]:
    """The canonical content of a subscript at `position`, and its end; empty if there is none."""
    place = skip_blanks(text, position)
    if text[place : place + 1] != "_":
        return "", position
    place = skip_blanks(text, place + 1)
    if text[place : place + 1] != "{":
        found = scan_symbol(text, place)
        if found is not None:
            return found
        if text[place : place + 1].isdigit():
            return text[place], place + 1
        raise ReaderError("a subscript is wanted", text, place)
    end, depth = place, 0
    while end < len(text):
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        end += 1
        if depth == 0:
            break
    if depth or end - place > MOST_NAME_CHARACTERS:
        raise ReaderError("a subscript that does not end, or is too long", text, place)
    return _packed(text[place + 1 : end - 1]), end


def _packed(inner: str) -> str:
    """Without blanks, and without braces round one character."""
    kept: list[str] = []
    position = 0
    while position < len(inner):
        after = skip_blanks(inner, position)
        if after > position:
            position = after
            continue
        if inner[position] == "{" and inner[position + 2 : position + 3] == "}":
            kept.append(inner[position + 1])
            position += 3
        elif inner[position] == "\\":
            command = command_at(inner, position)
            kept.append(command)
            position += len(command)
            if (
                is_letter(command[-1])
                and position < len(inner)
                and is_letter(inner[skip_blanks(inner, position) :][:1] or " ")
            ):
                kept.append(" ")
        else:
            kept.append(inner[position])
            position += 1
    return "".join(kept)


def square_at(text: str, position: int) -> int:
    """The end of a square, `^2` or `^{2}`, at a position; the position if there is none."""
    place = skip_blanks(text, position)
    for power in ("^2", "^{2}"):
        if text.startswith(power, place):
            return place + len(power)
    return position


def canonical(text: str) -> str:
    """The canonical name that the whole of `text` spells, perhaps with a square behind it, which
    then is part of the name: that of a variance. Raises ReaderError.
    """
    found = scan_symbol(text, 0)
    if found is None:
        raise ReaderError("a letter with accents and a subscript is wanted", text, 0)
    base, position = found
    subscript, position = scan_subscript(text, position)
    end = square_at(text, position)
    if skip_blanks(text, end) != len(text):
        raise ReaderError("a letter with accents and a subscript is wanted", text, position)
    name = with_subscript(base, subscript) if subscript else base
    return name + SQUARE if end > position else name
