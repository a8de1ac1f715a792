"""Plain sentences in which symbols stand as LaTeX: the symbols set, the words as they are."""

from __future__ import annotations

import re

from markupsafe import Markup, escape

from gainproof.book.mathematics import inline

_GROUP = r"\{(?:[^{}]|\{[^{}]*\})*\}"
_SYMBOL = re.compile(
    rf"(\\[A-Za-z]+(?:{_GROUP})?(?:[_^](?:{_GROUP}|\\?\w))*)|([A-Za-z][_^]{_GROUP})"
)
_WORDS = frozenset({r"\text", r"\begin", r"\end", r"\left", r"\right", r"\frac", r"\sqrt"})
"""Commands that begin a formula of which a symbol is only a part: such text stays as it is."""


def with_symbols(text: str) -> Markup:
    """`at \\alpha = 1/2 ...` with the letter set."""
    if any(word in text for word in _WORDS):
        return escape(text)
    found, place = [], 0
    for match in _SYMBOL.finditer(text):
        found += [escape(text[place : match.start()]), inline(match[0])]
        place = match.end()
    return Markup().join([*found, escape(text[place:])])
