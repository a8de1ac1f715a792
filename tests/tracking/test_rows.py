"""Records of arrays: rows chosen, changed, put after one another, records inside records too."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from numpy.typing import NDArray

from gainproof.tracking.rows import Rows


@dataclass(frozen=True)
class Pair(Rows):
    place: NDArray[np.float64]
    matrix: NDArray[np.float64]


@dataclass(frozen=True)
class Named(Rows):
    number: NDArray[np.int64]
    pair: Pair


def named(*numbers: int) -> Named:
    values = np.array(numbers, np.float64)
    return Named(np.array(numbers), Pair(values, values[:, None, None] * np.eye(2)))


def told(rows: Named) -> list[tuple[int, float, float]]:
    columns = rows.number, rows.pair.place, rows.pair.matrix[:, 1, 1]
    return list(zip(*(x.tolist() for x in columns), strict=True))


def test_rows_are_chosen_by_any_index() -> None:
    given = named(1, 2, 3)
    assert told(given.part(slice(1, None))) == [(2, 2, 2), (3, 3, 3)]
    assert told(given.part(np.array([True, False, True]))) == [(1, 1, 1), (3, 3, 3)]


def test_a_change_leaves_the_rows_that_were_there() -> None:
    given = named(1, 2, 3)
    changed = given.changed(np.array([0, 2]), named(7, 8))
    assert told(changed) == [(7, 7, 7), (2, 2, 2), (8, 8, 8)]
    assert told(given) == told(named(1, 2, 3))


def test_rows_after_rows() -> None:
    assert told(named(1).with_more(named(2, 3))) == told(named(1, 2, 3))


def test_rows_that_do_not_fit_are_an_error() -> None:
    with pytest.raises(ValueError, match="shape"):
        named(1, 2, 3).changed(np.array([0, 2]), named(4, 5, 6))
