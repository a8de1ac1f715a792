"""LaTeX text scanned by hand: comments and verbatim parts blanked, braces matched. Nothing is
expanded or followed; line numbers stay what they are.
"""

from __future__ import annotations

_MOST_ARGUMENT = 1000
_VERBATIM = ("verbatim", "verbatim*", "lstlisting", "comment", "minted", "filecontents")


def without_comments(text: str) -> str:
    """The text with comments and verbatim environments replaced by blanks, line by line."""
    return _without_verbatim("\n".join(_uncommented(line) for line in text.split("\n")))


def _uncommented(line: str) -> str:
    start = 0
    while (place := line.find("%", start)) >= 0:
        before = place
        while before > start and line[before - 1] == "\\":
            before -= 1
        if (place - before) % 2 == 0:
            return line[:place]
        start = place + 1
    return line


def _without_verbatim(text: str) -> str:
    for name in _VERBATIM:
        opening, closing = f"\\begin{{{name}}}", f"\\end{{{name}}}"
        pieces, position = [], 0
        while (start := text.find(opening, position)) >= 0:
            end = text.find(closing, start)
            end = len(text) if end < 0 else end + len(closing)
            pieces += [text[position:start], "\n" * text.count("\n", start, end)]
            position = end
        text = "".join([*pieces, text[position:]])
    return text


def body_start(text: str) -> int:
    """Where the document begins: after its preamble, if it has one."""
    mark = "\\begin{document}"
    place = text.find(mark)
    return place + len(mark) if place >= 0 else 0


def group_end(text: str, opening: int, most: int = _MOST_ARGUMENT) -> int | None:
    """The position after the brace that closes the one at `opening`; None if none does within
    `most` characters.
    """
    depth, position = 0, opening
    while position < min(len(text), opening + most):
        match text[position]:
            case "\\":
                position += 1
            case "{":
                depth += 1
            case "}":
                depth -= 1
                if depth == 0:
                    return position + 1
        position += 1
    return None


def argument_of(text: str, command: str) -> str | None:
    """The argument in braces of the first `command` that has one, such as `\\title`, as plain text
    on one line.
    """
    place = text.find(command + "{")
    if place < 0:
        return None
    opening = place + len(command)
    end = group_end(text, opening)
    if end is None:
        return None
    inner = _without_thanks(text[opening + 1 : end - 1])
    kept = "".join(c if c.isprintable() else " " for c in inner)
    return " ".join(kept.replace("\\\\", " ").split())[:300] or None


def _without_thanks(text: str) -> str:
    """The text without the footnotes that titles and authors carry."""
    mark = "\\thanks"
    while (place := text.find(mark + "{")) >= 0:
        end = group_end(text, place + len(mark))
        if end is None:
            break
        text = text[:place] + text[end:]
    return text
