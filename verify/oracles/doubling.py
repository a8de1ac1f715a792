"""Steady state by the structured doubling algorithm, in multiprecision.

Independent because it knows only the matrices F, Q, H, R and the doubling recursion (Anderson,
1978; Chu, Fan, Lin and Wang, 2004): step k holds the covariance that the filter reaches after
2^k samples from a perfectly known start. No spectrum, no pole and no closed form enters.

The accuracy rests on three things, each checked on every call. The run is repeated with half as
many bits again, and the two must agree. One Newton step is computed from the Riccati residual of
the better run (a Lyapunov equation for the closed loop), and its correction, an estimate of the
remaining error that does not trust the iteration, must be below the digits asked for. And the
closed loop must shrink: a power of it is small, so that the solution is the stabilising one.

The working precision grows with the distance of the noise ratio from one, since the entries of
the doubled matrices then spread over as many orders; it is raised until the checks hold.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from gainproof.verify.oracles.matrices import (
    Matrix,
    add,
    identity,
    largest_ratio,
    product,
    solve,
    solve_lyapunov,
    subtract,
    symmetric,
    transpose,
)
from gainproof.verify.oracles.multiprecision import bits_for, context, number_in
from gainproof.verify.oracles.riccati import closed_loop, in_numbers, residual, update
from gainproof.verify.oracles.state_space import NotConverged, StateSpace, SteadyState

LARGEST_PRECISION = 1 << 16
LONGEST_RUN = 1 << 13


@dataclass(frozen=True)
class Doubled:
    """A steady state in multiprecision floats of so many bits."""

    state: SteadyState
    bits: int


def steady_state(model: StateSpace, digits: int = 40) -> Doubled:
    """The stabilising steady state of ``model`` to ``digits`` digits in every entry.

    Works for process noise from the square of the smallest subnormal float to the square of the
    largest float (about a second at either end for two states, a few milliseconds near one).
    Raises NotConverged when the model has no stabilising solution or the precision runs out.
    """
    wanted = math.ldexp(1.0, -bits_for(digits))
    bits = 64 + bits_for(digits) + _spread(model)
    coarse = _run(model, bits)
    disagreement = correction = math.inf
    while bits <= LARGEST_PRECISION:
        bits += bits // 2
        fine = _run(model, bits)
        disagreement = _difference(coarse, fine)
        correction = _newton_correction(model, fine, bits)
        if disagreement <= wanted and correction <= wanted:
            return Doubled(fine, bits)
        coarse = fine
    raise NotConverged(
        f"doubling: no {digits} digits with {bits} bits "
        f"(runs differ by {disagreement:.1e}, Newton correction {correction:.1e})"
    )


def _spread(model: StateSpace) -> int:
    """How many bits the ratio of process to measurement noise is away from one."""
    process = max(abs(x) for row in model.process_noise for x in row)
    sensor = max(abs(x) for row in model.measurement_noise for x in row)
    if process == 0 or sensor == 0:
        raise ValueError("doubling needs process noise and measurement noise, one of them is 0")
    ratio = process / sensor
    return abs(int(ratio.numerator.bit_length()) - int(ratio.denominator.bit_length()))


def _run(model: StateSpace, bits: int) -> SteadyState:
    own = context(bits)
    numbers = in_numbers(model, number_in(own))
    one = own.mpf(1)
    unit = identity(model.size, one)
    a = transpose(numbers.transition)
    h = numbers.measurement
    g = product(transpose(h), solve(numbers.measurement_noise, h))
    m = numbers.process_noise
    # Quadratic convergence: once a step changes less than the square root of the precision,
    # the step after it changes less than the precision.
    enough = own.ldexp(one, -(bits // 2))
    last = False
    for _ in range(1, LONGEST_RUN):
        w = add(unit, product(g, m))
        both = solve(w, tuple(x + y for x, y in zip(a, g, strict=True)))
        wa = tuple(row[: model.size] for row in both)
        wg = tuple(row[model.size :] for row in both)
        step = symmetric(product(transpose(a), m, wa))
        g = symmetric(add(g, product(a, wg, transpose(a))))
        a = product(a, wa)
        m = add(m, step)
        if last:
            return update(numbers, m)
        last = largest_ratio(step, m) <= enough
    raise NotConverged(f"doubling: still changing after 2^{LONGEST_RUN} samples")


def _difference(one: SteadyState, other: SteadyState) -> float:
    pairs = [
        (one.predicted, other.predicted),
        (one.updated, other.updated),
        (one.gain, other.gain),
        (one.innovation, other.innovation),
    ]
    # the better run stands left, so that its context decides the precision of the subtraction
    return max(float(largest_ratio(subtract(fine, rough), fine)) for rough, fine in pairs)


def _newton_correction(model: StateSpace, state: SteadyState, bits: int) -> float:
    numbers = in_numbers(model, number_in(context(bits)))
    loop = closed_loop(numbers, state.gain)
    _require_stable(loop, bits)
    correction: Matrix = solve_lyapunov(loop, residual(numbers, state.predicted))
    return float(largest_ratio(correction, state.predicted))


def _require_stable(loop: Matrix, bits: int) -> None:
    power = loop
    for _ in range(2 * bits):
        if max(sum(abs(x) for x in row) for row in power) < 1:
            return
        power = product(power, power)
    raise NotConverged("doubling: the closed loop does not shrink, no stabilising solution")
