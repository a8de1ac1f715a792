"""Sentences of derivations as HTML: formulas set, numbers of other steps as links to them."""

from __future__ import annotations

from collections.abc import Mapping

from markupsafe import Markup, escape

from gainproof.book.mathematics import inline
from gainproof.formulas.prose import latex_math, pieces


def prose(
    text: str, symbols: Mapping[str, str], numbers: Mapping[str, int] | None = None
) -> Markup:
    """`text` with its formulas between backticks in mathematical type. `symbols`: LaTeX of the
    names; `numbers`: the number of each step that can be referred to, by id.
    """
    found = []
    for kind, part in pieces(text):
        if kind == "formula":
            found.append(inline(latex_math(part, symbols)))
        elif kind == "step" and numbers is not None:
            link = Markup('<a href="#step-{}">{}</a>')
            found.append(link.format(part, numbers[part]))
        else:
            found.append(escape(part if kind == "text" else f"@{part}"))
    return Markup().join(found)
