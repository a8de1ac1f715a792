"""The lecture's figures as they are drawn: words that stay on the sheet and off one another."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations
from typing import Any

import pytest
from one_of_each import cases

from gainproof.figures.catalogue import CATALOGUE
from gainproof.figures.entry import Entry
from gainproof.plots import canvas

Draw = Callable[[Any], None]
LECTURE = [entry for entry in CATALOGUE if entry.source == "lecture"]


def words_of(draw: Draw, size: tuple[float, float]) -> tuple[list[tuple[str, Any]], Any]:
    """Every text but ticks' with its rectangle on the sheet, and the sheet's own."""
    pytest.importorskip("matplotlib")
    import matplotlib as mpl
    from matplotlib.axis import Axis
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    from matplotlib.text import Text

    with mpl.rc_context():
        mpl.rcdefaults()
        mpl.rcParams.update(canvas.STYLE)
        sheet = Figure(figsize=size, dpi=100, layout="constrained")
        FigureCanvasAgg(sheet)
        draw(sheet)
        sheet.draw_without_rendering()
        # beside an axis, where Matplotlib keeps them apart; some beyond its ends are not drawn
        ticks = {
            label
            for axis in sheet.findobj(Axis)
            if isinstance(axis, Axis)
            for label in [*axis.get_ticklabels(), *axis.get_ticklabels(minor=True)]
        }
        return [
            (text.get_text(), text.get_window_extent())
            for text in sheet.findobj(Text)
            if isinstance(text, Text) and text not in ticks and text.get_text().strip()
        ], sheet.bbox


def overlapping(words: list[tuple[str, Any]]) -> list[tuple[str, str]]:
    """Pairs of texts whose rectangles share more than a pixel's edge."""
    return [
        (first, second)
        for (first, one), (second, other) in combinations(words, 2)
        if min(one.x1, other.x1) - max(one.x0, other.x0) > 1
        and min(one.y1, other.y1) - max(one.y0, other.y0) > 1
    ]


@pytest.mark.parametrize(
    "entry", cases(LECTURE, LECTURE[::3].__contains__), ids=[entry.name for entry in LECTURE]
)
def test_words_lie_on_the_sheet_and_not_on_one_another(entry: Entry) -> None:
    table = entry.table()
    words, sheet = words_of(lambda sheet: entry.draw(table, sheet), entry.size)
    assert len(words) >= 5
    assert overlapping(words) == []
    for text, box in words:
        assert box.x0 >= 0, text
        assert box.y0 >= 0, text
        assert box.x1 <= sheet.x1, text
        assert box.y1 <= sheet.y1, text


def test_words_on_words_are_noticed() -> None:
    def draw(sheet: Any) -> None:
        axes = sheet.subplots()
        axes.text(0.5, 0.5, "first words")
        axes.text(0.52, 0.51, "second words")

    words, _ = words_of(draw, (4, 3))
    assert overlapping(words) == [("first words", "second words")]
