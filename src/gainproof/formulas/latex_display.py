"""Formulas of one display in LaTeX: below each other at their equals signs, long ones broken."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

_WIDEST = 72  # signs of about 2 mm, for a list in an article with margins of 25 mm
_MATRIX = re.compile(r"\\begin\{pmatrix\}(.*?)\\end\{pmatrix\}")
_OPEN = (r"\left", r"\begin", "{")
_CLOSE = (r"\right", r"\end", "}")
_SIGNS = (" = ", " + ", " - ", r" \to ")
_CONDITION = r"\text{    if }"
"""How the line of what an implication takes for granted begins."""
_FACTORS = (r" \left(", r" \begin{pmatrix}")


def aligned(lines: Sequence[str]) -> str:
    """The rows of an `align*`: at their equals signs if each line has one, else at their left.
    Conditions stand further in, whatever the others do.
    """
    places = [_outside(line, (" = ",)) for line in lines]
    if all(p or line.startswith(_CONDITION) for line, p in zip(lines, places, strict=True)):
        return "\\\\\n".join(
            _condition(line) if line.startswith(_CONDITION) else _at_sign(line, next(iter(p)) + 1)
            for line, p in zip(lines, places, strict=True)
        )
    return "\\\\\n".join("&" + "\\\\\n&\\qquad ".join(_broken(line, _WIDEST)) for line in lines)


def _condition(line: str) -> str:
    return "&\\quad " + "\\\\\n&\\qquad\\qquad ".join(_broken(line, _WIDEST - 12))


def _at_sign(line: str, place: int) -> str:
    """A line aligned before its equals sign, on several rows if it is long."""
    left, right = line[:place], line[place:]
    if _width(left) + _width(right) <= _WIDEST:
        return f"{left}&{right}"
    if _width(left) <= _WIDEST // 4:
        rows = _broken(right, _WIDEST - _width(left))
        return f"{left}&" + "\\\\\n&\\qquad ".join(rows)
    below = [f"\\quad {_broken(right, _WIDEST)[0]}", *_broken(right, _WIDEST)[1:]]
    return "&" + "\\\\\n&\\qquad ".join([*_broken(left, _WIDEST), *below])


def _broken(line: str, width: int) -> list[str]:
    """Rows of at most `width`, each after the first with a sign before it, where that can be."""
    places, factors = _outside(line, _SIGNS), _outside(line, _FACTORS)
    rows, start = [], 0
    while _width(line[start:]) > width:
        cut = _last_fitting(line, start, places, width) or _last_fitting(
            line, start, factors, width
        )
        if cut is None:
            break
        rows.append(line[start:cut])
        start = cut + 1
    return [*rows, line[start:]]


def _last_fitting(line: str, start: int, places: Sequence[int], width: int) -> int | None:
    fitting = [p for p in places if p > start and _width(line[start:p]) <= width]
    return fitting[-1] if fitting else None


def _outside(line: str, signs: Sequence[str]) -> list[int]:
    """Where one of the signs stands outside braces, environments and growing parentheses."""
    return list(_places(line, tuple(signs)))


def _places(line: str, signs: tuple[str, ...]) -> Iterator[int]:
    depth = 0
    for place in range(len(line)):
        depth += line.startswith(_OPEN, place) - line.startswith(_CLOSE, place)
        if depth == 0 and line.startswith(signs, place):
            yield place


def _width(latex: str) -> int:
    """About how many signs a formula is wide: a matrix as wide as its longest row, a fraction as
    both its parts.
    """
    latex = _MATRIX.sub(lambda found: _longest_row(found[1]), latex)
    rows = re.sub(r"\\begin\{\w+\}|\\end\{\w+\}|\\(?:left|right|text|mathrm|parbox)", "", latex)
    signs = re.sub(r"\\[A-Za-z]+", "x", re.sub(r"\\frac", "", rows))
    return len(re.sub(r"[{}^_\s]", "", signs))


def _longest_row(body: str) -> str:
    """The longest row of a matrix, with its parentheses and the gaps between its columns."""
    row = max(body.split(r" \\ "), key=lambda row: _width(row) + row.count("&"))
    return f"({row.replace('&', '&&')})"
