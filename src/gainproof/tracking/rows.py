"""Records of arrays that have a row for each track or detection."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray


class Rows:
    """Base of dataclasses whose fields are arrays, or such records, with the same rows."""

    def part(self, rows: Any) -> Self:
        """Those that an index chooses."""
        return self._each(lambda x: x[rows], lambda one: one.part(rows))

    def changed(self, rows: Any, new: Self) -> Self:
        """With new ones in the places that an index chooses."""
        return self._each(
            lambda x, y: _changed(x, rows, y), lambda one, other: one.changed(rows, other), new
        )

    def with_more(self, more: Self) -> Self:
        """These, then those."""
        return self._each(
            lambda *both: np.concatenate(both), lambda one, other: one.with_more(other), more
        )

    def _each(
        self, of_arrays: Callable[..., NDArray[Any]], of_records: Callable[..., Rows], *others: Self
    ) -> Self:
        made = {}
        for field in fields(self):  # type: ignore[arg-type]  # every subclass is a dataclass
            values = [getattr(each, field.name) for each in (self, *others)]
            made[field.name] = (of_records if isinstance(values[0], Rows) else of_arrays)(*values)
        return type(self)(**made)


def _changed(x: NDArray[Any], rows: Any, new: NDArray[Any]) -> NDArray[Any]:
    found = x.copy()
    found[rows] = new
    return found
