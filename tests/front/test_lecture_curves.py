"""The lecture's other figures against oracles: fits, gains, named filters, the diagrams."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from itertools import pairwise
from math import sqrt

import numpy as np
import pytest

from gainproof.figures.lecture import coordinates, curves, fits, kalman_track, relations
from gainproof.figures.lecture.curves import CURVES as LABELS
from gainproof.figures.lecture.relations import GENERAL, SPECIAL, WORDS
from gainproof.files import places
from gainproof.plots.table import Reals, Table
from gainproof.verify.oracles import fixed_gain, least_squares

RELATIONS: Mapping[str, Callable[[float, float], float]] = {
    "alpha (alpha + beta) = 2 beta": lambda a, b: a * (a + b) - 2 * b,
    "(alpha + beta/2)^2 = 2 beta": lambda a, b: (a + b / 2) ** 2 - 2 * b,
    "(alpha + beta/2)^2 = beta": lambda a, b: (a + b / 2) ** 2 - b,
    "2 sqrt(beta) (1 - alpha) = 2 alpha - beta": lambda a, b: 2 * sqrt(b) * (1 - a) - 2 * a + b,
}
"""What the diagram prints, left less right."""
CURVES = {"mv": "MV", "nps": "NP-S of one coordinate", "ra": "RA", "rv": "RV"}


def printed(special: str) -> str:
    """The relation on the diagram for one of the filters."""
    (found,) = {line.relation for line in relations.LINES if line.special == special} - {""}
    return found


def variance(which: str, alpha: float, beta: float) -> float:
    """Of the predicted or the updated position, by the oracle."""
    gains = [fixed_gain.ball(alpha), fixed_gain.ball(beta)]
    covariance = fixed_gain.predicted if which == "predicted" else fixed_gain.updated
    return float(covariance(gains)[0, 0].mid())


def test_mean_and_line_are_those_of_all_samples_so_far() -> None:
    table = fits.mean_and_line()
    standing, moving = table["standing_observed_m"], table["moving_observed_m"]
    for k in range(1, len(standing)):
        assert table["mean_m"][k] == pytest.approx(standing[: k + 1].mean(), rel=1e-13)
        fitted = np.polyfit(np.arange(-k, 1.0), moving[: k + 1], 1)
        assert table["line_m"][k] == pytest.approx(fitted[1], rel=1e-13)
        weights = least_squares.weights(1, k)[0]
        spread = fits.DEVIATION * sqrt(sum(float(w) ** 2 for w in weights))
        assert table["line_deviation_m"][k] == pytest.approx(spread, rel=1e-12)
        assert table["mean_deviation_m"][k] == pytest.approx(fits.DEVIATION / sqrt(k + 1))
    # the last line, at both ends
    slope, last = np.polyfit(table["time_s"] - table["time_s"][-1], moving, 1)
    assert table["last_line_m"][0] == pytest.approx(last - slope * table["time_s"][-1], rel=1e-12)
    assert table.numbers["range rate of the line through all (m/s)"] == pytest.approx(slope)


def test_gains_are_the_weights_of_the_newest_sample() -> None:
    table = fits.gains()
    for k, alpha, beta, mean in zip(
        *(table[name].tolist() for name in ("k", "alpha", "beta", "mean_alpha")), strict=True
    ):
        line = least_squares.weights(1, int(k))
        assert alpha == pytest.approx(float(line[0][-1]), rel=1e-14)
        assert beta == pytest.approx(float(line[1][-1]), rel=1e-14)
        assert mean == pytest.approx(float(least_squares.weights(0, int(k))[0][-1]), rel=1e-14)


def test_variances_at_equal_lag_are_those_of_the_lyapunov_equation() -> None:
    table, gains = curves.minimum_variance(), curves.stability()
    assert (table["ra_over_mv"][np.isfinite(table["ra_over_mv"])] > 1).all()
    there = np.isfinite(table["rv_over_mv"])
    assert (table["rv_over_mv"][there] > table["ra_over_mv"][there]).all()
    assert np.isnan(table["ra_variance"][table["lag"] <= 0.5]).all()
    for name in curves.COMPARED:
        for row in (60, 140, 239):
            lag = float(table["lag"][row])
            near = int(np.argmin(np.abs(gains["lag"] - lag)))
            alpha, beta, own = (float(v[0]) for v in curves._by_lag(name, np.array([lag])))
            assert (
                own
                == table[f"{name}_variance"][row]
                == pytest.approx(variance("predicted", alpha, beta), rel=1e-11)
            )
            assert beta == pytest.approx(1 / lag)
            assert gains[f"{name}_alpha"][near] == pytest.approx(alpha, rel=0.1)


def test_the_named_filters_lie_on_their_printed_curves_inside_the_region() -> None:
    table = curves.stability()
    for name, special in CURVES.items():
        alpha, beta = table[f"{name}_alpha"], table[f"{name}_beta"]
        there = np.isfinite(alpha)
        off = RELATIONS[printed(special)]
        for a, b in zip(alpha[there].tolist(), beta[there].tolist(), strict=True):
            assert abs(off(a, b)) < 1e-13
        inside = 4 - 2 * alpha[there] - beta[there]
        assert inside.min() > 0
        # each curve reaches the border, and the corner at the origin
        assert inside.min() < 1e-3
        assert beta[there].min() < 2e-4
    pairs = table.numbers["4 - 2 alpha - beta of the lecture's gain pairs"]
    assert pairs == {"small": pytest.approx(3.8), "large": pytest.approx(2.5858)}


def steady_gains(noise: Reals) -> tuple[float, float]:
    """alpha and beta by running the textbook's recursion, T = B = 1."""
    moving, covariance = np.array([[1.0, 1.0], [0.0, 1.0]]), 100 * np.eye(2)
    gain = np.zeros(2)
    for _ in range(400):
        ahead = moving @ covariance @ moving.T + noise
        gain = ahead[:, 0] / (ahead[0, 0] + 1)
        covariance = ahead - np.outer(gain, ahead[0])
    return float(gain[0]), float(gain[1])


@pytest.mark.parametrize("index", [0.2, 1.5])
def test_arrows_from_kalman_to_rv_and_ra(index: float) -> None:
    increments = index**2 * np.array([[0.0, 0.0], [0.0, 1.0]])
    constant = index**2 * np.array([[0.25, 0.5], [0.5, 1.0]])
    for noise, special in ((increments, "RV"), (constant, "RA")):
        assert abs(RELATIONS[printed(special)](*steady_gains(noise))) < 1e-12
        others = set(RELATIONS) - {printed(special)}
        assert all(abs(RELATIONS[other](*steady_gains(noise))) > 1e-4 for other in others)


def test_arrow_from_kalman_to_least_squares() -> None:
    """Without driving noise the filter is the line through all, in each coordinate."""
    measured = np.random.default_rng(8).normal(0, 9, (1, 12, 2))
    noise = np.broadcast_to(81.0 * np.eye(2), (1, 12, 2, 2))
    found = kalman_track.followed(measured, noise, 10.0, 0.0)[0]
    for k in range(1, 12):
        line = np.polyfit(np.arange(-k, 1.0), measured[0, : k + 1], 1)[1]
        assert np.allclose(found[k], line, atol=1e-9)
    assert printed("least squares") == (
        "alpha = 2 (2 k + 1)/((k + 1) (k + 2)), beta = 6/((k + 1) (k + 2))"
    )
    for k in (1, 2, 7):
        newest = [row[-1] for row in least_squares.weights(1, k)]
        below = (k + 1) * (k + 2)
        assert newest == [Fraction(2 * (2 * k + 1), below), Fraction(6, below)]


@pytest.mark.parametrize("beta", [0.05, 0.5, 1.7])
@pytest.mark.parametrize(
    ("which", "special"), [("predicted", "MV"), ("updated", "NP-S of one coordinate")]
)
def test_arrows_from_np_filters(beta: float, which: str, special: str) -> None:
    """At the held gain no other alpha in the region has a smaller steady variance."""
    off = RELATIONS[printed(special)]
    low, high = (0.0, sqrt(beta)) if special == "MV" else (beta / 2, 1.0)
    for _ in range(80):
        middle = (low + high) / 2
        # both relations change their sign once there
        low, high = (middle, high) if off(low, beta) * off(middle, beta) > 0 else (low, middle)
    least = variance(which, low, beta)
    largest = 2 - beta / 2
    others = [largest * share for share in np.linspace(0.02, 0.98, 25).tolist()]
    others += [low * 0.99, low * 1.01]
    assert all(variance(which, other, beta) > least for other in others)


def test_every_derived_line_is_an_arrow_and_every_arrow_a_line() -> None:
    lines = [line for line in relations.LINES if line.general in GENERAL]
    assert {line.special for line in lines} == set(SPECIAL) == set(WORDS)
    # each derivation has its certificate
    subjects = {path.stem.replace("_", "-") for path in places.certificates()}
    assert {line.derivation for line in lines} < subjects
    assert {line.derivation for line in relations.LINES} - subjects == {"definition"}
    generals = {line.general for line in relations.LINES}
    assert generals == {*GENERAL, "linear filter", "alpha-beta filter"}
    contained = {line.special for line in relations.LINES if line.general == "alpha-beta filter"}
    assert contained == set(SPECIAL)


def test_what_is_drawn_is_what_the_table_says() -> None:
    """The formulas on the sheets are the lines' own, and the order that of the variances."""
    for name, special in CURVES.items():
        (box, curve), line = (SPECIAL[special].text, LABELS[name]), printed(special)
        assert plain(box) == plain(curve.partition(": ")[2]) == line.replace(" ", "")
    table = curves.minimum_variance()
    ordered = [table[f"{name.lower()}_variance"] for name in relations.ORDER]
    there = np.isfinite(ordered[-1])
    for less, more in pairwise(ordered):
        assert (less[there] < more[there]).all()


def plain(formula: str) -> str:
    """A formula of the sheet in the letters of the table."""
    for drawn, word in (("\\,", ""), ("{", "("), ("}", ")"), ("\\", ""), ("$", ""), (" ", "")):
        formula = formula.replace(drawn, word)
    return formula


def test_the_example_has_its_range_elevation_and_bearing() -> None:
    table: Table = coordinates.coordinates()
    row = table.words("point").index("target")
    x, y, z = (float(table[name][row]) for name in ("x_m", "y_m", "z_m"))
    assert np.hypot(np.hypot(x, y), z) == pytest.approx(coordinates.RANGE)
    assert np.rad2deg(np.arcsin(z / coordinates.RANGE)) == pytest.approx(36)
    assert np.rad2deg(np.arctan2(x, y)) == pytest.approx(50)
