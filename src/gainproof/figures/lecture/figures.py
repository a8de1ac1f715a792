"""The figures of the lecture."""

from __future__ import annotations

from gainproof.figures.entry import Entry
from gainproof.figures.lecture import (
    coordinates,
    curves,
    fits,
    relations,
    turn,
)

FIGURES = (
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
)
