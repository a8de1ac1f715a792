"""Of the cases of a test the default run has one of each kind; `-m thorough` has the rest."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, TypeVar

import pytest

Case = TypeVar("Case")


def cases(every: Iterable[Case], kept: Callable[[Case], bool]) -> list[Any]:
    """All as parameters of a test, those that are not `kept` marked as thorough. A tuple holds the
    values of several parameters.
    """
    return [
        pytest.param(*values, marks=[] if kept(case) else pytest.mark.thorough)
        for case in every
        for values in [case if isinstance(case, tuple) else (case,)]
    ]


def further(*values: Any) -> Any:
    """A case that `-m thorough` has, of a kind of which the default run has another."""
    return pytest.param(*values, marks=pytest.mark.thorough)
