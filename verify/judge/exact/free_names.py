"""Names of free symbols among the base variables: a mark and the source's own token.

The mark keeps a source's letter apart from a quantity of a setting that is called like it; no
quantity has a space in its name. People are shown the token alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from gainproof.verify.judge.exact.expression import Expr

_MARK = "free "


def free_name(token: str) -> str:
    """The name of the variable that a free symbol stands for."""
    return _MARK + token


def is_free(expr: Expr) -> bool:
    """Whether an expression is the variable of a free symbol."""
    return expr.kind == "symbol" and expr.name.startswith(_MARK)


def token_of(name: str) -> str:
    """The source's token of a free symbol; other names as they are."""
    return name.removeprefix(_MARK)


def with_tokens(labels: Mapping[str, str], names: Iterable[str]) -> dict[str, str]:
    """The labels, and tokens for names that have none: terms of a sequence become variables only
    when a sum is written out, long after the setting's symbols were labelled.
    """
    return {**{name: token_of(name) for name in names}, **labels}
