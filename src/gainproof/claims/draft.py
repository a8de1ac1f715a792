"""A claim file drafted from a LaTeX document: its displayed equations with their numbers, their
symbols, and a mark wherever the user has to say something.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice

from gainproof.claims.symbols_met import Met, symbols_met
from gainproof.claims.template import FORMAT_LINE, KINDS_COMMENT, SETTINGS_COMMENT, SYMBOLS_COMMENT
from gainproof.claims.tex_macros import Macro, expanded, macros_in, with_displays
from gainproof.claims.tex_rows import Equation, equations
from gainproof.claims.tex_text import argument_of, without_comments
from gainproof.claims.toml_text import comment, quoted

MOST_EQUATIONS = 1000
MOST_FORMULA = 4000
_MOST_SHOWN = 2000
MOST_SETTLED = 6
"""Functions of one equation whose argument is taken, and brackets that are tried."""
_INVERSE = re.compile(r"\\(sin|cos|tan)\s*\^\s*\{\s*-\s*1\s*\}")
_UNCLEAR = re.compile(r"what \S+ acts on is not clear: write (.+)", re.DOTALL)


@dataclass(frozen=True)
class Draft:
    """The text of the claim file, and how many equations it has and how many of them are only
    comments.
    """

    text: str
    equations: int
    unread: int


def draft(tex: str, name: str, key: str) -> Draft:
    """The draft of a claim file from the text of a LaTeX file. Its macros are put in; nothing in it
    is executed, no included file read; `name` is its name, `key` that of the source.
    """
    text = without_comments(tex)
    macros = macros_in(text)
    printed = islice(equations(with_displays(text, macros)), MOST_EQUATIONS)
    readings = [_reading(equation, macros) for equation in printed]
    found = [one.equation for one in readings]
    met = [one.met for one in readings]
    claims = [
        _claim(one, identifier) for one, identifier in zip(readings, _ids(found), strict=True)
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


@dataclass(frozen=True)
class _Read:
    """An equation as it was read, or why it was not; `taken` says what was taken for what."""

    equation: Equation
    met: Met
    taken: tuple[str, ...] = ()


def _reading(equation: Equation, macros: Mapping[str, Macro]) -> _Read:
    """How an equation was read."""
    if len(equation.latex) > MOST_FORMULA:
        return _Read(equation, Met((), None, f"more than {MOST_FORMULA} characters: leave it out"))
    try:
        equation = replace(equation, latex=expanded(equation.latex, macros))
    except ValueError as error:
        return _Read(equation, Met((), None, f"the macro {error}: write it out"))
    return _read(equation)


def _read(equation: Equation) -> _Read:
    """An equation with what is usually meant by a print that the reader finds open: `\\tan^{-1}` is
    the inverse, what follows a sine is in it up to a sum or a bracket.
    """
    latex = equation.latex
    inverse = dict.fromkeys(_INVERSE.findall(latex))
    taken = [f"\\{function}^{{-1}} was taken as \\arc{function}" for function in inverse]
    latex = _INVERSE.sub(r"\\arc\1", latex)
    met = symbols_met(latex, transposes=True)
    for _ in range(MOST_SETTLED):
        form = _settled(latex, met)
        if form is None:
            break
        latex, words = form
        taken.append(words)
        met = symbols_met(latex, transposes=True)
    if met.formula is None:
        met = replace(met, problem=f"{met.problem}: write it in another way or leave it out")
        return _Read(equation, met)
    return _Read(replace(equation, latex=latex), met, tuple(taken))


def _settled(latex: str, met: Met) -> tuple[str, str] | None:
    """The equation with brackets where the reader asks for them, and what was taken; None where it
    does not ask.
    """
    unclear = _UNCLEAR.fullmatch(met.problem)
    if unclear is None:
        return None
    wide, _, narrow = unclear[1].partition(" or ")
    form = narrow or wide if met.token in ("(", "[") else wide
    for place in [match.start() for match in re.finditer(r"\(", form)][:MOST_SETTLED]:
        # of the form with brackets what stood there without
        shown, rest = form[:place], form[place + 1 :]
        close = rest.rfind(")") if form is wide else rest.find(")")
        bare = rest[:close] + rest[close + 1 :]
        pattern = re.escape(shown) + r"\s*" + re.escape(bare)
        if found := re.search(pattern, latex):
            whole = latex[: found.start()] + form + latex[found.end() :]
            return whole, f"{found[0]} was taken as {form}"
    return None


def _or_todo(field: str, value: str | None) -> str:
    return f"{field} = {quoted(value)}" if value else f'{field} = "TODO"'


def _authors(text: str) -> list[str]:
    names = (argument_of(text, "\\author") or "TODO").split("\\and ")
    return [name.strip() for name in names[:50] if name.strip()] or ["TODO"]


def _symbols(found: Sequence[Equation], met: Sequence[Met]) -> list[str]:
    """A declaration of each symbol of the equations that were read, with the first few of these.
    One that stands under a transpose in one of them is a matrix in all.
    """
    matrices = {name: of for one in met for name, of in one.matrices.items()}
    places: dict[str, list[str]] = {}
    for equation, one in zip(found, met, strict=True):
        for token in one.symbols if one.formula is not None else ():
            where = places.setdefault(token, [])
            where += [] if _short_place(equation) in where else [_short_place(equation)]
    lines = []
    for token, where in places.items():
        more = f" and {len(where) - 3} more" if len(where) > 3 else ""
        entry = 'unit = "TODO", meaning = "TODO"'
        if token in matrices:
            entry = f'shape = "TODO", {entry}'
        if matrices.get(token):
            of = ", ".join(map(quoted, matrices[token]))
            entry = f'definition = "TODO", arguments = [{of}], shape = "TODO", meaning = "TODO"'
        entry = f"{{ {entry} }}"
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


def _claim(read: _Read, name: str) -> list[str]:
    equation, met = read.equation, read.met
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
        return [*(comment(f"TODO {words}") for words in read.taken), *lines]
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
