"""One sheet of a figure: Matplotlib asked for, its style, and files that come out the same.

The bytes of a picture depend on the drawing and on the version of Matplotlib, on nothing else: no
date and no random name goes into them.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from gainproof.bad_input import BadInputError

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

WIDTH, HEIGHT = 6.3, 4.4
"""Inches: the text width of a page."""
DOTS_PER_INCH = 200
STYLE: Mapping[Any, Any] = {
    "svg.hashsalt": "gainproof",
    "svg.fonttype": "path",
    "font.family": "DejaVu Sans",
    "mathtext.fontset": "dejavusans",
    "font.size": 9,
    "axes.titlesize": 10,
    "axes.labelsize": 10,
    "axes.linewidth": 0.7,
    "axes.axisbelow": True,
    "grid.linewidth": 0.4,
    "grid.color": "0.85",
    "lines.linewidth": 1.5,
    "legend.fontsize": 8.5,
    "legend.frameon": False,
    "xtick.labelsize": 8.5,
    "ytick.labelsize": 8.5,
    "xtick.direction": "in",
    "ytick.direction": "in",
}
MISSING = "pictures need Matplotlib: pip install 'gainproof[figures]'"


def require_matplotlib() -> None:
    """BadInputError that says how to get Matplotlib where there is none."""
    from importlib import util

    if util.find_spec("matplotlib") is None:
        raise BadInputError(MISSING)


def pictures(draw: Callable[[Figure], None], width: float, height: float) -> dict[str, bytes]:
    """The drawing as bytes, by the file's ending ("svg", "png"). Raises BadInputError."""
    require_matplotlib()
    import matplotlib as mpl
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with mpl.rc_context({"backend": "agg"}):
        mpl.rcdefaults()
        mpl.rcParams.update(STYLE)
        sheet = Figure(figsize=(width, height), layout="constrained")
        FigureCanvasAgg(sheet)
        draw(sheet)
        return {
            "svg": _saved(sheet, format="svg", metadata={"Date": None, "Creator": None}),
            "png": _saved(sheet, format="png", dpi=DOTS_PER_INCH, metadata={"Software": None}),
        }


def _saved(sheet: Figure, **how: Any) -> bytes:
    stream = io.BytesIO()
    sheet.savefig(stream, facecolor="white", **how)
    return stream.getvalue()


def logarithmic(axes: Axes, x: str, y: str) -> None:
    """Both axes logarithmic with a light grid of decades, and their labels."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    from matplotlib.ticker import LogLocator, NullFormatter

    for axis in (axes.xaxis, axes.yaxis):
        # every decade has a line, every other one a label where there are many
        axis.set_minor_locator(LogLocator(base=10, subs=(1.0,), numticks=50))
        axis.set_minor_formatter(NullFormatter())
    axes.grid(True, which="both")
    axes.tick_params(top=True, right=True)
