"""What there is to know of one figure."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gainproof.plots import canvas
from gainproof.plots.table import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Entry:
    """One figure. ``shows`` says in a few words what is on it; ``file`` is the name of its files
    without their ending.
    """

    source: str
    name: str
    shows: str
    table: Callable[[], Table]
    draw: Callable[[Table, Figure], None]
    size: tuple[float, float] = (canvas.WIDTH, canvas.HEIGHT)

    @property
    def file(self) -> str:
        kind = f"figure-{self.name}" if self.name.isdigit() else self.name
        return f"{self.source}-{kind}"
