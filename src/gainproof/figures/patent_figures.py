"""The figures of the patent on gains that follow the tracking index."""

from __future__ import annotations

from gainproof.figures import (
    patent_drift,
    patent_errors,
    patent_gains,
    patent_limits,
)
from gainproof.figures.entry import Entry

FIGURES = (
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
)
