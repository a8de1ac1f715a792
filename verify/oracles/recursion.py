"""Steady state by running the Kalman recursion until it stands still.

Independent because it is the filter itself, started from a covariance and run sample by sample;
no equation is solved. It answers in float64 or in multiprecision.

Where it can work: the error shrinks by the square of the largest closed-loop pole per sample,
so the number of samples is about (digits asked for) / (1 - |pole|). In float64 that is practical
for tracking indices from about 1e-8 to 1e6 (fewer than 1e5 samples), in multiprecision from
about 1e-4 to 1e3. Beyond its limit of samples it raises NotConverged, never a poor answer.

The accuracy rests on the geometric approach: if the covariance after 2 N samples differs from
the one after N by a relative d, what remains is about d^2. While the start is still being
forgotten like a power of the time, d is of order one, so the test cannot be passed early. In
float64 the rounding of each sample is forgotten at the same rate: the floor is a few
eps / (1 - |pole|^2).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from gainproof.verify.oracles.matrices import Matrix, largest_ratio, subtract
from gainproof.verify.oracles.multiprecision import bits_for, context, number_in
from gainproof.verify.oracles.riccati import in_numbers, predict, update
from gainproof.verify.oracles.state_space import NotConverged, StateSpace, SteadyState


@dataclass(frozen=True)
class Run:
    """A steady state reached by running the filter, and the number of samples it took."""

    state: SteadyState
    samples: int


def run_float(model: StateSpace, most_samples: int = 200_000) -> Run:
    """The recursion in float64, to the floor that its own rounding sets."""
    # d = 2^-30 leaves 2^-60 of the start, below the rounding of one sample
    return _run(model, float, 2.0**-30, most_samples)


def run_multiprecision(model: StateSpace, digits: int = 40, most_samples: int = 50_000) -> Run:
    """The recursion in multiprecision, to ``digits`` digits (with 60 guard bits)."""
    bits = bits_for(digits)
    own = context(bits + 60)
    return _run(model, number_in(own), own.ldexp(own.mpf(1), -(bits // 2) - 1), most_samples)


def transient(
    model: StateSpace, start: Matrix, samples: int, number: Callable[[Any], Any] = lambda x: x
) -> tuple[SteadyState, ...]:
    """The filter's covariances and gains at samples 0, 1, ...; ``start`` is predicted for 0.

    With the default ``number`` everything stays an exact fraction.
    """
    numbers = in_numbers(model, number)
    states = []
    predicted = start
    for _ in range(samples):
        state = update(numbers, predicted)
        states.append(state)
        predicted = predict(numbers, state.updated)
    return tuple(states)


def _run(model: StateSpace, number: Callable[[Any], Any], tolerance: Any, most_samples: int) -> Run:
    numbers = in_numbers(model, number)
    # A definite start with the process noise in it reaches every state of the model.
    sensor = number(max(row[i] for i, row in enumerate(model.measurement_noise)))
    predicted: Matrix = tuple(
        tuple(x + sensor if i == j else x for j, x in enumerate(row))
        for i, row in enumerate(numbers.process_noise)
    )
    window, samples = 16, 0
    while samples + window <= most_samples:
        earlier = predicted
        for _ in range(window):
            predicted = predict(numbers, update(numbers, predicted).updated)
        samples += window
        if samples > window and largest_ratio(subtract(predicted, earlier), predicted) < tolerance:
            return Run(update(numbers, predicted), samples)
        window = samples
    raise NotConverged(f"the Kalman recursion still moves after {samples} samples")
