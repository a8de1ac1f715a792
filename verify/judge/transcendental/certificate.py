"""Certificates of statements with functions: going through one again begins with the statement."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.certificate import Data, statement_data
from gainproof.verify.judge.exact.statement import Outcome, Statement

Decides = Callable[[Statement, Mapping[str, Box], str | None, Mapping[str, str]], Outcome]
"""A verdict on a statement, its domain, the parameter and what symbols are called."""


def certificate_of(
    statement: Statement,
    boxes: Mapping[str, Box],
    parameter: str | None,
    labels: Mapping[str, str],
    how: Mapping[str, Any] = MappingProxyType({}),
) -> Data:
    """The statement on the domains of its own symbols, and `how` it was decided."""
    own = {name: box for name, box in boxes.items() if name in statement.symbols()}
    data = statement_data(statement, own, parameter, labels)
    return {**how, "checked": "replayed", "engine": "functions", "statement": data}
