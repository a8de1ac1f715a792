"""Equations of traces with their evidence."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gainproof.derive.words.expression import Expression
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Statement, made


def prove_traces_equal(
    name: str,
    search: Search,
    left: Expression,
    right: Expression,
    used: Sequence[tuple[Expression, Any, Expression]],
) -> Statement:
    """tr left = tr right; `used`: left factor, equation (a hypothesis or statement), right factor
    of each product that is taken away.
    """
    entries = []
    for before, source, after in used:
        one, other = search.setting.expand(before), search.setting.expand(after)
        assert one.shape is not None
        cofactor = {
            "source": search.marked(source),
            "left": one.data(),
            "right": other.data(),
        }
        entries.append({"size": one.shape[0], "cofactors": [cofactor]})
    evidence = {"used": entries}
    return made(search, name, "matrix_trace", {"left": left, "right": right}, evidence)
