"""What the play shows of each kind of subject, against matrices written anew."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import node
import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import solve_discrete_lyapunov

import gainproof
from gainproof.book.play.subjects import SUBJECTS, subject_of
from gainproof.generated import _runtime

STATIC = Path(gainproof.__file__).resolve().parent / "book" / "static"
FOLDER = Path(_runtime.__file__).parent
PRINTED = sorted({script for subject in SUBJECTS for script in subject.scripts})
# what draws is loaded too: its stable regions are numbers
OWN = [STATIC / f"play.{name}.js" for name in ("filter", "families", "drawing", "panels")]
SCRIPTS = [FOLDER / "_runtime.js", *(FOLDER / script for script in PRINTED), *OWN]
Reals = NDArray[np.float64]


def given_points() -> list[tuple[str, dict[str, float]]]:
    """Every subject at the ends of its sliders, between them, and gains that are not stable."""
    found = []
    for subject in SUBJECTS:
        for share in (0.0, 0.3, 0.5, 0.8, 1.0):
            inputs = {}
            for slider in subject.sliders:
                low, high = slider.least, slider.most
                place = low * (high / low) ** share if slider.logarithmic else slider.begins
                inputs[slider.argument] = place
            found.append((subject.name, inputs))
    two = [(0.3, 0.1), (1.3, 0.9), (1.9, 0.1), (0.9, 2.3), (2.05, 0.1), (1.0, 2.5), (0.2, 3.9)]
    found += [("alpha-beta", {"alpha": a, "beta": b}) for a, b in two]
    three = [(0.3, 0.1, 0.01), (1.4, 0.3, 0.2), (0.5, 0.2, 0.2), (1.2, 1.5, 0.9), (1.0, 2.5, 0.1)]
    found += [("alpha-beta-gamma", {"alpha": a, "beta": b, "gamma": c}) for a, b, c in three]
    return found


POINTS = given_points()


@pytest.fixture(scope="module")
def shown() -> Any:
    program = """
        return given.map(([kind, subject, inputs]) =>
          gainproof.play.families.shown(kind, subject, inputs));"""
    asked = []
    for name, inputs in POINTS:
        subject = subject_of(name)
        assert subject is not None
        asked.append([subject.kind, name, inputs])
    return node.answers(program, SCRIPTS, asked)


def loop_of(found: Any) -> tuple[Reals, Reals, Reals]:
    """F, K and the matrix of the updated error."""
    k = np.array(found["matrix"])
    n, m = k.shape
    f = np.array([[1.0, 1.0, 0.5], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]])[:n, :n]
    return f, k, (np.eye(n) - k @ np.eye(m, n)) @ f


@node.needs_node
@pytest.mark.parametrize("place", range(len(POINTS)))
def test_shown(shown: Any, place: int) -> None:
    found = shown[place]
    f, k, loop = loop_of(found)
    poles = np.array([complex(*pole) for pole in found["poles"]])
    assert len(poles) == len(k)
    # coefficients move by some roundings, poles by much more where they meet
    np.testing.assert_allclose(np.poly(poles), np.poly(loop), rtol=0, atol=3e-13)
    radius = max(abs(np.linalg.eigvals(loop)))
    assert found["radius"] == pytest.approx(radius, abs=1e-5)
    assert found["stable"] == (radius < 1)
    if not found["stable"]:
        assert "variance" not in found
        assert "lag" not in found
        return
    noise = np.diag(np.array(found["deviations"]) ** 2)
    updated = solve_discrete_lyapunov(loop, k @ noise @ k.T, method="direct")
    predicted = f @ updated @ f.T
    # the equation loses what the poles lack of the unit circle
    room = 1e-13 / (1 - radius) ** 2
    assert found["variance"] == pytest.approx(predicted[0, 0], rel=room)
    # behind a track whose last state grows by 1 a sample: e = A e + (I - K H) g
    n, m = k.shape
    g = np.array([1 / math.factorial(n - i) for i in range(n)])
    rest = (np.eye(n) - k @ np.eye(m, n)) @ g
    error = np.linalg.solve(np.eye(n) - loop, rest)
    assert found["lag"] == pytest.approx((f @ error + g)[0], rel=room)


@node.needs_node
def test_a_steady_state_beyond_the_kernels_of_fixed_gains() -> None:
    """It is stable however its gains are rounded; what is shown of it is what kernels give."""
    program = """
        return given.map(([kind, subject, tracking_index]) => {
          const { stable, lag, variance } =
            gainproof.play.families.shown(kind, subject, { tracking_index });
          return [stable, lag === undefined, variance === undefined];
        });"""
    subjects = [["two-states", "random-acceleration"], ["three-states", "random-jerk"]]
    asked = [[*subject, index] for subject in subjects for index in (1e-300, 1e7, 1e300)]
    found = node.answers(program, SCRIPTS, asked)
    assert found == [[True, True, True]] * len(asked)


@node.needs_node
def test_unstable_gains_are_among_the_points(shown: Any) -> None:
    assert [found["stable"] for found in shown].count(False) >= 3


REFUSED = [
    ("two-states", "random-velocity", {"tracking_index": 0}, "gains: tracking_index must be"),
    ("two-states", "random-velocity", {}, "gains: tracking_index must be a number, got undefined"),
    ("two-gains", "alpha-beta", {"alpha": 101, "beta": 1}, "alpha must be a number of magnitude"),
    ("two-gains", "alpha-beta", {"alpha": None, "beta": 1}, "alpha must be a number of magnitude"),
    (
        "three-gains",
        "alpha-beta-gamma",
        {"alpha": 0.1, "beta": 0.1, "gamma": 9},
        "closed_loop_poles: gamma must be a number at least 1e-20 and at most 8, ",
    ),
]


@node.needs_node
def test_refusals() -> None:
    program = """
        return given.map(([kind, subject, inputs]) => {
          const values = Object.entries(inputs).map(([name, x]) => [name, x ?? NaN]);
          try {
            gainproof.play.families.shown(kind, subject, Object.fromEntries(values));
            return "nothing was refused";
          } catch (error) { return error.message; }
        });"""
    told = node.answers(program, SCRIPTS, [list(each[:3]) for each in REFUSED])
    for text, (*_, wanted) in zip(told, REFUSED, strict=True):
        assert text.startswith(wanted)


@node.needs_node
def test_least_variance_is_the_least() -> None:
    """No filter of many comes below the curve, and those of the curve lie on it."""
    program = """
        const { shown, frontier } = gainproof.play.families;
        return given.map(([kind, subject, gains]) => ({
          curve: frontier(kind, [0.13, 1e6], 300), found: gains.map((g) => shown(kind, subject, g)),
        }));"""
    random = np.random.default_rng(5)
    two = random.uniform([0.01, 0.001], [1.0, 2.0], (200, 2)).tolist()
    three = random.uniform([0.05, 0.01, 0.001], [1.0, 1.0, 0.3], (200, 3)).tolist()
    names = ("alpha", "beta", "gamma")
    asked = [
        ["two-gains", "alpha-beta", [dict(zip(names, row, strict=False)) for row in two]],
        ["three-gains", "alpha-beta-gamma", [dict(zip(names, row, strict=True)) for row in three]],
    ]
    for answer in node.answers(program, SCRIPTS, asked):
        lags, least = np.array(answer["curve"]).T
        assert len(lags) > 250
        stable = [found for found in answer["found"] if found["stable"]]
        assert len(stable) > 20
        for found in stable:
            bound = math.exp(np.interp(math.log(found["lag"]), np.log(lags), np.log(least)))
            assert found["variance"] > bound * 0.995  # between points the curve is a chord


@node.needs_node
@pytest.mark.parametrize("gamma", [None, 0.05, 0.8])
def test_the_shaded_gains_are_the_stable_ones(gamma: float | None) -> None:
    program = "return gainproof.play.panels.stableGains(given ? { gamma: given } : {});"
    corners = np.array(node.answers(program, SCRIPTS, gamma))
    random = np.random.default_rng(6)
    for alpha, beta in random.uniform([0.02, 0.0], [2.1, 4.2], (400, 2)):
        gains = [alpha, beta] if gamma is None else [alpha, beta, gamma]
        _, _, loop = loop_of({"matrix": [[gain] for gain in gains]})
        radius = max(abs(np.linalg.eigvals(loop)))
        if abs(radius - 1) > 0.02:  # the curve is a chain of chords
            assert inside(corners, alpha, beta) == (radius < 1), (alpha, beta)


def inside(corners: Reals, x: float, y: float) -> bool:
    """Whether a point lies in a polygon: how often a ray from it crosses the border."""
    crossings = 0
    for (a, b), (c, d) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        if (b > y) != (d > y) and x < a + (y - b) / (d - b) * (c - a):
            crossings += 1
    return crossings % 2 == 1
