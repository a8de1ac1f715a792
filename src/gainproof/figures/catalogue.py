"""Every figure: its source, its name, its numbers, its drawing, and the size of its sheet."""

from __future__ import annotations

from gainproof.bad_input import unknown_name
from gainproof.figures import (
    patent_drift,
    patent_errors,
    patent_gains,
    patent_limits,
    suzuki_curves,
    suzuki_digits,
)
from gainproof.figures.doppler import drawing as doppler_drawing
from gainproof.figures.doppler import example as doppler_example
from gainproof.figures.entry import Entry
from gainproof.figures.lecture import coordinates, curves, fits, relations, turn

CATALOGUE: tuple[Entry, ...] = (
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
    Entry(
        "lecture",
        "mean-and-line",
        "a standing target by the mean, a moving one by the line",
        fits.mean_and_line,
        fits.draw_mean_and_line,
        fits.FITS_SIZE,
    ),
    Entry(
        "lecture",
        "gains",
        "gains of the least-squares line against the sample number",
        fits.gains,
        fits.draw_gains,
        fits.GAINS_SIZE,
    ),
    Entry(
        "lecture",
        "alpha-beta-turn",
        "a turning target by the alpha-beta filter, small and large gains",
        turn.alpha_beta_turn,
        turn.draw_alpha_beta_turn,
        turn.SIZE,
    ),
    Entry(
        "lecture",
        "coordinates",
        "polar and Cartesian coordinates of a radar, and a filter's way through both",
        coordinates.coordinates,
        coordinates.draw_coordinates,
        coordinates.SIZE,
    ),
    Entry(
        "lecture",
        "minimum-variance",
        "MV against RA and RV: variance at equal lag",
        curves.minimum_variance,
        curves.draw_minimum_variance,
        curves.VARIANCE_SIZE,
    ),
    Entry(
        "lecture",
        "stability",
        "stability region of alpha and beta with the named filters",
        curves.stability,
        curves.draw_stability,
        curves.STABILITY_SIZE,
    ),
    Entry(
        "lecture",
        "relations",
        "how the filters with the uniform motion model hang together",
        relations.relations,
        relations.draw_relations,
        relations.SIZE,
    ),
    Entry(
        "lecture",
        "kalman-turn",
        "a turning target by the Kalman filter, small and large driving noise",
        turn.kalman_turn,
        turn.draw_kalman_turn,
        turn.SIZE,
    ),
    Entry(
        "patent",
        "5",
        "tracking index against the range",
        patent_gains.figure_5,
        patent_gains.draw_figure_5,
        patent_gains.SIZE,
    ),
    Entry(
        "patent",
        "6",
        "alpha against the range: exact, fixed, updated",
        patent_gains.figure_6,
        patent_gains.draw_figure_6,
        patent_gains.GAINS_SIZE,
    ),
    Entry(
        "patent",
        "7",
        "beta against the range: exact, fixed, updated",
        patent_gains.figure_7,
        patent_gains.draw_figure_7,
        patent_gains.GAINS_SIZE,
    ),
    Entry(
        "patent",
        "8",
        "RMS position error of all filters on four paths",
        patent_errors.figure_8,
        patent_errors.draw_figure_8,
        patent_errors.SIZE,
    ),
    Entry(
        "patent",
        "9",
        "RMS velocity error of all filters on four paths",
        patent_errors.figure_9,
        patent_errors.draw_figure_9,
        patent_errors.SIZE,
    ),
    Entry(
        "patent",
        "comparison",
        "RMS errors of all filters over those of the Kalman filter",
        patent_errors.comparison,
        patent_errors.draw_comparison,
        patent_errors.COMPARISON_SIZE,
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
        doppler_example.monte_carlo,
        doppler_drawing.draw_monte_carlo,
        doppler_drawing.ERRORS_SIZE,
    ),
    Entry(
        "doppler",
        "detection",
        "example 1: how often a biased range is found, counted and by theory",
        doppler_example.detection_rates,
        doppler_drawing.draw_detection,
        doppler_drawing.RATES_SIZE,
    ),
    Entry(
        "doppler",
        "geometry",
        "example 1: stations, target, error ellipses and single estimates",
        doppler_example.geometry,
        doppler_drawing.draw_geometry,
        doppler_drawing.GEOMETRY_SIZE,
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
