"""The figures of the lecture."""

from __future__ import annotations

from gainproof.figures.entry import Entry
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

FIGURES = (
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
)
