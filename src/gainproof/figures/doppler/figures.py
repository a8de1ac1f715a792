"""The figures of the paper on location in multipath."""

from __future__ import annotations

from gainproof.figures.doppler import drawing, example
from gainproof.figures.entry import Entry

FIGURES = (
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
