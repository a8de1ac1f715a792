"""Every figure: its source, its name, its numbers, its drawing, and the size of its sheet."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gainproof.bad_input import unknown_name
from gainproof.figures import (
    canvas,
    digits_drawing,
    patent_drift,
    patent_errors,
    patent_errors_drawing,
    patent_gains,
    patent_gains_drawing,
    patent_limits,
    suzuki_curves,
    suzuki_digits,
    suzuki_drawing,
)
from gainproof.figures.doppler import drawing, example
from gainproof.figures.lecture import (
    coordinates,
    coordinates_drawing,
    curves,
    curves_drawing,
    fits,
    fits_drawing,
    relations,
    relations_drawing,
    turn,
    turn_drawing,
)
from gainproof.figures.table import Table

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


CATALOGUE = (
    Entry(
        "suzuki",
        "1",
        "predicted position error against the error of the measured velocity",
        suzuki_curves.figure_1,
        suzuki_drawing.draw_figure_1,
    ),
    Entry(
        "suzuki",
        "2",
        "where a measured velocity begins to matter",
        suzuki_curves.figure_2,
        suzuki_drawing.draw_figure_2,
    ),
    Entry(
        "suzuki",
        "3",
        "the most that a measured velocity improves",
        suzuki_curves.figure_3,
        suzuki_drawing.draw_figure_3,
    ),
    Entry(
        "suzuki",
        "digits",
        "where the printed closed form loses its digits",
        suzuki_digits.figure_digits,
        digits_drawing.draw_digits,
        (7.2, 4.8),
    ),
    Entry(
        "lecture",
        "mean-and-line",
        "a standing target by the mean, a moving one by the line",
        fits.mean_and_line,
        fits_drawing.draw_mean_and_line,
        fits_drawing.FITS_SIZE,
    ),
    Entry(
        "lecture",
        "gains",
        "gains of the least-squares line against the sample number",
        fits.gains,
        fits_drawing.draw_gains,
        fits_drawing.GAINS_SIZE,
    ),
    Entry(
        "lecture",
        "alpha-beta-turn",
        "a turning target by the alpha-beta filter, small and large gains",
        turn.alpha_beta_turn,
        turn_drawing.draw_alpha_beta_turn,
        turn_drawing.SIZE,
    ),
    Entry(
        "lecture",
        "coordinates",
        "polar and Cartesian coordinates of a radar, and a filter's way through both",
        coordinates.coordinates,
        coordinates_drawing.draw_coordinates,
        coordinates_drawing.SIZE,
    ),
    Entry(
        "lecture",
        "minimum-variance",
        "MV against RA and RV: variance at equal lag",
        curves.minimum_variance,
        curves_drawing.draw_minimum_variance,
        curves_drawing.VARIANCE_SIZE,
    ),
    Entry(
        "lecture",
        "stability",
        "stability region of alpha and beta with the named filters",
        curves.stability,
        curves_drawing.draw_stability,
        curves_drawing.STABILITY_SIZE,
    ),
    Entry(
        "lecture",
        "relations",
        "how the filters with the uniform motion model hang together",
        relations.relations,
        relations_drawing.draw_relations,
        relations_drawing.SIZE,
    ),
    Entry(
        "lecture",
        "kalman-turn",
        "a turning target by the Kalman filter, small and large driving noise",
        turn.kalman_turn,
        turn_drawing.draw_kalman_turn,
        turn_drawing.SIZE,
    ),
    Entry(
        "patent",
        "5",
        "tracking index against the range",
        patent_gains.figure_5,
        patent_gains_drawing.draw_figure_5,
        patent_gains_drawing.SIZE,
    ),
    Entry(
        "patent",
        "6",
        "alpha against the range: exact, fixed, updated",
        patent_gains.figure_6,
        patent_gains_drawing.draw_figure_6,
        patent_gains_drawing.GAINS_SIZE,
    ),
    Entry(
        "patent",
        "7",
        "beta against the range: exact, fixed, updated",
        patent_gains.figure_7,
        patent_gains_drawing.draw_figure_7,
        patent_gains_drawing.GAINS_SIZE,
    ),
    Entry(
        "patent",
        "8",
        "RMS position error of all filters on four paths",
        patent_errors.figure_8,
        patent_errors_drawing.draw_figure_8,
        patent_errors_drawing.SIZE,
    ),
    Entry(
        "patent",
        "9",
        "RMS velocity error of all filters on four paths",
        patent_errors.figure_9,
        patent_errors_drawing.draw_figure_9,
        patent_errors_drawing.SIZE,
    ),
    Entry(
        "patent",
        "comparison",
        "RMS errors of all filters over those of the Kalman filter",
        patent_errors.comparison,
        patent_errors_drawing.draw_comparison,
        patent_errors_drawing.COMPARISON_SIZE,
    ),
    Entry(
        "patent",
        "limits",
        "how far from its nominal index the first-order update is of use",
        patent_limits.limits,
        patent_limits.draw_limits,
        patent_limits.SIZE,
    ),
    Entry(
        "patent",
        "drift",
        "how the recursive update drifts away while a target stands still",
        patent_drift.drift,
        patent_drift.draw_drift,
        patent_drift.SIZE,
    ),
    Entry(
        "doppler",
        "monte-carlo",
        "example 1: RMS errors with 0, 2, 4 clean ranges and those that the test finds",
        example.monte_carlo,
        drawing.draw_monte_carlo,
        drawing.ERRORS_SIZE,
    ),
    Entry(
        "doppler",
        "detection",
        "example 1: how often a biased range is found, counted and by theory",
        example.detection_rates,
        drawing.draw_detection,
        drawing.RATES_SIZE,
    ),
    Entry(
        "doppler",
        "geometry",
        "example 1: stations, target, error ellipses and single estimates",
        example.geometry,
        drawing.draw_geometry,
        drawing.GEOMETRY_SIZE,
    ),
)


def of_source(source: str) -> tuple[Entry, ...]:
    """The figures of a source. Raises BadInputError for one that has none."""
    own = tuple(entry for entry in CATALOGUE if entry.source == source)
    if not own:
        sources = {entry.source for entry in CATALOGUE}
        raise unknown_name("source with figures", source, sources)
    return own


def find(source: str, name: str) -> Entry:
    """The figure of this name. Raises BadInputError for one there is not."""
    own = {entry.name: entry for entry in of_source(source)}
    if name not in own:
        raise unknown_name(f"figure of {source}", name, own)
    return own[name]
