"""Whether a formula is LaTeX or plain text, where nobody says so."""

from __future__ import annotations

import re

MARK = re.compile(r"\^(?:\{[-+]\}|[-+](?=\s*(?:[-+=/)},<>\\]|$)))")
"""A minus or plus above a name, for what is predicted or updated."""


def is_plain(formula: str) -> bool:
    """Whether a formula is typed as plain text: it has no commands of LaTeX and no marks of names
    such as `P^-`.
    """
    return "\\" not in formula and MARK.search(formula) is None
