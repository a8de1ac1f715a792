"""The weights of one step in the outputs that use it, over all boxes.

Where many outputs are bounded together most steps are used by few of them: only these have rows.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from gainproof.derive.printer import interval
from gainproof.derive.printer.interval import Array, Interval
from gainproof.derive.printer.step_ranges import Mask

Rows = tuple[int, ...]
"""Outputs by number, in order."""


@dataclass(frozen=True)
class Weight:
    """Of one step in some outputs (`rows`) and all boxes (columns).

    `share` encloses node * d output/d node over the scale, `active` where the output uses the step
    (None: everywhere), `absolute` bounds |d output/d node| over the scale (None where no step of
    the program is tiny).
    """

    rows: Rows
    share: Interval
    active: Mask | None
    absolute: Array | None

    @property
    def place(self) -> slice | list[int]:
        """Where its rows are among those of all outputs."""
        first, last = self.rows[0], self.rows[-1]
        return slice(first, last + 1) if last - first < len(self.rows) else list(self.rows)

    def used(self, numbers: Array) -> Array:
        """The numbers where an output uses the step, 0 elsewhere."""
        return numbers if self.active is None else np.where(self.active, numbers, 0.0)

    def exposed(self, mask: Mask | None = None) -> Mask:
        """Where an output uses the step, in the boxes of a mask if there is one."""
        found = np.ones(self.share[0].shape, np.bool_) if self.active is None else self.active
        return found if mask is None else found & mask

    def is_active(self, row: int, box: int) -> bool:
        """Whether an output uses the step in a box."""
        if row not in self.rows:
            return False
        return self.active is None or bool(self.active[self.rows.index(row), box])

    def magnitude(self, count: int) -> Array:
        """The largest |share| in each of `count` outputs, box by box."""
        found = np.zeros((count, self.share[0].shape[1]))
        found[self.place] = self.used(interval.magnitude(self.share))
        return found

    def __add__(self, other: Weight) -> Weight:
        """What both contribute."""
        rows = self.rows
        if rows != other.rows:
            rows = tuple(sorted({*rows, *other.rows}))
        first, second = self._among(rows), other._among(rows)
        absolute, active = None, None
        if first.absolute is not None and second.absolute is not None:
            absolute = interval.up(first.absolute + second.absolute)
        if self.active is not None or other.active is not None:
            active = first.exposed() | second.exposed()
        return Weight(rows, interval.signed_add(first.share, second.share), active, absolute)

    def _among(self, rows: Rows) -> Weight:
        """The same with more rows, in which it has no weight."""
        if rows == self.rows:
            return self
        places = [rows.index(row) for row in self.rows]

        def wider(numbers: Array) -> Array:
            found = np.zeros((len(rows), numbers.shape[1]), numbers.dtype)
            found[places] = numbers
            return found

        low, high = map(wider, self.share)
        absolute = None if self.absolute is None else wider(self.absolute)
        active = np.zeros(low.shape, np.bool_)
        active[places] = True if self.active is None else self.active
        return replace(self, rows=rows, share=(low, high), active=active, absolute=absolute)
