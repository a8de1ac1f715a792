"""Names in plain text: the LaTeX token without its backslashes, `alpha_k` for `\\alpha_k` and
`dot{x}_{sk-1}` for `\\dot{x}_{sk-1}`.
"""

from __future__ import annotations

from collections.abc import Iterable


def plain_name(token: str) -> str:
    """How a canonical token is written in plain text; braces round letters and digits only are left
    out of a subscript: `x_sk`.
    """
    text = token.replace("\\", "")
    start = text.rfind("_{")
    inner = text[start + 2 : -1]
    if start > 0 and text.endswith("}") and inner.isascii() and inner.isalnum():
        return f"{text[:start]}_{inner}"
    return text


def plain_table(tokens: Iterable[str]) -> dict[str, tuple[str, ...]]:
    """The tokens that a name in plain text may stand for: one, unless two look alike without
    backslashes.
    """
    found: dict[str, tuple[str, ...]] = {}
    for token in tokens:
        for name in {plain_name(token), token.replace("\\", "")}:
            found[name] = (*found.get(name, ()), token)
    return found
