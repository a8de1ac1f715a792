"""Every figure: its source, its name, its numbers, its drawing, and the size of its sheet."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gainproof.bad_input import unknown_name
from gainproof.figures import canvas, digits_drawing, suzuki_curves, suzuki_digits, suzuki_drawing
from gainproof.figures.table import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Entry:
    """One figure. ``file`` is the name of its files without their ending."""

    source: str
    name: str
    table: Callable[[], Table]
    draw: Callable[[Table, Figure], None]
    size: tuple[float, float] = (canvas.WIDTH, canvas.HEIGHT)

    @property
    def file(self) -> str:
        kind = f"figure-{self.name}" if self.name.isdigit() else self.name
        return f"{self.source}-{kind}"


CATALOGUE = (
    Entry("suzuki", "1", suzuki_curves.figure_1, suzuki_drawing.draw_figure_1),
    Entry("suzuki", "2", suzuki_curves.figure_2, suzuki_drawing.draw_figure_2),
    Entry("suzuki", "3", suzuki_curves.figure_3, suzuki_drawing.draw_figure_3),
    Entry("suzuki", "digits", suzuki_digits.figure_digits, digits_drawing.draw_digits, (7.2, 4.8)),
)


def find(source: str, name: str) -> Entry:
    """The figure of this name. Raises BadInputError for one there is not."""
    sources = {entry.source for entry in CATALOGUE}
    if source not in sources:
        raise unknown_name("source with figures", source, sources)
    own = {entry.name: entry for entry in CATALOGUE if entry.source == source}
    if name not in own:
        raise unknown_name(f"figure of {source}", name, own)
    return own[name]
