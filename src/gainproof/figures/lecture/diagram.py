"""Boxes, frames and arrows of a diagram, in the coordinates of its axes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Box:
    """A rectangle by its centre and size, with a heading and lines below it."""

    x: float
    y: float
    width: float
    height: float
    heading: str
    text: str = ""
    face: str = "white"
    spacing: float = 1.35
    """Between the lines of the text."""

    @property
    def top(self) -> tuple[float, float]:
        return self.x, self.y + self.height / 2

    @property
    def bottom(self) -> tuple[float, float]:
        return self.x, self.y - self.height / 2


def empty_axes(sheet: Figure, width: float, height: float) -> Axes:
    """Axes without frame or ticks, from 0 to width and height."""
    axes: Axes = sheet.subplots()
    axes.set_axis_off()
    axes.set_xlim(0, width)
    axes.set_ylim(0, height)
    return axes


def put(axes: Axes, box: Box, *, frame: bool = False) -> None:
    """Draw a box, its words in the middle; of a frame they stand at the lower left."""
    from matplotlib.patches import FancyBboxPatch

    left, low = box.x - box.width / 2, box.y - box.height / 2
    axes.add_patch(
        FancyBboxPatch(
            (left, low),
            box.width,
            box.height,
            boxstyle="round,pad=0,rounding_size=1.2",
            facecolor=box.face,
            edgecolor="0.2",
            linewidth=0.8,
            linestyle=(0, (5, 2)) if frame else "-",
        )
    )
    if frame:
        axes.text(left + 1.5, low + 4.6, box.heading, va="baseline", weight="bold")
        axes.text(left + 1.5, low + 1.6, box.text, va="baseline", fontsize=8)
        return
    if not box.text:
        axes.text(box.x, box.y, box.heading, ha="center", va="center", weight="bold")
        return
    high = low + box.height
    axes.text(box.x, high - 1.2, box.heading, ha="center", va="top", weight="bold")
    middle = (low + high - 4.2) / 2
    axes.text(
        box.x, middle, box.text, ha="center", va="center", fontsize=8, linespacing=box.spacing
    )


def arrow(
    axes: Axes,
    start: tuple[float, float],
    end: tuple[float, float],
    words: str = "",
    *,
    place: float = 0.5,
    curve: float = 0.0,
) -> None:
    """An arrow with words on it, that far along."""
    how: dict[str, Any] = {
        "arrowstyle": "-|>",
        "color": "0.1",
        "linewidth": 1.0,
        "shrinkA": 0,
        "shrinkB": 0,
        "connectionstyle": f"arc3,rad={curve}",
    }
    axes.annotate("", end, start, arrowprops=how)
    if words:
        x, y = (a + place * (b - a) for a, b in zip(start, end, strict=True))
        axes.text(
            x,
            y,
            words,
            ha="center",
            va="center",
            fontsize=7.5,
            linespacing=1.2,
            bbox={"boxstyle": "square,pad=0.15", "facecolor": "white", "edgecolor": "none"},
        )
