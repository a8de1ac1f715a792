"""`gainproof design` from noises: SciPy's Riccati solution in metres and seconds beside it."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import solve_discrete_are

from gainproof import cli
from gainproof.design.process_noise import NOISES, steady_filters

T, SIGMA = 2.0, 50.0


def process_noise(name: str, t: float, s: float) -> NDArray[np.float64]:
    """Q in words of the textbooks: s is a deviation, of the densities q = s."""
    g = {
        "random-acceleration": [t * t / 2, t],
        "acceleration-increments": [0.0, 0.0, 1.0],
        "wiener-acceleration": [t * t / 2, t, 1.0],
        "random-jerk": [t**3 / 6, t * t / 2, t],
    }
    if name == "random-velocity":  # the deviation is that of the velocity's step
        return np.diag([0.0, s * s])
    if name in g:
        return np.outer(g[name], g[name]) * (s * s)
    two = s * np.array([[t**3 / 3, t**2 / 2], [t**2 / 2, t]])
    three = s * np.array(
        [
            [t**5 / 20, t**4 / 8, t**3 / 6],
            [t**4 / 8, t**3 / 3, t**2 / 2],
            [t**3 / 6, t**2 / 2, t],
        ]
    )
    return two if name == "continuous-white-acceleration" else three


EVERY = [(noise, states) for noise, kind in NOISES.items() for states in kind.models]


@pytest.mark.alike
@pytest.mark.parametrize(("noise", "states"), EVERY)
@pytest.mark.parametrize(("t", "sigma", "s"), [(2.0, 50.0, 5.0), (0.1, 3.0, 7.0)])
def test_gains_and_covariances_are_those_of_the_riccati_equation(
    noise: str, states: int, t: float, sigma: float, s: float
) -> None:
    """SciPy's solution is good to some 1e-9 on such grids."""
    f = np.array([[1, t, t * t / 2], [0, 1, t], [0, 0, 1]])[:states, :states]
    h = np.eye(states)[:1]
    for found in steady_filters(t, sigma, noise, s, states):
        q = process_noise(found.name, t, s)
        p = solve_discrete_are(f.T, h.T, q, [[sigma * sigma]])
        k = p[:, 0] / (p[0, 0] + sigma * sigma)
        np.testing.assert_allclose(found.gain, k, rtol=1e-7)
        np.testing.assert_allclose(found.predicted, p, rtol=1e-7)
        np.testing.assert_allclose(found.updated, p - np.outer(k, p[0]), rtol=1e-7)
        largest = max(abs(np.linalg.eigvals((np.eye(states) - np.outer(k, h)) @ f)))
        assert found.samples == np.ceil(np.log(0.01) / np.log(largest))


@pytest.mark.parametrize("states", [2, 3])
def test_the_lines_to_paste_are_a_step_of_the_filter(states: int, tmp_path: Path) -> None:
    noise = {2: "acceleration_noise", 3: "jerk_noise"}[states]
    (found,) = steady_filters(T, SIGMA, noise, 5.0, states)
    f = np.array([[1, T, T * T / 2], [0, 1, T], [0, 0, 1]])[:states, :states]
    start = np.array([3.0, -1.0, 0.5])[:states]
    predicted = f @ start
    wanted = predicted + np.array(found.gain) * (7.0 - predicted[0])
    names = dict(zip("xva", map(float, start), strict=False), z=7.0)
    exec(found.python(T), {}, names)  # noqa: S102
    np.testing.assert_allclose([names[each] for each in "xva"[:states]], wanted, rtol=1e-14)
    if shutil.which("cc") is None:
        return
    begin = "".join(f"double {each} = {names_of};" for each, names_of in
                    [*zip("xva", start, strict=False), ("z", 7.0)])  # fmt: skip
    printed = ", ".join("xva"[:states])
    (tmp_path / "a.c").write_text(
        f"#include <stdio.h>\nint main(void) {{{begin}\n{found.c(T)}\n"
        f'printf("{" %.17g" * states}\\n", {printed}); return 0; }}\n'
    )
    subprocess.run(["cc", "-std=c99", "-o", tmp_path / "a", tmp_path / "a.c"], check=True)
    out = subprocess.run([tmp_path / "a"], check=True, capture_output=True, text=True).stdout
    np.testing.assert_allclose(list(map(float, out.split())), wanted, rtol=1e-14)


@pytest.mark.parametrize("states", [2, 3])
def test_the_lag_is_that_of_a_run(states: int, capsys: pytest.CaptureFixture[str]) -> None:
    """Behind a target with a constant acceleration or jerk of 4, run until it is steady."""
    noise = {2: "acceleration_noise", 3: "jerk_noise"}[states]
    (found,) = steady_filters(0.1, 3.0, noise, 4.0, states)
    f = np.array([[1, 0.1, 0.005], [0, 1, 0.1], [0, 0, 1]])[:states, :states]
    true, step = np.zeros(states + 1), np.eye(states + 1)
    for i in range(states + 1):
        for j in range(i + 1, states + 1):
            step[i, j] = 0.1 ** (j - i) / [1, 1, 2, 6][j - i]
    true[states] = 4.0
    x = np.zeros(states)
    for _ in range(2000):
        true = step @ true
        predicted = f @ x
        x = predicted + np.array(found.gain) * (true[0] - predicted[0])
    errors = (true[0] - predicted[0], true[0] - x[0], true[1] - x[1])
    np.testing.assert_allclose(np.array(found.lags) * 4, errors, rtol=1e-6)
    option = {2: "--acceleration", 3: "--jerk"}[states]
    said = ["--interval", "0.1", "--deviation", "3", f"--{noise.replace('_', '-')}", "4"]
    assert cli.main(["design", *said, option, "4"]) == 0
    assert f"wrong by {errors[0]:.6g} m when" in capsys.readouterr().out.replace("\n  ", " ")


def test_the_index_is_rounded_once_however_large_its_factors() -> None:
    """T^2 underflows: Lambda is 1."""
    (found,) = steady_filters(2.0**-600, 2.0**-400, "acceleration_noise", 2.0**800)
    assert (found.tracking_index, found.alpha_beta) == (1.0, (0.75, 0.5))
    (white,) = steady_filters(2.0**-100, 2.0**-200, "acceleration_density", 2.0**-100)
    assert white.tracking_index == 1.0


def test_as_text_and_as_data(capsys: pytest.CaptureFixture[str]) -> None:
    said = ["design", "--interval", "2", "--deviation", "50", "--acceleration-noise", "5"]
    assert cli.main(said) == 0
    text = capsys.readouterr().out
    for part in ("tracking index sigma_w T^2/sigma_v = 0.4", "alpha = 0.588167, beta = 0.256697",
                 "K_2 = 0.128348 per s", "falls to 1 % in 11 samples, 22 s"):  # fmt: skip
        assert part in text
    assert cli.main([*said, "--json"]) == 0
    (found,) = json.loads(capsys.readouterr().out)["filters"]
    assert found["name"] == "random-acceleration"
    assert found["gain_in_units"][1] == pytest.approx(found["gains"]["beta"] / 2)
    assert found["python"] in re.sub("^    ", "", text, flags=re.MULTILINE)
    assert cli.main([*said, "--states", "3"]) == 0
    assert capsys.readouterr().out.count("Kalman filter in its steady state") == 2


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--acceleration-noise", "5"], "--acceleration-noise takes --interval and --deviation"),
        (["--acceleration-noise", "5", "--interval", "2"], "takes --deviation beside it"),
        (["--acceleration-noise", "0", "--interval", "2", "--deviation", "1"], "must be above 0"),
        (["--acceleration-noise", "x", "--interval", "2", "--deviation", "1"], "must be a number"),
        (
            ["--jerk-noise", "1", "--interval", "2", "--deviation", "1", "--states", "2"],
            "drives 3 states, got 2; 2 states take --velocity-noise, --acceleration-noise,",
        ),
        (
            ["--jerk-noise", "1", "--interval", "2", "--deviation", "1", "--acceleration", "2"],
            "--acceleration belongs to 2 states",
        ),
        (
            ["--jerk-noise", "1", "--interval", "2", "--deviation", "1", "--plot", "x.svg"],
            "--plot belongs to the named filters",
        ),
        (
            ["--jerk-noise", "1e300", "--interval", "1e9", "--deviation", "1e-300"],
            "the tracking index is beyond float64",
        ),
    ],
)
def test_bad_input(capsys: pytest.CaptureFixture[str], arguments: list[str], told: str) -> None:
    assert cli.main(["design", *arguments]) == 2
    assert told in capsys.readouterr().err
