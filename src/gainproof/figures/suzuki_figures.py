"""The figures of the paper on position and velocity measured."""

from __future__ import annotations

from gainproof.figures import suzuki_curves, suzuki_digits
from gainproof.figures.entry import Entry

FIGURES = (
    Entry(
        "suzuki",
        "1",
        "predicted position error against the error of the measured velocity",
        suzuki_curves.figure_1,
        suzuki_curves.draw_figure_1,
    ),
    Entry(
        "suzuki",
        "2",
        "where a measured velocity begins to matter",
        suzuki_curves.figure_2,
        suzuki_curves.draw_figure_2,
    ),
    Entry(
        "suzuki",
        "3",
        "the most that a measured velocity improves",
        suzuki_curves.figure_3,
        suzuki_curves.draw_figure_3,
    ),
    Entry(
        "suzuki",
        "digits",
        "where the printed closed form loses its digits",
        suzuki_digits.figure_digits,
        suzuki_digits.draw_digits,
        (7.2, 4.8),
    ),
)
