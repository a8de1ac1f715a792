"""Macros of a LaTeX text put in: \\newcommand, \\def and \\DeclareMathOperator, with arguments or
without. Text is replaced by text, nothing is executed, and how often is limited.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from gainproof.claims.tex_text import group_end

MOST_MACROS = 500
MOST_STEPS = 400
"""Macros put in for one equation."""
MOST_CHARACTERS = 4000
"""Of an equation with its macros put in."""
_DEFINES = re.compile(
    r"\\(?:(?:new|renew|provide)command\*?|DeclareRobustCommand\*?|(def)|(DeclareMathOperator)\*?)"
    r"(?![A-Za-z])\s*(\{\s*)?(\\(?:[A-Za-z]+|.))(?(3)\s*\})\s*"
)
_NUMBER = re.compile(r"\[\s*([0-9])\s*\]\s*")
_PARAMETERS = re.compile(r"(?:#[1-9]\s*)*")
_COMMAND = re.compile(r"\\([A-Za-z]+|.)", re.DOTALL)
_PARAMETER = re.compile(r"#([1-9])")


@dataclass(frozen=True)
class Macro:
    """What a command stands for: `body` with `#1` and so on for its `arguments`, of which the first
    may stand in square brackets or be left out, where there is a `default`.
    """

    body: str
    arguments: int = 0
    default: str | None = None


BUILT_IN: Mapping[str, Macro] = MappingProxyType(
    {"\\ensuremath": Macro("#1", 1), "\\xspace": Macro("")}
)


def macros_in(text: str) -> dict[str, Macro]:
    """The macros that a text defines, by command; of two definitions the later. One of another form
    is left out.
    """
    found = dict(BUILT_IN)
    for match in _DEFINES.finditer(text):
        is_def, is_operator, _, name = match.groups()
        position, arguments, default = match.end(), 0, None
        if is_def:
            parameters = _PARAMETERS.match(text, position)
            assert parameters is not None
            arguments, position = parameters[0].count("#"), parameters.end()
        elif not is_operator and (number := _NUMBER.match(text, position)):
            arguments, position = int(number[1]), number.end()
            end = text.find("]", position, position + 200)
            if text.startswith("[", position) and end > 0:
                default, position = text[position + 1 : end], end + 1
        opening = _without_blanks(text, position)
        end_of_body = group_end(text, opening) if text.startswith("{", opening) else None
        if end_of_body is None or len(found) >= MOST_MACROS:
            continue
        body = " ".join(text[opening + 1 : end_of_body - 1].split())
        found[name] = Macro(
            f"\\operatorname{{{body}}}" if is_operator else body, arguments, default
        )
    return found


def _without_blanks(text: str, position: int) -> int:
    while position < len(text) and text[position].isspace():
        position += 1
    return position


def with_displays(text: str, macros: Mapping[str, Macro]) -> str:
    """The text with those macros put in that begin or end an environment: `\\be` and `\\ee`."""
    for name, macro in macros.items():
        if not macro.arguments and re.fullmatch(r"\\(begin|end)\{[a-z]+\*?\}", macro.body):
            body = macro.body.replace("\\", r"\\")
            text = re.sub(rf"{re.escape(name)}(?![A-Za-z])", body, text)
    return text


def expanded(latex: str, macros: Mapping[str, Macro]) -> str:
    """An equation with all macros put in. Raises ValueError, which names the macro, if that does
    not end soon, or an argument is missing.
    """
    position = 0
    for _ in range(MOST_STEPS):
        found = _next(latex, macros, position)
        if found is None:
            return latex
        name, start, end = found
        body, end = _body(latex, name, macros[name], end)
        before = latex[:start].rstrip()
        if before.endswith(("^", "_")) and len(body) > 1:
            body = f"{{{body}}}"
        elif re.search(r"\\[A-Za-z]+$", body) and latex[end : end + 1].isalpha():
            body += " "
        latex, position = latex[:start] + body + latex[end:], start
        if len(latex) > MOST_CHARACTERS:
            raise ValueError(f"{name} makes more than {MOST_CHARACTERS} characters of it")
    raise ValueError(f"{name} goes on without an end")


def _next(latex: str, macros: Mapping[str, Macro], position: int) -> tuple[str, int, int] | None:
    for match in _COMMAND.finditer(latex, position):
        if match[0] in macros:
            return match[0], match.start(), match.end()
    return None


def _body(latex: str, name: str, macro: Macro, position: int) -> tuple[str, int]:
    """What stands for a macro with its arguments, and where these end."""
    given: list[str] = []
    if macro.default is not None:
        start = _without_blanks(latex, position)
        end = latex.find("]", start) if latex.startswith("[", start) else -1
        given.append(latex[start + 1 : end] if end > 0 else macro.default)
        position = end + 1 if end > 0 else position
    while len(given) < macro.arguments:
        start = _without_blanks(latex, position)
        if start == len(latex):
            raise ValueError(f"{name} is without its argument {len(given) + 1}")
        if latex[start] == "{":
            end = group_end(latex, start) or 0
            if not end:
                raise ValueError(f"{name} has an argument without an end")
            given.append(latex[start + 1 : end - 1])
        else:
            command = _COMMAND.match(latex, start)
            end = command.end() if command else start + 1
            given.append(latex[start:end])
        position = end
    if not macro.arguments and latex.startswith("{}", position):
        position += 2

    def argument(match: re.Match[str]) -> str:
        number = int(match[1])
        return given[number - 1] if number <= len(given) else match[0]

    return _PARAMETER.sub(argument, macro.body), position
