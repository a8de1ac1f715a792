"""The numbers of the figures of example 1: what draws of its noise give, beside theory."""

from __future__ import annotations

import numpy as np

from gainproof.location.drawing import LEVELS, ellipse
from gainproof.location.example import POSITION, STATIONS, VELOCITY
from gainproof.location.monte_carlo import (
    adaptive,
    bias_deviations,
    detected,
    drawn,
    position_covariance,
    simulate,
)
from gainproof.location.selection import detection, threshold
from gainproof.plots.table import Column, Table, Words

SEED, FALSE_ALARM = 1, 0.05
SETS = (
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 30.0, 20.0),
    (0.0, 0.0, 60.0, 40.0),
    (0.0, 0.0, 120.0, 90.0),
    (50.0, 0.0, 0.0, 80.0),
    (-40.0, 60.0, 90.0, 30.0),
)
"""Biases of B1 to B4, m: those of tests/campaigns/location.py."""
RUNS, CURVE_RUNS, POINTS = 5000, 2000, 600
BIASES = (0.0, 0.0, 120.0, 90.0)
"""Of the drawn points."""
MODELS = (("0 clean ranges", (0, 1, 2, 3)), ("2 clean ranges", (2, 3)), ("4 clean ranges", ()))
"""How many ranges are known to be clean, and the stations with a bias."""
RADIUS = LEVELS[-1][0]
"""95 % of two coordinates."""
STATE = ("x", "y", "vx", "vy")
UNITS = ("m", "m", "m_s", "m_s")


def monte_carlo() -> Table:
    """RMS errors with 0, 2 and 4 ranges taken as clean and with those that the test chooses."""
    outcomes = [
        simulate(biases, RUNS, SEED + number, FALSE_ALARM) for number, biases in enumerate(SETS)
    ]
    rows = [(outcome, errors) for outcome in outcomes for errors in outcome.errors]
    columns: list[Column | Words] = [
        Column(f"bias_B{i + 1}_m", "bias of the range", np.array([o.biases[i] for o, _ in rows]))
        for i in range(4)
    ]
    columns.append(Words("ranges", "which are taken as clean", tuple(e.name for _, e in rows)))
    for i, (name, unit) in enumerate(zip(STATE, UNITS, strict=True)):
        rms = np.array([errors.rms[i] for _, errors in rows])
        promised = np.array([errors.promised[i] for _, errors in rows])
        columns.append(Column(f"rms_{name}_{unit}", f"RMS error of {name}", rms))
        columns.append(
            Column(f"promised_{name}_{unit}", "by the covariance, of what is unbiased", promised)
        )
    for i in range(4):
        called = np.array([outcome.called[i] for outcome, _ in rows])
        theory = np.array([outcome.theory[i] for outcome, _ in rows])
        columns.append(Column(f"called_B{i + 1}", "share called biased", called))
        columns.append(Column(f"theory_B{i + 1}", "noncentral chi-square", theory))
    return Table(
        "Example 1: RMS errors",
        tuple(columns),
        {
            f"RMS error of y (m), biases {_told(outcome.biases)} m": {
                errors.name: float(errors.rms[1]) for errors in outcome.errors
            }
            for outcome in outcomes
        },
        (
            (
                f"Ours: {RUNS} draws of noise for each set of biases, seeds {SEED} to "
                f"{SEED + len(SETS) - 1}; false alarms {100 * FALSE_ALARM:g} %."
            ),
            "The source has the deviations of table 1 and no draws.",
            (
                "Ranges known to be clean, 0: bias detection; 2: B1 and B2; 4: no bias anywhere; "
                "adaptive: the biases that the test finds."
            ),
        ),
    )


def detection_rates() -> Table:
    """How often a range is called biased against its bias, counted and by theory."""
    deviations = bias_deviations()
    biases = np.arange(0.0, 121.0, 2.0)
    counted = np.full((4, len(biases)), np.nan)
    for number in range(0, len(biases), 5):
        observed = drawn([float(biases[number])] * 4, CURVE_RUNS, SEED + number)
        counted[:, number] = detected(observed, FALSE_ALARM)[1].mean(axis=0)
    columns = [Column("bias_m", "bias of the range", biases)]
    for i, deviation in enumerate(deviations):
        theory = [detection(bias, deviation, FALSE_ALARM) for bias in biases.tolist()]
        columns.append(Column(f"theory_B{i + 1}", "noncentral chi-square", np.array(theory)))
        columns.append(Column(f"counted_B{i + 1}", "share of the draws", counted[i]))
    off = np.concatenate(
        [(c.values - t.values) for t, c in zip(columns[1::2], columns[2::2], strict=True)]
    )
    return Table(
        "Example 1: detection of multipath",
        tuple(columns),
        {
            "1-sigma of the bias found (m)": {
                f"B{i + 1}": deviation for i, deviation in enumerate(deviations)
            },
            "largest difference from theory": float(np.nanmax(np.abs(off))),
        },
        (
            (
                f"Ours: {CURVE_RUNS} draws of noise at every tenth metre, seeds from {SEED}; all "
                "four ranges have the bias, and bias detection has one for each."
            ),
            (
                "A range is called biased where bias^2/variance exceeds "
                f"{threshold(FALSE_ALARM):.3f}: false alarms {100 * FALSE_ALARM:g} %."
            ),
        ),
    )


def geometry() -> Table:
    """Stations, target, error ellipses of the position, and estimates of single draws."""
    kind: list[str] = [f"B{i + 1}" for i in range(4)] + ["target", "velocity"]
    x = [place[0] for place in STATIONS] + [POSITION[0], VELOCITY[0]]
    y = [place[1] for place in STATIONS] + [POSITION[1], VELOCITY[1]]
    sizes: dict[str, float] = {}
    for name, biased in MODELS:
        covariance = position_covariance(biased)
        curve = ellipse(covariance, RADIUS)
        kind += [name] * len(curve)
        x += curve[:, 0].tolist()
        y += curve[:, 1].tolist()
        sizes[name] = float(np.sqrt(np.trace(covariance)))
    observed = drawn(BIASES, POINTS, SEED)
    states, called = detected(observed, FALSE_ALARM)
    chosen = adaptive(observed, called, states)[0]
    for name, found in (("bias detection", states), ("adaptive", chosen)):
        off = found[:, :2] - POSITION
        kind += [name] * POINTS
        x += off[:, 0].tolist()
        y += off[:, 1].tolist()
    right = (called == (np.array(BIASES) > 0)).all(axis=1)
    return Table(
        "Example 1: geometry and error ellipses",
        (
            Words("what", "a station, the target, a point of an ellipse, an estimate", tuple(kind)),
            Column(
                "x_m", "stations, target: place; velocity: m/s; else less the truth", np.array(x)
            ),
            Column("y_m", "the same of y", np.array(y)),
        ),
        {
            "1-sigma of position, by the covariance (m)": sizes,
            "draws in which exactly B3 and B4 are called biased": float(right.mean()),
        },
        (
            "Ellipses hold 95 %: with 0, 2, 4 ranges known to be clean, at the truth.",
            (
                f"Ours: {POINTS} draws of noise, seed {SEED}, with biases of {_told(BIASES)} m of "
                "B1 to B4."
            ),
        ),
    )


def _told(biases: tuple[float, ...]) -> str:
    return ", ".join(f"{bias:g}" for bias in biases)
