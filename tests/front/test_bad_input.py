"""Unknown names are answered with the nearest ones."""

from __future__ import annotations

import pytest

from gainproof.bad_input import nearest, unknown_name

KNOWN = ["random-velocity", "random-acceleration", "least-squares-line", "least-squares-mean"]


@pytest.mark.parametrize(
    ("name", "first"),
    [
        ("random-velocty", "random-velocity"),
        ("random_velocity", "random-velocity"),
        ("Random-Acceleration", "random-acceleration"),
        ("mean", "least-squares-mean"),
        ("least-square-lines", "least-squares-line"),
    ],
)
def test_nearest(name: str, first: str) -> None:
    assert nearest(name, KNOWN)[0] == first


def test_the_message_says_what_came_and_what_is_near() -> None:
    text = str(unknown_name("derivation", "random-velocty", KNOWN))
    assert "'random-velocty'" in text
    assert "nearest: random-velocity" in text


def test_without_a_near_name_all_are_named_if_few() -> None:
    assert "known: " in str(unknown_name("derivation", "zzz", KNOWN))
    assert "gainproof list" in str(unknown_name("claim", "zzz", map(str, range(100, 200))))
