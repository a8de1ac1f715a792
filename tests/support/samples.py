"""How many random cases a test draws: few by default, five times as many under `-m thorough`."""

from __future__ import annotations

import os

import pytest

VARIABLE = "GAINPROOF_SAMPLES"
"""By what the sizes of random samples are multiplied: a whole number, at least 1."""
THOROUGH = 5


def times() -> int:
    """By what sizes are multiplied in this session. Raises ValueError for what is no such number.

    Read from the environment, which the processes of pytest-xdist and of the tests inherit.
    """
    found = int(os.environ.get(VARIABLE, "1"))
    if found < 1:
        raise ValueError(f"{VARIABLE}: wanted a whole number, at least 1, got {found}")
    return found


def samples(by_default: int) -> int:
    """The size of a random sample that has so many cases by default.

    A test that uses it and is none of Hypothesis is marked `sampled`, so that thorough runs have
    it.
    """
    return by_default * times()


def thorough(expression: str) -> bool:
    """Whether pytest's `-m` asks for thorough cases."""
    return "thorough" in expression and "not thorough" not in expression


def draws(item: pytest.Item) -> bool:
    """Whether a test draws random cases."""
    from hypothesis import is_hypothesis_test

    marked = item.get_closest_marker("sampled") is not None
    return marked or is_hypothesis_test(getattr(item, "obj", None))
