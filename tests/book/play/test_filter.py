"""What the play computes beside printed kernels, against NumPy and SciPy: matrices written anew."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import node
import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import solve_discrete_lyapunov

import gainproof
from gainproof.book.play import OWN
from gainproof.generated import _runtime

STATIC = Path(gainproof.__file__).resolve().parent / "book" / "static"
FILTER = (STATIC / "play.filter.js",)
Reals = NDArray[np.float64]

GAINS: list[list[list[float]]] = [
    [[0.5], [0.2]],
    [[1.2], [0.7]],
    [[0.6], [0.3], [0.08]],
    [[0.5, 0.2], [0.1, 0.4]],
    [[0.9, -0.1], [0.3, 0.05]],
]


def shift(n: int) -> Reals:
    return np.array([[1.0, 1.0, 0.5], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]])[:n, :n]


def parts(gain: list[list[float]]) -> tuple[Reals, Reals, Reals]:
    """F, K and H."""
    k = np.array(gain)
    return shift(len(k)), k, np.eye(*k.shape[::-1])


def run(gain: list[list[float]], measured: Reals) -> Reals:
    f, k, h = parts(gain)
    state = np.zeros(len(k))
    found = []
    for y in measured:
        state = (np.eye(len(k)) - k @ h) @ f @ state + k @ y
        found.append(state[0])
    return np.array(found)


@pytest.fixture(scope="module")
def found() -> Any:
    program = """
        const f = gainproof.play.filter;
        return given.map((gain) => {
          const deviations = gain[0].map((_, j) => 1 + j / 2);
          const noisy = f.noisyRest(deviations, 200, 7);
          return {
            step: f.stepResponse(gain, 50), noisy, response: f.respond(gain, noisy),
            covariance: f.noiseCovariance(gain, deviations),
            lag: gain.length === 2 && gain[0].length === 2 ? f.lagOfTwo(gain) : null,
          };
        });"""
    return node.answers(program, FILTER, GAINS)


@node.needs_node
@pytest.mark.parametrize("place", range(len(GAINS)))
def test_responses(found: Any, place: int) -> None:
    gain, answer = GAINS[place], found[place]
    jump = np.zeros((50, len(gain[0])))
    jump[:, 0] = 1.0
    np.testing.assert_allclose(answer["step"], run(gain, jump), rtol=0, atol=1e-13)
    noisy = np.array(answer["noisy"])
    np.testing.assert_allclose(answer["response"], run(gain, noisy), rtol=0, atol=1e-12)


@node.needs_node
@pytest.mark.parametrize("place", range(len(GAINS)))
def test_covariance_solves_the_lyapunov_equation(found: Any, place: int) -> None:
    gain = GAINS[place]
    f, k, h = parts(gain)
    noise = np.diag([(1 + j / 2) ** 2 for j in range(len(gain[0]))])
    loop = (np.eye(len(k)) - k @ h) @ f
    assert max(abs(np.linalg.eigvals(loop))) < 1
    updated = solve_discrete_lyapunov(loop, k @ noise @ k.T)
    np.testing.assert_allclose(found[place]["covariance"]["updated"], updated, rtol=1e-11)
    predicted = f @ updated @ f.T
    np.testing.assert_allclose(found[place]["covariance"]["predicted"], predicted, rtol=1e-11)


@node.needs_node
@pytest.mark.parametrize("place", [3, 4])
def test_lag_is_where_a_track_settles(found: Any, place: int) -> None:
    f, k, _ = parts(GAINS[place])
    truth, state, predicted = np.zeros(2), np.zeros(2), np.zeros(2)
    for _step in range(400):
        truth = f @ truth + np.array([0.5, 1.0])
        predicted = f @ state
        state = predicted + k @ (truth - predicted)
    assert found[place]["lag"] == pytest.approx(truth[0] - predicted[0], rel=1e-8)


def mulberry(count: int, seed: int) -> list[float]:
    """Uniform numbers of the generator mulberry32, in whole numbers of Python."""
    mask, state, found = 2**32 - 1, seed, []
    for _ in range(count):
        state = (state + 0x6D2B79F5) & mask
        x = ((state ^ (state >> 15)) * (state | 1)) & mask
        x ^= (x + (((x ^ (x >> 7)) * (x | 61)) & mask)) & mask
        found.append(((x ^ (x >> 14)) & mask) / 2**32)
    return found


@node.needs_node
def test_noise_is_seeded_and_normal() -> None:
    count = 20_000
    program = "return given.map((seed) => gainproof.play.filter.noise(20000, seed));"
    first, again, other = node.answers(program, FILTER, [1, 1, 2])
    assert first == again
    assert first != other
    u = np.array(mulberry(2 * count, 1)).reshape(-1, 2)
    wanted = np.sqrt(-2 * np.log(1 - u[:, 0])) * np.cos(2 * np.pi * u[:, 1])
    np.testing.assert_allclose(first, wanted, rtol=0, atol=1e-14)
    # five standard deviations of each moment of so many normal numbers
    x, room = np.array(first), 5 / np.sqrt(count)
    assert abs(x.mean()) < room
    assert abs((x**2).mean() - 1) < np.sqrt(2) * room
    assert abs((x**3).mean()) < np.sqrt(15) * room
    assert abs((x**4).mean() - 3) < np.sqrt(96) * room
    assert abs((x[1:] * x[:-1]).mean()) < room


def sorted_poles(poles: Any) -> NDArray[np.complex128]:
    return np.sort_complex(np.array([complex(*pole) for pole in poles]))


@node.needs_node
def test_pairs_and_triples_of_poles() -> None:
    random = np.random.default_rng(4)
    pairs = np.column_stack([random.uniform(-2, 2, 200), random.uniform(-2, 2, 200)]).tolist()
    gains = random.uniform([0.01, 0.01, 0.01], [2.0, 4.0, 8.0], (300, 3)).tolist()
    gains += [[0.875, 1.125, 0.5], [0.488, 0.288, 0.064 * 2]]
    program = """
        const f = gainproof.play.filter;
        const kernel = gainproof.kernels["alpha-beta-gamma"];
        return [given[0].map(([h, d]) => f.pair(h, d)),
                given[1].map((gains) => f.triple(kernel.closed_loop_poles(...gains)))];"""
    folder = Path(_runtime.__file__).parent
    scripts = (folder / "_runtime.js", folder / "alpha_beta_gamma.js", *FILTER)
    twos, threes = node.answers(program, scripts, [pairs, gains])
    for (half, quarter), poles in zip(pairs, twos, strict=True):
        root = np.sqrt(complex(quarter))
        wanted = sorted_poles([[z.real, z.imag] for z in (half + root, half - root)])
        np.testing.assert_allclose(sorted_poles(poles), wanted, rtol=0, atol=1e-14)
    for gain, poles in zip(gains, threes, strict=True):
        f, k, h = parts([[g] for g in gain])
        polynomial = np.poly((np.eye(3) - k @ h) @ f)
        assert len(poles) == 3
        # each is a root: where roots meet, places are ill conditioned and values are not; a pole is
        # a sum of terms of about 1, so that a small one has the roundings of 1
        z = np.array([complex(*pole) for pole in poles])
        size = np.polyval(np.abs(polynomial), np.maximum(np.abs(z), 1.0))
        assert np.all(np.abs(np.polyval(polynomial, z)) < 1e-13 * size)
        np.testing.assert_allclose(np.poly(z), polynomial, rtol=0, atol=1e-12)


def test_the_scripts_are_those_of_the_folder() -> None:
    named = {f"play.{name}.js" for name in OWN} | {"play.js", "play.css"}
    assert {path.name for path in STATIC.glob("play.*")} == named
