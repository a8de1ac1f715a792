"""A filter with the kernels' gain, run on simulated tracks, errs as the kernels' covariance says.

Each of 20,000 tracks gives one prediction error, so that N times the sample covariance W has the
Wishart distribution of N degrees and the covariance under test, if that is right. Whitened by it,
W has a Cholesky factor whose entries are independent: t11^2 is chi-square of N degrees, t22^2 of
N - 1, t21 standard normal (Bartlett, 1933). Each is asked to lie in its central interval of
probability 1 - 1e-6/3: all three do with confidence 1 - 1e-6, about 5 % either way for a
variance. The seed is fixed, so that a test that passes once passes always. The gain rounded to
float64 and the start, forgotten to 1e-4, move the covariance by about 1e-8: nothing beside this.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from itertools import product

import numpy as np
import pytest
from numpy.typing import NDArray
from one_of_each import cases

from gainproof.position_velocity import PROCESS_NOISES, steady_state
from gainproof.verify.oracles import tracks
from gainproof.verify.oracles.matrices import matrix
from gainproof.verify.oracles.state_space import StateSpace, exact

TRACKS = 20_000
CONFIDENCE = 1 - 1e-6
FORGOTTEN = 1e-4
# sampling interval, and the deviations of position, velocity and acceleration
SETTINGS = {
    "scanning radar": (10.0, 100.0, 5.0, 0.5),
    "good velocity": (1.0, 30.0, 1.0, 2.0),
    "poor velocity": (0.5, 3.0, 400.0, 10.0),
    "restless target": (4.0, 10.0, 20.0, 30.0),
}


def physical_model(
    interval: float, position: float, velocity: float, acceleration: float, process_noise: str
) -> StateSpace:
    """The model in metres and seconds, from the words that describe each noise."""
    t, a = exact(interval), exact(acceleration)
    shapes = {
        "continuous-white-acceleration": ((t**4 / 3, t**3 / 2), (t**3 / 2, t**2)),
        "random-acceleration": ((t**4 / 4, t**3 / 2), (t**3 / 2, t**2)),
        "random-velocity": ((0 * t, 0 * t), (0 * t, t**2)),
    }
    one, zero = Fraction(1), Fraction(0)
    return StateSpace(
        ((one, t), (zero, one)),
        matrix(shapes[process_noise], lambda x: a * a * x),
        ((one, zero), (zero, one)),
        ((exact(position) ** 2, zero), (zero, exact(velocity) ** 2)),
    )


def agrees(errors: NDArray[np.float64], covariance: NDArray[np.float64]) -> bool:
    """Whether the errors' second moments are in the joint interval of stated confidence."""
    from scipy import stats  # half a second, in every process that collects

    count = len(errors)
    white = np.linalg.solve(np.linalg.cholesky(covariance), errors.T)
    factor = np.linalg.cholesky(white @ white.T)
    each = 1 - (1 - CONFIDENCE) / 3
    checks = (
        (stats.chi2(count), factor[0, 0] ** 2),
        (stats.chi2(count - 1), factor[1, 1] ** 2),
        (stats.norm(), factor[1, 0]),
    )
    return all(low <= value <= high for d, value in checks for low, high in [d.interval(each)])


@cache
def errors_of(setting: str, process_noise: str) -> NDArray[np.float64]:
    model = physical_model(*SETTINGS[setting], process_noise)
    gain = steady_state(*SETTINGS[setting], process_noise).gain
    samples = tracks.samples_to_forget(model, gain, FORGOTTEN)
    return tracks.prediction_errors(model, gain, samples, TRACKS, seed=1986)


CASES = list(product(sorted(SETTINGS), sorted(PROCESS_NOISES)))
FIRST, SECOND = CASES[0]
ONE_OF_EACH = [case for case in CASES if case[0] == FIRST or case[1] == SECOND]


@pytest.mark.alike
@pytest.mark.parametrize(("setting", "process_noise"), cases(CASES, ONE_OF_EACH.__contains__))
def test_sample_covariance_is_that_of_the_kernels(setting: str, process_noise: str) -> None:
    found = steady_state(*SETTINGS[setting], process_noise)
    assert agrees(errors_of(setting, process_noise), found.predicted)


@pytest.mark.parametrize(
    "changed",
    [
        pytest.param((10.0, 107.0, 5.0, 0.5), id="position deviation 7 % larger"),
        pytest.param((10.0, 100.0, 6.0, 0.5), id="velocity deviation 20 % larger"),
        pytest.param((10.0, 100.0, 5.0, 0.45), id="acceleration deviation 10 % smaller"),
    ],
)
def test_a_covariance_of_other_deviations_is_seen(
    changed: tuple[float, float, float, float],
) -> None:
    errors = errors_of("scanning radar", "continuous-white-acceleration")
    assert not agrees(errors, steady_state(*changed).predicted)


def test_a_covariance_of_another_process_noise_is_seen() -> None:
    errors = errors_of("good velocity", "continuous-white-acceleration")
    wrong = steady_state(*SETTINGS["good velocity"], "random-acceleration").predicted
    assert not agrees(errors, wrong)


def test_the_updated_covariance_is_not_that_of_the_predictions() -> None:
    found = steady_state(*SETTINGS["scanning radar"])
    assert not agrees(errors_of("scanning radar", "continuous-white-acceleration"), found.updated)


def test_a_filter_with_another_gain_errs_more() -> None:
    """Its errors are larger than the kernels' covariance says, which is the least there is."""
    setting = SETTINGS["scanning radar"]
    model, found = physical_model(*setting, "continuous-white-acceleration"), steady_state(*setting)
    gain = found.gain * [[0.6], [1.4]]
    samples = tracks.samples_to_forget(model, gain, FORGOTTEN)
    errors = tracks.prediction_errors(model, gain, samples, TRACKS, seed=1986)
    assert np.all(np.var(errors, axis=0) > np.diag(found.predicted))
    assert not agrees(errors, found.predicted)
