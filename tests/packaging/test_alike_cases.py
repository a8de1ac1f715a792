"""Of many cases of one kind the default run takes a few, spread evenly, and no test goes whole."""

from __future__ import annotations

from collections import Counter

import one_of_each
import pytest

PYTEST_FILE = """
import pytest

@pytest.mark.alike
@pytest.mark.parametrize("number", range(COUNT))
def test_many(number: int) -> None: ...

@pytest.mark.parametrize("number", range(7))
def test_all(number: int) -> None: ...
"""
pytest_plugins = ("pytester",)


@pytest.mark.parametrize(
    ("count", "kept"), [(1, {0}), (2, {0, 1}), (3, {0, 1, 2}), (8, {0, 4, 7}), (41, {0, 20, 40})]
)
def test_first_middle_and_last_stay(pytester: pytest.Pytester, count: int, kept: set[int]) -> None:
    place = pytester.makepyfile(PYTEST_FILE.replace("COUNT", str(count)))
    pytester.makeini("[pytest]\nmarkers = alike")
    items, _ = pytester.inline_genitems(place)
    beyond = {item.nodeid for item in one_of_each.beyond_a_few(items)}
    rest = Counter(item.nodeid.split("[")[0] for item in items if item.nodeid not in beyond)
    assert sorted(rest.values()) == sorted([len(kept), 7])
    assert {n for n in range(count) if not any(f"many[{n}]" in each for each in beyond)} == kept
