"""Colours and lines of the lecture's pictures: apart for the colour-blind and in grey.

Each curve has its own dashes or mark beside its colour, and the colours differ in lightness.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True)
class Look:
    """How one curve is drawn, and its name."""

    colour: str
    dashes: Any
    label: str
    width: float = 1.6

    @property
    def line(self) -> dict[str, Any]:
        """Arguments of ``plot``."""
        return {
            "color": self.colour,
            "linestyle": self.dashes,
            "linewidth": self.width,
            "label": self.label,
        }


SOLID, DASHED, DOTTED = "-", (0, (5, 2)), (0, (1, 1.2))
DASH_DOT = (0, (7, 2, 1.5, 2))
DARK, MIDDLE, LIGHT, GREY = "#14335c", "#c04a26", "#e0a030", "0.55"
"""Lightness of about 20, 45, 70 and 58 of 100."""
BOX = {"boxstyle": "round,pad=0.25", "facecolor": "white", "edgecolor": "none", "alpha": 0.85}
"""Behind words that a line could run through."""


def framed(axes: Axes, x: str, y: str) -> None:
    """Labels of the axes, ticks on all sides, a light grid."""
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    axes.grid(True)
    axes.tick_params(top=True, right=True)
