"""Macros of a LaTeX text put in: \\newcommand, \\def and \\DeclareMathOperator, with arguments or
without. Text is replaced by text, nothing is executed, and how often is limited.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

from gainproof.claims.tex_text import group_end

MOST_MACROS = 500
MOST_STEPS = 400
"""Macros put in for one equation."""
MOST_CHARACTERS = 4000
"""Of an equation with its macros put in."""
_LONGEST = 80
"""Letters of the name of a command."""
_DEFINES = re.compile(
    r"\\(?:(?:new|renew|provide)command\*?|DeclareRobustCommand\*?|(def)|(DeclareMathOperator)\*?)"
    r"(?![A-Za-z])\s*(\{\s*)?(\\(?:[A-Za-z]+|.))(?(3)\s*\})\s*"
)
_OTHER_DEFINES = re.compile(
    r"\\(?:let|[gex]def|(?:New|Renew|Provide|Declare)DocumentCommand)(?![A-Za-z])\s*(?:\{\s*)?"
    r"(\\(?:[A-Za-z]+|.))"
)
_NUMBER = re.compile(r"\[\s*([0-9])\s*\]\s*")
_PARAMETERS = re.compile(r"(?:#[1-9]\s*)*")
_COMMAND = re.compile(r"\\([A-Za-z]+|.)", re.DOTALL)
_PARAMETER = re.compile(r"#([1-9])")


@dataclass(frozen=True)
class Macro:
    """What a command stands for: `body` with `#1` and so on for its `arguments`, of which the first
    may stand in square brackets or be left out, where there is a `default`. Where it is defined
    `twice`, otherwise each time, nobody knows which is meant.
    """

    body: str
    arguments: int = 0
    default: str | None = None
    twice: bool = False


BUILT_IN: Mapping[str, Macro] = MappingProxyType(
    {"\\ensuremath": Macro("#1", 1), "\\xspace": Macro("")}
)


def macros_in(text: str) -> dict[str, Macro]:
    """The macros that a text defines, by command. One of another form is left out."""
    found = dict(BUILT_IN)
    others = {match[1] for match in _OTHER_DEFINES.finditer(text)}
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
        if end_of_body is None:
            others.add(name)
        if end_of_body is None or len(found) >= MOST_MACROS:
            continue
        body = " ".join(text[opening + 1 : end_of_body - 1].split())
        macro = Macro(f"\\operatorname{{{body}}}" if is_operator else body, arguments, default)
        twice = name not in BUILT_IN and found.get(name, macro) != macro
        found[name] = replace(macro, twice=twice)
    return {
        name: replace(macro, twice=True) if name in others else macro
        for name, macro in found.items()
    }


def _without_blanks(text: str, position: int) -> int:
    while position < len(text) and text[position].isspace():
        position += 1
    return position


def with_displays(text: str, macros: Mapping[str, Macro]) -> str:
    """The text with those macros put in that begin or end an environment: `\\be` and `\\ee`."""
    for name, macro in macros.items():
        if (
            not macro.arguments
            and not macro.twice
            and re.fullmatch(r"\\(begin|end)\{[a-z]+\*?\}", macro.body)
        ):
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
        if macros[name].twice:
            raise ValueError(f"{name} is defined twice")
        body, end = _body(latex, name, macros[name], end)
        before = latex[:start].rstrip()
        if before.endswith(("^", "_")) and len(body) > 1:
            body = f"{{{body}}}"
        latex, position = _joined(_joined(latex[:start], body), latex[end:]), start
        if len(latex) > MOST_CHARACTERS:
            raise ValueError(f"{name} makes more than {MOST_CHARACTERS} characters of it")
    raise ValueError(f"{name} goes on without an end")


def _joined(before: str, after: str) -> str:
    """Both texts, with a blank between where a letter would go on with the name of a command."""
    goes_on = after[:1].isalpha() and re.search(r"\\[A-Za-z]+\Z", before[-_LONGEST:])
    return f"{before} {after}" if goes_on else before + after


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

    body, rest = "", 0
    for match in _PARAMETER.finditer(macro.body):
        number = int(match[1])
        argument = given[number - 1] if number <= len(given) else match[0]
        body = _joined(_joined(body, macro.body[rest : match.start()]), argument)
        rest = match.end()
    return _joined(body, macro.body[rest:]), position
