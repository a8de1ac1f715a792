"""Graphs of formulas read into trees in which matrices are nodes; each content once."""

from __future__ import annotations

import marshal
from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.expression_graph import read_values
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Limits, Malformed

_PLAIN = 2
"""The last version of `marshal` whose text depends on nothing but content."""


def read_tree(graph: Mapping[str, Any], limits: Limits = DEFAULT_LIMITS) -> Expr:
    """The output "value" of a graph; matrices are nodes of it. Raises Malformed."""
    try:
        # by content and types: 1, 1.0 and True are different texts
        content = marshal.dumps((graph.get("nodes"), graph.get("outputs")), _PLAIN)
    except ValueError:
        return _read_tree(graph, limits)  # no plain data: what is wrong is said there
    return _known_tree(content, limits)


@lru_cache(maxsize=1 << 11)  # every convention and every use of a definition reads it again
def _known_tree(content: bytes, limits: Limits) -> Expr:
    nodes, outputs = marshal.loads(content)
    return _read_tree({"nodes": nodes, "outputs": outputs}, limits)


def _read_tree(graph: Mapping[str, Any], limits: Limits) -> Expr:
    value = read_values(graph, limits, as_tree=True).get("value")
    if not isinstance(value, Expr):
        raise Malformed("wanted a graph with an output 'value'")
    return value
