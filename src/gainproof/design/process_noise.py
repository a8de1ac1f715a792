"""Steady-state filters from the deviations of noises, in metres and seconds."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from types import MappingProxyType, ModuleType
from typing import Any

import numpy as np

from gainproof.bad_input import BadInputError
from gainproof.design.page import GAINS, number, settles, table, wrapped
from gainproof.fixed_gain import three_states, two_states
from gainproof.fixed_gain.settling import samples_to_settle
from gainproof.generated import (
    acceleration_increments,
    continuous_white_acceleration,
    continuous_white_jerk,
    random_acceleration,
    random_jerk,
    random_velocity,
    wiener_acceleration,
)


@dataclass(frozen=True)
class ProcessNoise:
    """How a user says what drives the target.

    Attributes
    ----------
    words, unit : str
        What the number is, and its unit.
    words_of_three : str
        What it is where there are three states, if that is another thing.
    power : int
        Of T: Lambda is deviation T^power/sigma_v, Lambda^2 is density T^power/sigma_v^2.
    density : bool
        Whether the number is a spectral density.
    models : mapping
        Number of states -> kernels of each model that it drives.
    """

    words: str
    unit: str
    power: int
    density: bool
    models: Mapping[int, tuple[ModuleType, ...]]
    words_of_three: str = ""


NOISES: Mapping[str, ProcessNoise] = MappingProxyType(
    {
        "velocity_noise": ProcessNoise(
            "deviation of the velocity's step", "m/s", 1, False, {2: (random_velocity,)}
        ),
        "acceleration_noise": ProcessNoise(
            "deviation of the acceleration",
            "m/s^2",
            2,
            False,
            {2: (random_acceleration,), 3: (acceleration_increments, wiener_acceleration)},
            "deviation of the acceleration's step",
        ),
        "acceleration_density": ProcessNoise(
            "spectral density of the acceleration",
            "m^2/s^3",
            3,
            True,
            {2: (continuous_white_acceleration,)},
        ),
        "jerk_noise": ProcessNoise("deviation of the jerk", "m/s^3", 3, False, {3: (random_jerk,)}),
        "jerk_density": ProcessNoise(
            "spectral density of the jerk", "m^2/s^5", 5, True, {3: (continuous_white_jerk,)}
        ),
    }
)
"""By the name of the option that takes it."""


@dataclass(frozen=True)
class SteadyFilter:
    """A steady-state filter in metres and seconds.

    Attributes
    ----------
    name, title : str
        Of the model, as `gainproof list` has it.
    tracking_index : float
    alpha_beta : tuple of float
        alpha, beta and, of three states, gamma: gains without units.
    gain : tuple of float
        K_1, K_2 per second, K_3 per second squared.
    predicted, updated : tuple of tuple of float
        Covariances of position, velocity and acceleration, m^2 s^-(i+j).
    lags : tuple of float
        Steady errors of predicted position, updated position and updated velocity behind a
        constant acceleration of 1 m/s^2; of three states behind a jerk of 1 m/s^3.
    samples : float
        Until the largest closed-loop pole's modulus, to that power, is at most 1 %; infinity where
        poles in float64 do not tell.
    """

    name: str
    title: str
    tracking_index: float
    alpha_beta: tuple[float, ...]
    gain: tuple[float, ...]
    predicted: tuple[tuple[float, ...], ...]
    updated: tuple[tuple[float, ...], ...]
    lags: tuple[float, ...]
    samples: float

    def python(self, interval: float) -> str:
        """Lines of Python: one step of the filter."""
        return "\n".join(_step(self.gain, interval, "", ""))

    def c(self, interval: float) -> str:
        """Lines of C: one step of the filter."""
        return "\n".join(_step(self.gain, interval, "const double ", ";"))


def steady_filters(
    interval: float, deviation: float, noise: str, value: float, states: int | None = None
) -> tuple[SteadyFilter, ...]:
    """The steady-state filters of the models that a process noise drives.

    Parameters
    ----------
    interval : float
        Time between samples T, s.
    deviation : float
        Standard deviation of the measured position sigma_v, m.
    noise : str
        A name of `NOISES`.
    value : float
        Its deviation or spectral density, in its unit.
    states : int, optional
        2 or 3; the smaller number that the noise drives if left out.

    Raises
    ------
    BadInputError
        For a number of states that this noise does not drive, and where a number is beyond float64.
    """
    kind = NOISES[noise]
    states = min(kind.models) if states is None else states
    if states not in kind.models:
        wanted = " or ".join(map(str, kind.models))
        others = ", ".join(
            f"--{name.replace('_', '-')}" for name, each in NOISES.items() if states in each.models
        )
        raise BadInputError(
            f"--{noise.replace('_', '-')}, the {kind.words}, drives {wanted} states, got {states}; "
            f"{states} states take {others}"
        )
    index = _index(interval, deviation, kind, value)
    return tuple(_filter(each, index, interval, deviation) for each in kind.models[states])


def _index(interval: float, deviation: float, kind: ProcessNoise, value: float) -> float:
    """Lambda, rounded once: a factor may be beyond float64 where the whole is not."""
    exact = Fraction(value) * Fraction(interval) ** kind.power
    exact = exact / Fraction(deviation) ** 2 if kind.density else exact / Fraction(deviation)
    if kind.density:  # the square of the index, whose root is taken to a hundred bits
        shift = (exact.denominator.bit_length() - exact.numerator.bit_length() + 200) // 2 * 2
        scaled = exact * Fraction(2) ** shift
        exact = Fraction(math.isqrt(int(scaled))) / Fraction(2) ** (shift // 2)
    return _float(exact, "the tracking index")


def _float(exact: Fraction, what: str) -> float:
    try:
        found = float(exact)
    except OverflowError:
        found = math.inf
    if found in (0.0, math.inf):
        raise BadInputError(
            f"--interval, --deviation or the process noise too large or too small: {what} is "
            "beyond float64"
        )
    return found


def _filter(kernels: ModuleType, index: float, interval: float, deviation: float) -> SteadyFilter:
    try:
        gains = tuple(map(float, kernels.gains(index)))
        predicted, updated = (
            _in_units(kernel(index), len(gains), interval, deviation)
            for kernel in (kernels.predicted_covariance, kernels.updated_covariance)
        )
        samples = float(samples_to_settle(_poles(kernels.closed_loop_poles(index), len(gains))))
    except ValueError as error:
        raise BadInputError(f"tracking index {index!s}: {error}") from None
    step = Fraction(interval)
    gain = tuple(
        _float(Fraction(each) / step**order, f"K_{order + 1}") for order, each in enumerate(gains)
    )
    name = kernels.__name__.rpartition(".")[2].replace("_", "-")
    title = (kernels.__doc__ or name).partition(": ")[0]
    lags = _lags(gains, interval)
    return SteadyFilter(name, title, index, gains, gain, predicted, updated, lags, samples)


def _lags(gains: tuple[float, ...], interval: float) -> tuple[float, ...]:
    """Of predicted position, updated position and updated velocity, in seconds to the power that
    makes metres and metres per second of an acceleration or a jerk.
    """
    found: Any = (two_states if len(gains) == 2 else three_states).lags(*gains)
    numbers = (found.predicted_position_lag, found.updated_position_lag, found.updated_velocity_lag)
    powers = (len(gains), len(gains), len(gains) - 1)
    return tuple(
        _float_or_beyond(float(lag), Fraction(interval) ** power)
        for lag, power in zip(numbers, powers, strict=True)
    )


def _float_or_beyond(number: float, factor: Fraction) -> float:
    """The product; infinity or 0 where that is beyond float64."""
    try:
        return float(Fraction(number) * factor)
    except OverflowError:
        return math.inf


def _in_units(
    entries: Any, states: int, interval: float, deviation: float
) -> tuple[tuple[float, ...], ...]:
    """A covariance in units of sigma_v^2 and T, its upper triangle by rows, in m and s."""
    upper = iter(map(float, entries))
    found = [[0.0] * states for _ in range(states)]
    for i in range(states):
        for j in range(i, states):
            entry = next(upper)
            if not 0 < entry < math.inf:
                raise BadInputError(
                    "--interval, --deviation or the process noise too large or too small: an entry "
                    "of a covariance is beyond float64"
                )
            exact = Fraction(entry) * Fraction(deviation) ** 2 / Fraction(interval) ** (i + j)
            found[i][j] = found[j][i] = _float(exact, "an entry of a covariance")
    return tuple(map(tuple, found))


def _poles(poles: Any, states: int) -> Any:
    """The closed-loop poles; of three states one is real, the others half_sum +- a root."""
    if states == 2:
        return np.array([complex(poles.first_real, poles.first_imaginary),
                         complex(poles.second_real, poles.second_imaginary)])  # fmt: skip
    root = np.sqrt(complex(poles.quarter_discriminant))
    return np.array([complex(poles.real_pole), poles.half_sum + root, poles.half_sum - root])


def _step(gain: tuple[float, ...], interval: float, declared: str, end: str) -> list[str]:
    """One step: predict, compare with the measured position z, correct."""
    t = f"{interval!r}"
    names = ("x", "v", "a")[: len(gain)]
    predict = [f"x += {t} * v"]
    if len(gain) == 3:
        half_square = _float(Fraction(interval) ** 2 / 2, "half the square of the interval")
        predict = [f"x += {t} * v + {half_square!r} * a", f"v += {t} * a"]
    correct = [f"{name} += {each!r} * r" for name, each in zip(names, gain, strict=True)]
    return [f"{line}{end}" for line in (*predict, f"{declared}r = z - x", *correct)]


def page_of_filters(
    filters: Sequence[SteadyFilter],
    interval: float,
    deviation: float,
    noise: str,
    value: float,
    motion: float | None = None,
) -> str:
    """For a terminal: each filter with its gains, covariances, lag behind a `motion` (m/s^2, of
    three states m/s^3) and lines to paste.
    """
    kind = NOISES[noise]
    three = len(filters[0].gain) == 3
    words = (kind.words_of_three if three else "") or kind.words
    said = (
        f"interval {number(interval)} s, deviation of the measured position {number(deviation)} m, "
        f"{words} {number(value)} {kind.unit}"
    )
    lines = []
    for each in filters:
        index = f"sqrt(q T^{kind.power})" if kind.density else f"sigma_w T^{kind.power}"
        index = f"{index.removesuffix('^1')}/sigma_v = {number(each.tracking_index)}"
        lines += [f"{each.title}: Kalman filter in its steady state", *wrapped(said)]
        lines += [f"tracking index {index}", ""]
        named = [f"{name} = {number(x)}" for name, x in zip(GAINS, each.alpha_beta, strict=False)]
        units = ("", " per s", " per s^2")
        gains = [f"K_{i + 1} = {number(x)}{units[i]}" for i, x in enumerate(each.gain)]
        lines += wrapped(f"gains: {', '.join(named)}; {', '.join(gains)}")
        lines += ["", *_covariances(each), "", *_errors(each, interval, motion)]
        for language, step in (("Python", each.python), ("C", each.c)):
            lines += ["", f"One step in {language}, z being the measured position:", ""]
            lines += [f"    {line}" for line in step(interval).splitlines()]
        lines += ["", "As functions of the tracking index, in Python, C, Rust and others:"]
        lines += [f"    gainproof generate {each.name} --out gains --target c", ""]
    return "\n".join(lines[:-1])


def _errors(each: SteadyFilter, interval: float, motion: float | None) -> Iterator[str]:
    """Deviations while the target moves as the model says, and errors while it does not."""
    three = len(each.gain) == 3
    yield from wrapped(
        f"One standard deviation after a measurement: position {_root(each.updated, 0)} m, "
        f"velocity {_root(each.updated, 1)} m/s"
        + (f", acceleration {_root(each.updated, 2)} m/s^2" if three else "")
        + ", of a target that moves as the model says."
    )
    size = 1.0 if motion is None else motion
    unit = "m/s^3" if three else "m/s^2"
    if all(map(math.isfinite, each.lags)):
        predicted, position, velocity = (number(lag * size) for lag in each.lags)
        yield from wrapped(
            f"Behind a target that keeps {'a jerk' if three else 'an acceleration'} of "
            f"{number(size)} {unit} it is wrong by {predicted} m when it predicts, and after a "
            f"measurement by {position} m and {velocity} m/s."
        )
    if math.isfinite(each.samples):
        yield from wrapped(
            f"The slowest closed-loop pole falls to 1 % in {settles(each.samples)} samples, "
            f"{number(each.samples * interval)} s."
        )


_NAMES = ("position", "velocity", "acceleration")


def _covariances(each: SteadyFilter) -> Iterator[str]:
    rows = []
    for i in range(len(each.gain)):
        for j in range(i, len(each.gain)):
            what = f"variance of {_NAMES[i]}" if i == j else f"{_NAMES[i]} and {_NAMES[j]}"
            unit = "m^2" + (f"/s^{i + j}" if i + j > 1 else "/s" if i + j else "")
            entries = (number(each.predicted[i][j]), number(each.updated[i][j]))
            rows.append([f"{what}, {unit}", *entries])
    yield from table([["covariance", "predicted", "updated"]], rows)


def _root(covariance: tuple[tuple[float, ...], ...], place: int) -> str:
    return number(math.sqrt(covariance[place][place]))


def plain_filters(
    filters: Sequence[SteadyFilter], interval: float, deviation: float, noise: str, value: float
) -> dict[str, Any]:
    """For JSON: what was said, and each filter's numbers in metres and seconds."""
    said = {"interval_s": interval, "deviation_m": deviation, noise: value}
    return {
        "choice": {"kind": noise, "unit": NOISES[noise].unit, "value": value},
        "units": said,
        "filters": [
            {
                "name": each.name,
                "title": each.title,
                "tracking_index": each.tracking_index,
                "gains": dict(zip(GAINS, each.alpha_beta, strict=False)),
                "gain_in_units": list(each.gain),
                "predicted_covariance": [list(row) for row in each.predicted],
                "updated_covariance": [list(row) for row in each.updated],
                "lags_behind_one": [x if math.isfinite(x) else None for x in each.lags],
                "samples_to_one_per_cent": each.samples if math.isfinite(each.samples) else None,
                "python": each.python(interval),
                "c": each.c(interval),
            }
            for each in filters
        ],
    }
