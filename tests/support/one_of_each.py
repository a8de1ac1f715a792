"""Of the cases of a test the default run has one of each kind; `-m thorough` has the rest."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable
from typing import Any, TypeVar

import pytest

Case = TypeVar("Case")
FEW = 3
"""Cases that the default run takes of a test marked `alike`."""


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


def beyond_a_few(items: Iterable[pytest.Item]) -> list[pytest.Item]:
    """Of each test marked `alike` the cases but FEW, which are spread evenly from first to last."""
    tests: dict[str, list[pytest.Item]] = defaultdict(list)
    for item in items:
        if item.get_closest_marker("alike"):
            tests[item.nodeid.split("[")[0]].append(item)
    beyond: list[pytest.Item] = []
    for found in tests.values():
        kept = {round(n * (len(found) - 1) / (FEW - 1)) for n in range(FEW)}
        beyond += (item for number, item in enumerate(found) if number not in kept)
    return beyond
