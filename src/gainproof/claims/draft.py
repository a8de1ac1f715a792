"""A claim file drafted from a LaTeX document: its displayed equations with their numbers, their
symbols, and a mark wherever the user has to say something.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from gainproof.claims.symbols_met import Met, symbols_met
from gainproof.claims.template import FORMAT_LINE, KINDS_COMMENT, SETTINGS_COMMENT, SYMBOLS_COMMENT
from gainproof.claims.tex_rows import Equation, equations
from gainproof.claims.tex_text import argument_of, macro_of, without_comments
from gainproof.claims.toml_text import comment, quoted

MOST_EQUATIONS = 1000
MOST_FORMULA = 4000
_MOST_SHOWN = 2000
_MOST_MACRO = 100


@dataclass(frozen=True)
class Draft:
    """The text of the claim file, and how many equations it has and how many of them are only
    comments.
    """

    text: str
    equations: int
    unread: int


def draft(tex: str, name: str, key: str) -> Draft:
    """The draft of a claim file from the text of a LaTeX file. Nothing in it is executed, no macro
    expanded, no included file read; `name` is its name, `key` that of the source.
    """
    text = without_comments(tex)
    found: list[Equation] = []
    for equation in equations(text):
        if len(found) == MOST_EQUATIONS:
            break
        found.append(equation)
    met = [_met(equation, text) for equation in found]
    claims = [
        _claim(equation, one, name)
        for equation, one, name in zip(found, met, _ids(found), strict=True)
    ]
    parts = [
        comment(f"Drafted from {name}. Say what is marked TODO, then: gainproof check THIS-FILE"),
        comment("Numbers of equations are counted as LaTeX does without sections: compare them."),
        FORMAT_LINE,
        "",
        "[source]",
        f"key = {quoted(key)}",
        _or_todo("title", argument_of(text, "\\title")),
        f"authors = [{', '.join(map(quoted, _authors(text)))}]",
        'publication = "TODO"  # journal, volume, pages; or "unpublished"',
        "",
        SETTINGS_COMMENT.rstrip(),
        "[settings.main]",
        'title = "TODO"  # what the claims are about, in words',
        'kind = "TODO"',
        "",
        SYMBOLS_COMMENT.rstrip(),
        "[settings.main.symbols]",
        *_symbols(found, met),
        "",
        KINDS_COMMENT.rstrip(),
        *[line for claim in claims for line in ("", *claim)],
    ]
    unread = sum(1 for one in met if one.formula is None)
    return Draft("\n".join(parts) + "\n", len(found), unread)


def _met(equation: Equation, text: str) -> Met:
    """The symbols of an equation, or why it was not read and what to do about it."""
    if len(equation.latex) > MOST_FORMULA:
        return Met((), None, f"more than {MOST_FORMULA} characters: leave it out")
    met = symbols_met(equation.latex)
    return met if met.formula is not None else replace(met, problem=_problem(met, text))


def _problem(met: Met, text: str) -> str:
    """Why an equation was not read, and what to do about it."""
    macro = macro_of(text, met.token) if met.token.startswith("\\") else None
    if macro is not None:
        stands = f", for {macro[:_MOST_MACRO]}" if macro else " with arguments"
        return f"{met.token} is a macro of the paper{stands}: macros are not expanded, write it out"
    if met.token == "^T":
        return (
            "a letter under a transpose is a matrix, and a draft does not know its size: declare "
            "it with shape = [rows, columns], then take away the signs of a comment"
        )
    return f"{met.problem}: write it in another way or leave it out"


def _or_todo(field: str, value: str | None) -> str:
    return f"{field} = {quoted(value)}" if value else f'{field} = "TODO"'


def _authors(text: str) -> list[str]:
    names = (argument_of(text, "\\author") or "TODO").split("\\and ")
    return [name.strip() for name in names[:50] if name.strip()] or ["TODO"]


def _symbols(found: Sequence[Equation], met: Sequence[Met]) -> list[str]:
    """A declaration of each symbol of the equations that were read, with the first few of these."""
    places: dict[str, list[str]] = {}
    for equation, one in zip(found, met, strict=True):
        for token in one.symbols if one.formula is not None else ():
            places.setdefault(token, []).append(_short_place(equation))
    lines = []
    for token, where in places.items():
        more = f" and {len(where) - 3} more" if len(where) > 3 else ""
        entry = '{ unit = "TODO", meaning = "TODO" }'
        lines.append(f"{quoted(token)} = {entry}  # in {', '.join(where[:3])}{more}")
    return lines


def _short_place(equation: Equation) -> str:
    return f"({equation.number})" if equation.number else f"line {equation.line}"


def _ids(found: Sequence[Equation]) -> list[str]:
    """An id for every equation, no two alike: its number where that can be one."""
    names: list[str] = []
    used: set[str] = set()
    for equation in found:
        number = equation.number or ""
        plain = number.isascii() and all(c.isalnum() or c in "-_.()" for c in number)
        base = number if plain and 0 < len(number) <= 40 else f"line-{equation.line}"
        name, copy = base, 1
        while name in used:
            copy += 1
            name = f"{base}-{copy}"
        used.add(name)
        names.append(name)
    return names


def _claim(equation: Equation, met: Met, name: str) -> list[str]:
    number = f"equation ({equation.number})"
    place = number if equation.number else f"equation without a number, line {equation.line}"
    label = f", label {equation.label}" if equation.label else ""
    lines = [
        "[[claims]]",
        f"id = {quoted(name)}",
        f"place = {quoted(place + label)}",
        _kind(met),
        'setting = "main"',
        f"latex = {quoted(equation.latex)}",
    ]
    if met.formula is not None:
        return lines
    shown = [comment(line[:_MOST_SHOWN]) for line in lines if not line.startswith("kind")]
    why = f"TODO not read, {met.problem}"
    return [comment(why), *shown]


def _kind(met: Met) -> str:
    """The kind, as far as the relation says it."""
    relations = met.formula.readings[0].relations if met.formula else ()
    operators = {r.operator for r in relations}
    if any(r.operator == "approx" and r.left_decimals != r.right_decimals for r in relations):
        return 'kind = "value"'
    if "->" in operators:
        return 'kind = "limit"'
    if operators & {"<", "<=", ">", ">=", "!="}:
        return 'kind = "inequality"'
    return 'kind = "identity"  # TODO or another kind'
