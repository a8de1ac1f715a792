"""The plot of variance against lag, and its files: the picture asked for, and its numbers."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from gainproof.bad_input import BadInputError
from gainproof.design.curves import curves
from gainproof.design.sheet import Sheet
from gainproof.figures.writing import write
from gainproof.files import places
from gainproof.plots import canvas
from gainproof.plots.table import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_ENDINGS = (".svg", ".png", ".csv")


def write_plot(sheet: Sheet, name: str) -> list[str]:
    """Write FILE (.svg or .png) and its CSV beside it, or the CSV alone; the names written.

    Raises BadInputError for another ending, where there is nothing to draw, where Matplotlib is
    missing, or where a file cannot be written.
    """
    if "\0" in name:
        raise BadInputError(f"--plot takes the name of a file, got {name!r}")
    path = Path(name)
    ending = path.suffix.lower()
    if ending not in _ENDINGS:
        raise BadInputError(f"--plot takes a name that ends in .svg, .png or .csv, got {name!r}")
    try:
        table = curves(sheet)
    except ValueError as error:
        raise BadInputError(f"--plot: {error}") from None
    content: dict[str, bytes] = {}
    if ending != ".csv":
        size = canvas.WIDTH, canvas.HEIGHT
        drawn = canvas.pictures(lambda paper: draw(table, paper, sheet.states), *size)
        content[path.name] = drawn[ending[1:]]
    content[path.with_suffix(".csv").name] = table.csv().encode()
    return [places.shown(written) for written in write(content, path.parent)]


STYLES = ("-", "--", "-.", ":")
MARKERS = (("o", 10.0), ("s", 6.5), ("D", 5.5), ("^", 5.5), ("v", 5.5), ("P", 5.5))
"""Of falling size, so that curves that nearly agree show both."""
COLOURS = ("0.55", "tab:blue", "tab:red", "tab:green", "tab:purple", "tab:brown")
LABELS = {
    2: r"lag $e_\mathrm{fin}/(a_c T^2) = 1/\beta$",
    3: r"lag $e_\mathrm{fin}/(j\,T^3) = 1/\gamma$",
}
MARK = "chosen_"


def draw(table: Table, sheet: Figure, states: int) -> None:
    """Curves of all filters, a dot where the choice is on each."""
    axes = sheet.add_subplot()
    canvas.logarithmic(axes, LABELS[states], r"variance of the predicted position $\sigma_p^2/B$")
    lags = table["lag"]
    names = [each.name for each in table.columns[1:] if not each.name.startswith(MARK)]
    own = [c.name.removeprefix(MARK) for c in table.columns if c.name.startswith(MARK)]
    colours = dict(zip(names, COLOURS, strict=False))
    for place, name in enumerate(names):
        style = STYLES[place % len(STYLES)]
        axes.plot(lags, table[name], style, color=colours.get(name), label=name)
    shapes = dict(zip(names, MARKERS, strict=False))
    for order, name in enumerate(own):
        mark = table[MARK + name]
        at = np.isfinite(mark)
        shape, size = shapes.get(name, ("x", 8.0))
        given = name not in names
        axes.plot(
            lags[at],
            mark[at],
            shape,
            color="black" if given else colours.get(name),
            markersize=size,
            markeredgecolor="black",
            markeredgewidth=1.6 if given else 0.6,
            label="gains given" if given else f"{name}, chosen",
            zorder=10 if given else 4 + order,
        )
    shown = np.concatenate([table[name] for name in names])
    shown = shown[np.isfinite(shown)]
    marked = np.concatenate([table[MARK + name] for name in own])
    highest = float(np.nanmax(marked))
    # gains of one's own may lie above every curve
    least = min(float(shown.min(initial=np.inf)), float(np.nanmin(marked)))
    most = max(float(shown.max(initial=0.0)), highest)
    axes.set_ylim(least * 0.8, min(most * 1.25, max(highest * 30, least * 100)))
    axes.set_xlim(float(lags[0]), float(lags[-1]))
    axes.legend()
