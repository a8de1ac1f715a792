# Made by: gainproof generate filter-step
# From: gainproof derive filter-step, SymPy 1.14.0
"""One step of filters with fixed gains."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy import add, divide, multiply, subtract

from gainproof.generated._numbers import ONE, Double, named
from gainproof.generated._runtime import evaluate
from gainproof.generated._signature import Domain, Signature

if TYPE_CHECKING:
    from typing import NamedTuple

    from gainproof.generated._numbers import Form
    from gainproof.generated._signature import ArrayLike, Arrays, Real
else:
    from gainproof.generated._result import NamedTuple

__all__ = [
    "StepInteracting",
    "StepThreeStates",
    "StepTwoStates",
    "step_interacting",
    "step_three_states",
    "step_two_states",
]

_POSITION_DOMAIN = Domain(
    "position",
    "of magnitude at most 1e40, in float32 1e8",
    (0.0, 1e40),
    (0.0, 100000000.0),
    zero=True,
    signed=True,
)
_VELOCITY_DOMAIN = Domain(
    "velocity",
    "of magnitude at most 1e40, in float32 1e8",
    (0.0, 1e40),
    (0.0, 100000000.0),
    zero=True,
    signed=True,
)
_INTERVAL_DOMAIN = Domain(
    "interval",
    "a number at least 1e-10 and at most 1e10, in float32 at least 1e-3 and at most 1e4",
    (1e-10, 10000000000.0),
    (0.0010000000474974513, 10000.0),
)
_OBSERVED_DOMAIN = Domain(
    "observed",
    "of magnitude at most 1e40, in float32 1e8",
    (0.0, 1e40),
    (0.0, 100000000.0),
    zero=True,
    signed=True,
)
_ALPHA_DOMAIN = Domain(
    "alpha",
    "of magnitude at most 1e4, in float32 1e4",
    (0.0, 10000.0),
    (0.0, 10000.0),
    zero=True,
    signed=True,
)
_BETA_DOMAIN = Domain(
    "beta",
    "of magnitude at most 1e4, in float32 1e4",
    (0.0, 10000.0),
    (0.0, 10000.0),
    zero=True,
    signed=True,
)
_ACCELERATION_DOMAIN = Domain(
    "acceleration",
    "of magnitude at most 1e40, in float32 1e8",
    (0.0, 1e40),
    (0.0, 100000000.0),
    zero=True,
    signed=True,
)
_GAMMA_DOMAIN = Domain(
    "gamma",
    "of magnitude at most 1e4, in float32 1e4",
    (0.0, 10000.0),
    (0.0, 10000.0),
    zero=True,
    signed=True,
)
_X_POSITION_DOMAIN = Domain(
    "x_position",
    "of magnitude at most 1e40, in float32 1e8",
    (0.0, 1e40),
    (0.0, 100000000.0),
    zero=True,
    signed=True,
)
_Y_POSITION_DOMAIN = Domain(
    "y_position",
    "of magnitude at most 1e40, in float32 1e8",
    (0.0, 1e40),
    (0.0, 100000000.0),
    zero=True,
    signed=True,
)
_Z_POSITION_DOMAIN = Domain(
    "z_position",
    "of magnitude at most 1e40, in float32 1e8",
    (0.0, 1e40),
    (0.0, 100000000.0),
    zero=True,
    signed=True,
)
_X_VELOCITY_DOMAIN = Domain(
    "x_velocity",
    "of magnitude at most 1e40, in float32 1e8",
    (0.0, 1e40),
    (0.0, 100000000.0),
    zero=True,
    signed=True,
)
_Y_VELOCITY_DOMAIN = Domain(
    "y_velocity",
    "of magnitude at most 1e40, in float32 1e8",
    (0.0, 1e40),
    (0.0, 100000000.0),
    zero=True,
    signed=True,
)
_Z_VELOCITY_DOMAIN = Domain(
    "z_velocity",
    "of magnitude at most 1e40, in float32 1e8",
    (0.0, 1e40),
    (0.0, 100000000.0),
    zero=True,
    signed=True,
)
_X_OBSERVED_DOMAIN = Domain(
    "x_observed",
    "of magnitude at most 1e40, in float32 1e8",
    (0.0, 1e40),
    (0.0, 100000000.0),
    zero=True,
    signed=True,
)
_Y_OBSERVED_DOMAIN = Domain(
    "y_observed",
    "of magnitude at most 1e40, in float32 1e8",
    (0.0, 1e40),
    (0.0, 100000000.0),
    zero=True,
    signed=True,
)
_Z_OBSERVED_DOMAIN = Domain(
    "z_observed",
    "of magnitude at most 1e40, in float32 1e8",
    (0.0, 1e40),
    (0.0, 100000000.0),
    zero=True,
    signed=True,
)
_POSITION_GAIN_11_DOMAIN = Domain(
    "position_gain_11",
    "of magnitude at most 1e4, in float32 1e4",
    (0.0, 10000.0),
    (0.0, 10000.0),
    zero=True,
    signed=True,
)
_POSITION_GAIN_12_DOMAIN = Domain(
    "position_gain_12",
    "of magnitude at most 1e4, in float32 1e4",
    (0.0, 10000.0),
    (0.0, 10000.0),
    zero=True,
    signed=True,
)
_POSITION_GAIN_13_DOMAIN = Domain(
    "position_gain_13",
    "of magnitude at most 1e4, in float32 1e4",
    (0.0, 10000.0),
    (0.0, 10000.0),
    zero=True,
    signed=True,
)
_POSITION_GAIN_21_DOMAIN = Domain(
    "position_gain_21",
    "of magnitude at most 1e4, in float32 1e4",
    (0.0, 10000.0),
    (0.0, 10000.0),
    zero=True,
    signed=True,
)
_POSITION_GAIN_22_DOMAIN = Domain(
    "position_gain_22",
    "of magnitude at most 1e4, in float32 1e4",
    (0.0, 10000.0),
    (0.0, 10000.0),
    zero=True,
    signed=True,
)
_POSITION_GAIN_23_DOMAIN = Domain(
    "position_gain_23",
    "of magnitude at most 1e4, in float32 1e4",
    (0.0, 10000.0),
    (0.0, 10000.0),
    zero=True,
    signed=True,
)
_POSITION_GAIN_31_DOMAIN = Domain(
    "position_gain_31",
    "of magnitude at most 1e4, in float32 1e4",
    (0.0, 10000.0),
    (0.0, 10000.0),
    zero=True,
    signed=True,
)
_POSITION_GAIN_32_DOMAIN = Domain(
    "position_gain_32",
    "of magnitude at most 1e4, in float32 1e4",
    (0.0, 10000.0),
    (0.0, 10000.0),
    zero=True,
    signed=True,
)
_POSITION_GAIN_33_DOMAIN = Domain(
    "position_gain_33",
    "of magnitude at most 1e4, in float32 1e4",
    (0.0, 10000.0),
    (0.0, 10000.0),
    zero=True,
    signed=True,
)
_VELOCITY_GAIN_11_DOMAIN = Domain(
    "velocity_gain_11",
    "of magnitude at most 1e14, in float32 1e7",
    (0.0, 100000000000000.0),
    (0.0, 10000000.0),
    zero=True,
    signed=True,
)
_VELOCITY_GAIN_12_DOMAIN = Domain(
    "velocity_gain_12",
    "of magnitude at most 1e14, in float32 1e7",
    (0.0, 100000000000000.0),
    (0.0, 10000000.0),
    zero=True,
    signed=True,
)
_VELOCITY_GAIN_13_DOMAIN = Domain(
    "velocity_gain_13",
    "of magnitude at most 1e14, in float32 1e7",
    (0.0, 100000000000000.0),
    (0.0, 10000000.0),
    zero=True,
    signed=True,
)
_VELOCITY_GAIN_21_DOMAIN = Domain(
    "velocity_gain_21",
    "of magnitude at most 1e14, in float32 1e7",
    (0.0, 100000000000000.0),
    (0.0, 10000000.0),
    zero=True,
    signed=True,
)
_VELOCITY_GAIN_22_DOMAIN = Domain(
    "velocity_gain_22",
    "of magnitude at most 1e14, in float32 1e7",
    (0.0, 100000000000000.0),
    (0.0, 10000000.0),
    zero=True,
    signed=True,
)
_VELOCITY_GAIN_23_DOMAIN = Domain(
    "velocity_gain_23",
    "of magnitude at most 1e14, in float32 1e7",
    (0.0, 100000000000000.0),
    (0.0, 10000000.0),
    zero=True,
    signed=True,
)
_VELOCITY_GAIN_31_DOMAIN = Domain(
    "velocity_gain_31",
    "of magnitude at most 1e14, in float32 1e7",
    (0.0, 100000000000000.0),
    (0.0, 10000000.0),
    zero=True,
    signed=True,
)
_VELOCITY_GAIN_32_DOMAIN = Domain(
    "velocity_gain_32",
    "of magnitude at most 1e14, in float32 1e7",
    (0.0, 100000000000000.0),
    (0.0, 10000000.0),
    zero=True,
    signed=True,
)
_VELOCITY_GAIN_33_DOMAIN = Domain(
    "velocity_gain_33",
    "of magnitude at most 1e14, in float32 1e7",
    (0.0, 100000000000000.0),
    (0.0, 10000000.0),
    zero=True,
    signed=True,
)


class StepTwoStates(NamedTuple):
    """Result of `step_two_states`."""

    updated_position: Real
    """Position after this update, m."""
    updated_velocity: Real
    """Velocity after this update, m/s."""


def step_two_states(
    position: ArrayLike,
    velocity: ArrayLike,
    interval: ArrayLike,
    observed: ArrayLike,
    alpha: ArrayLike,
    beta: ArrayLike,
    *,
    out: tuple[Real, Real] | None = None,
    workers: int = 1,
) -> StepTwoStates:
    """Prediction and update of tracks with position and velocity.

        updated_position = p + alpha r, updated_velocity = velocity + beta r/t,
        p = position + t velocity, r = observed - p

    position: position after the last update, m; of magnitude at most 1e40, in float32 1e8.
    velocity: velocity after the last update, m/s; of magnitude at most 1e40, in float32 1e8.
    interval: t, time since the last update, s; a number at least 1e-10 and at most 1e10, in float32
        at least 1e-3 and at most 1e4.
    observed: z, what is observed of the position, m; of magnitude at most 1e40, in float32 1e8.
    alpha: gain of the position (0 where nothing was observed); of magnitude at most 1e4, in float32
        1e4.
    beta: gain of the velocity times t; of magnitude at most 1e4, in float32 1e4.

    updated_position: position after this update, m. Error over the sum of its terms taken positive
        at most 2.51 * 2^-52 (float64), 2.51 * 2^-23 (float32), proved for every input, and 3e-319
        (float64) and 8e-41 (float32) beside it where a product underflows. Digits that can be lost:
        up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below
        2e-7 in float64 and 0.004 in float32 of what its error is relative to; values below 5e-304
        (float64) and 3e-34 (float32) apart; what cancels: observed - (position +
        interval*velocity).
    updated_velocity: velocity after this update, m/s. Error over the sum of its terms taken
        positive at most 3.01 * 2^-52 (float64), 3.01 * 2^-23 (float32), proved for every input, and
        3e-309 (float64) and 8e-38 (float32) beside it where a product underflows. Digits that can
        be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value
        is below 2e-7 in float64 and 0.005 in float32 of what its error is relative to; values below
        4e-294 (float64) and 2e-31 (float32) apart; what cancels: observed - (position +
        interval*velocity).

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation filter-step
    """
    if (
        type(position) is float
        and type(velocity) is float
        and type(interval) is float
        and type(observed) is float
        and type(alpha) is float
        and type(beta) is float
        and -1e40 <= position <= 1e40
        and -1e40 <= velocity <= 1e40
        and 1e-10 <= interval <= 10000000000.0
        and -1e40 <= observed <= 1e40
        and -10000.0 <= alpha <= 10000.0
        and -10000.0 <= beta <= 10000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StepTwoStates,
                _step_two_states_of_numbers(position, velocity, interval, observed, alpha, beta),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StepTwoStates(
        *evaluate(
            _STEP_TWO_STATES,
            (position, velocity, interval, observed, alpha, beta),
            out,
            workers,
        )
    )


def _step_two_states_of_numbers(
    position: float,
    velocity: float,
    interval: float,
    observed: float,
    alpha: float,
    beta: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t7 = position + (interval * velocity)
    t8 = observed - t7
    t12 = t7 + (alpha * t8)
    t13 = velocity + (beta * (t8 / interval))
    return (t12, t13)


def _step_two_states_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    position, velocity, interval, observed, alpha, beta = given
    updated_position, updated_velocity = out
    (w0,) = work
    t6 = multiply(interval, velocity, w0)
    t7 = add(position, t6, w0)
    t8 = subtract(observed, t7, updated_position)
    t9 = divide(t8, interval, updated_velocity)
    t10 = multiply(alpha, t8, updated_position)
    t11 = multiply(beta, t9, updated_velocity)
    add(t7, t10, updated_position)
    add(velocity, t11, updated_velocity)


_STEP_TWO_STATES = Signature(
    "step_two_states",
    (
        _POSITION_DOMAIN,
        _VELOCITY_DOMAIN,
        _INTERVAL_DOMAIN,
        _OBSERVED_DOMAIN,
        _ALPHA_DOMAIN,
        _BETA_DOMAIN,
    ),
    ("updated_position", "updated_velocity"),
    1,
    _step_two_states_block,
    numbers=_step_two_states_of_numbers,
)


class StepThreeStates(NamedTuple):
    """Result of `step_three_states`."""

    updated_position: Real
    """Position after this update, m."""
    updated_velocity: Real
    """Velocity after this update, m/s."""
    updated_acceleration: Real
    """Acceleration after this update, m/s^2."""


def step_three_states(
    position: ArrayLike,
    velocity: ArrayLike,
    acceleration: ArrayLike,
    interval: ArrayLike,
    observed: ArrayLike,
    alpha: ArrayLike,
    beta: ArrayLike,
    gamma: ArrayLike,
    *,
    out: tuple[Real, Real, Real] | None = None,
    workers: int = 1,
) -> StepThreeStates:
    """Prediction and update of tracks with position, velocity, acceleration.

        updated_position = p + alpha r, updated_velocity = w + beta r/t,
        updated_acceleration = acceleration + gamma r/t^2,
        p = position + t velocity + t^2 acceleration/2, w = velocity + t acceleration,
        r = observed - p

    position: position after the last update, m; of magnitude at most 1e40, in float32 1e8.
    velocity: velocity after the last update, m/s; of magnitude at most 1e40, in float32 1e8.
    acceleration: acceleration after the last update, m/s^2; of magnitude at most 1e40, in float32
        1e8.
    interval: t, time since the last update, s; a number at least 1e-10 and at most 1e10, in float32
        at least 1e-3 and at most 1e4.
    observed: z, what is observed of the position, m; of magnitude at most 1e40, in float32 1e8.
    alpha: gain of the position (0 where nothing was observed); of magnitude at most 1e4, in float32
        1e4.
    beta: gain of the velocity times t; of magnitude at most 1e4, in float32 1e4.
    gamma: gain of the acceleration times t^2; of magnitude at most 1e4, in float32 1e4.

    updated_position: position after this update, m. Error over the sum of its terms taken positive
        at most 3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32), proved for every input, and 3e-309
        (float64) and 8e-37 (float32) beside it where a product underflows. Digits that can be lost:
        up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value is below
        2e-7 in float64 and 0.006 in float32 of what its error is relative to; values below 4e-294
        (float64) and 2e-30 (float32) apart; what cancels: position + interval*(velocity +
        interval/2*acceleration) + alpha*(observed - (position + interval*(velocity +
        interval/2*acceleration))).
    updated_velocity: velocity after this update, m/s. Error over the sum of its terms taken
        positive at most 4.01 * 2^-52 (float64), 4.01 * 2^-23 (float32), proved for every input, and
        3e-299 (float64) and 8e-34 (float32) beside it where a product underflows. Digits that can
        be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value
        is below 3e-7 in float64 and 0.007 in float32 of what its error is relative to; values below
        3e-284 (float64) and 2e-27 (float32) apart; what cancels: observed - (position +
        interval*(velocity + interval/2*acceleration)).
    updated_acceleration: acceleration after this update, m/s^2. Error over the sum of its terms
        taken positive at most 4.51 * 2^-52 (float64), 4.51 * 2^-23 (float32), proved for every
        input, and 3e-289 (float64) and 8e-31 (float32) beside it where a product underflows. Digits
        that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where
        the value is below 3e-7 in float64 and 0.008 in float32 of what its error is relative to;
        values below 3e-274 (float64) and 2e-24 (float32) apart; what cancels: acceleration +
        gamma*(observed - (position + interval*(velocity +
        interval/2*acceleration)))/interval/interval.

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation filter-step
    """
    if (
        type(position) is float
        and type(velocity) is float
        and type(acceleration) is float
        and type(interval) is float
        and type(observed) is float
        and type(alpha) is float
        and type(beta) is float
        and type(gamma) is float
        and -1e40 <= position <= 1e40
        and -1e40 <= velocity <= 1e40
        and -1e40 <= acceleration <= 1e40
        and 1e-10 <= interval <= 10000000000.0
        and -1e40 <= observed <= 1e40
        and -10000.0 <= alpha <= 10000.0
        and -10000.0 <= beta <= 10000.0
        and -10000.0 <= gamma <= 10000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StepThreeStates,
                _step_three_states_of_numbers(
                    position, velocity, acceleration, interval, observed, alpha, beta, gamma
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StepThreeStates(
        *evaluate(
            _STEP_THREE_STATES,
            (position, velocity, acceleration, interval, observed, alpha, beta, gamma),
            out,
            workers,
        )
    )


def _step_three_states_of_numbers(
    position: float,
    velocity: float,
    acceleration: float,
    interval: float,
    observed: float,
    alpha: float,
    beta: float,
    gamma: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t10 = (interval * 0.5) * acceleration
    t11 = velocity + t10
    t14 = position + (interval * t11)
    t15 = observed - t14
    t16 = t15 / interval
    t21 = t14 + (alpha * t15)
    t22 = (t11 + t10) + (beta * t16)
    t23 = acceleration + (gamma * (t16 / interval))
    return (t21, t22, t23)


def _step_three_states_block(
    given: Arrays, out: Arrays, work: Arrays, _single: bool, n0: float = 0.5
) -> None:
    position, velocity, acceleration, interval, observed, alpha, beta, gamma = given
    updated_position, updated_velocity, updated_acceleration = out
    w0, w1 = work
    t9 = multiply(interval, n0, w0)
    t10 = multiply(t9, acceleration, w0)
    t11 = add(velocity, t10, updated_position)
    t12 = add(t11, t10, w0)
    t13 = multiply(interval, t11, updated_position)
    t14 = add(position, t13, updated_position)
    t15 = subtract(observed, t14, w1)
    t16 = divide(t15, interval, updated_velocity)
    t17 = divide(t16, interval, updated_acceleration)
    t18 = multiply(alpha, t15, w1)
    t19 = multiply(beta, t16, updated_velocity)
    t20 = multiply(gamma, t17, updated_acceleration)
    add(t14, t18, updated_position)
    add(t12, t19, updated_velocity)
    add(acceleration, t20, updated_acceleration)


_STEP_THREE_STATES = Signature(
    "step_three_states",
    (
        _POSITION_DOMAIN,
        _VELOCITY_DOMAIN,
        _ACCELERATION_DOMAIN,
        _INTERVAL_DOMAIN,
        _OBSERVED_DOMAIN,
        _ALPHA_DOMAIN,
        _BETA_DOMAIN,
        _GAMMA_DOMAIN,
    ),
    ("updated_position", "updated_velocity", "updated_acceleration"),
    2,
    _step_three_states_block,
    numbers=_step_three_states_of_numbers,
)


class StepInteracting(NamedTuple):
    """Result of `step_interacting`."""

    updated_x_position: Real
    """Position along x after this update, m."""
    updated_y_position: Real
    """Position along y after this update, m."""
    updated_z_position: Real
    """Position along z after this update, m."""
    updated_x_velocity: Real
    """Velocity along x after this update, m/s."""
    updated_y_velocity: Real
    """Velocity along y after this update, m/s."""
    updated_z_velocity: Real
    """Velocity along z after this update, m/s."""


def step_interacting(
    x_position: ArrayLike,
    y_position: ArrayLike,
    z_position: ArrayLike,
    x_velocity: ArrayLike,
    y_velocity: ArrayLike,
    z_velocity: ArrayLike,
    interval: ArrayLike,
    x_observed: ArrayLike,
    y_observed: ArrayLike,
    z_observed: ArrayLike,
    position_gain_11: ArrayLike,
    position_gain_12: ArrayLike,
    position_gain_13: ArrayLike,
    position_gain_21: ArrayLike,
    position_gain_22: ArrayLike,
    position_gain_23: ArrayLike,
    position_gain_31: ArrayLike,
    position_gain_32: ArrayLike,
    position_gain_33: ArrayLike,
    velocity_gain_11: ArrayLike,
    velocity_gain_12: ArrayLike,
    velocity_gain_13: ArrayLike,
    velocity_gain_21: ArrayLike,
    velocity_gain_22: ArrayLike,
    velocity_gain_23: ArrayLike,
    velocity_gain_31: ArrayLike,
    velocity_gain_32: ArrayLike,
    velocity_gain_33: ArrayLike,
    *,
    out: tuple[Real, Real, Real, Real, Real, Real] | None = None,
    workers: int = 1,
) -> StepInteracting:
    """Prediction and update of tracks in three coordinates that interact.

        updated positions = p + K1 r, updated velocities = velocities + K2 r,
        p = positions + t velocities, r = observed - p

    x_position: position along x after the last update, m; of magnitude at most 1e40, in float32
        1e8.
    y_position: position along y after the last update, m; of magnitude at most 1e40, in float32
        1e8.
    z_position: position along z after the last update, m; of magnitude at most 1e40, in float32
        1e8.
    x_velocity: velocity along x after the last update, m/s; of magnitude at most 1e40, in float32
        1e8.
    y_velocity: velocity along y after the last update, m/s; of magnitude at most 1e40, in float32
        1e8.
    z_velocity: velocity along z after the last update, m/s; of magnitude at most 1e40, in float32
        1e8.
    interval: t, time since the last update, s; a number at least 1e-10 and at most 1e10, in float32
        at least 1e-3 and at most 1e4.
    x_observed: what is observed of the position along x, m; of magnitude at most 1e40, in float32
        1e8.
    y_observed: what is observed of the position along y, m; of magnitude at most 1e40, in float32
        1e8.
    z_observed: what is observed of the position along z, m; of magnitude at most 1e40, in float32
        1e8.
    position_gain_11: entry 11 of K1, dimensionless; of magnitude at most 1e4, in float32 1e4.
    position_gain_12: entry 12 of K1, dimensionless; of magnitude at most 1e4, in float32 1e4.
    position_gain_13: entry 13 of K1, dimensionless; of magnitude at most 1e4, in float32 1e4.
    position_gain_21: entry 21 of K1, dimensionless; of magnitude at most 1e4, in float32 1e4.
    position_gain_22: entry 22 of K1, dimensionless; of magnitude at most 1e4, in float32 1e4.
    position_gain_23: entry 23 of K1, dimensionless; of magnitude at most 1e4, in float32 1e4.
    position_gain_31: entry 31 of K1, dimensionless; of magnitude at most 1e4, in float32 1e4.
    position_gain_32: entry 32 of K1, dimensionless; of magnitude at most 1e4, in float32 1e4.
    position_gain_33: entry 33 of K1, dimensionless; of magnitude at most 1e4, in float32 1e4.
    velocity_gain_11: entry 11 of K2, 1/s; of magnitude at most 1e14, in float32 1e7.
    velocity_gain_12: entry 12 of K2, 1/s; of magnitude at most 1e14, in float32 1e7.
    velocity_gain_13: entry 13 of K2, 1/s; of magnitude at most 1e14, in float32 1e7.
    velocity_gain_21: entry 21 of K2, 1/s; of magnitude at most 1e14, in float32 1e7.
    velocity_gain_22: entry 22 of K2, 1/s; of magnitude at most 1e14, in float32 1e7.
    velocity_gain_23: entry 23 of K2, 1/s; of magnitude at most 1e14, in float32 1e7.
    velocity_gain_31: entry 31 of K2, 1/s; of magnitude at most 1e14, in float32 1e7.
    velocity_gain_32: entry 32 of K2, 1/s; of magnitude at most 1e14, in float32 1e7.
    velocity_gain_33: entry 33 of K2, 1/s; of magnitude at most 1e14, in float32 1e7.

    updated_x_position: position along x after this update, m. Error over the sum of its terms taken
        positive at most 3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32), proved for every input, and
        8e-319 (float64) and 3e-40 (float32) beside it where a product underflows. Digits that can
        be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value
        is below 2e-7 in float64 and 0.006 in float32 of what its error is relative to; values below
        1e-303 (float64) and 6e-34 (float32) apart; what cancels: x_position + interval*x_velocity +
        position_gain_11*(x_observed - (x_position + interval*x_velocity)) +
        position_gain_12*(y_observed - (y_position + interval*y_velocity)) +
        position_gain_13*(z_observed - (z_position + interval*z_velocity)).
    updated_y_position: position along y after this update, m. Error over the sum of its terms taken
        positive at most 3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32), proved for every input, and
        8e-319 (float64) and 3e-40 (float32) beside it where a product underflows. Digits that can
        be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value
        is below 2e-7 in float64 and 0.006 in float32 of what its error is relative to; values below
        1e-303 (float64) and 6e-34 (float32) apart; what cancels: y_position + interval*y_velocity +
        position_gain_21*(x_observed - (x_position + interval*x_velocity)) +
        position_gain_22*(y_observed - (y_position + interval*y_velocity)) +
        position_gain_23*(z_observed - (z_position + interval*z_velocity)).
    updated_z_position: position along z after this update, m. Error over the sum of its terms taken
        positive at most 3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32), proved for every input, and
        8e-319 (float64) and 3e-40 (float32) beside it where a product underflows. Digits that can
        be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where the value
        is below 2e-7 in float64 and 0.006 in float32 of what its error is relative to; values below
        1e-303 (float64) and 6e-34 (float32) apart; what cancels: z_position + interval*z_velocity +
        position_gain_31*(x_observed - (x_position + interval*x_velocity)) +
        position_gain_32*(y_observed - (y_position + interval*y_velocity)) +
        position_gain_33*(z_observed - (z_position + interval*z_velocity)).
    updated_x_velocity: velocity along x after this update, m/s. Error over the sum of its terms
        taken positive at most 3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32), proved for every
        input, and 8e-309 (float64) and 3e-37 (float32) beside it where a product underflows. Digits
        that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where
        the value is below 2e-7 in float64 and 0.006 in float32 of what its error is relative to;
        values below 1e-293 (float64) and 6e-31 (float32) apart; what cancels: x_velocity +
        velocity_gain_11*(x_observed - (x_position + interval*x_velocity)) +
        velocity_gain_12*(y_observed - (y_position + interval*y_velocity)) +
        velocity_gain_13*(z_observed - (z_position + interval*z_velocity)).
    updated_y_velocity: velocity along y after this update, m/s. Error over the sum of its terms
        taken positive at most 3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32), proved for every
        input, and 8e-309 (float64) and 3e-37 (float32) beside it where a product underflows. Digits
        that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where
        the value is below 2e-7 in float64 and 0.006 in float32 of what its error is relative to;
        values below 1e-293 (float64) and 6e-31 (float32) apart; what cancels: z_observed -
        (z_position + interval*z_velocity).
    updated_z_velocity: velocity along z after this update, m/s. Error over the sum of its terms
        taken positive at most 3.51 * 2^-52 (float64), 3.51 * 2^-23 (float32), proved for every
        input, and 8e-309 (float64) and 3e-37 (float32) beside it where a product underflows. Digits
        that can be lost: up to 16 of 16 in float64 and 7 of 7 in float32; half or more only where
        the value is below 2e-7 in float64 and 0.006 in float32 of what its error is relative to;
        values below 1e-293 (float64) and 6e-31 (float32) apart; what cancels: z_velocity +
        velocity_gain_31*(x_observed - (x_position + interval*x_velocity)) +
        velocity_gain_32*(y_observed - (y_position + interval*y_velocity)) +
        velocity_gain_33*(z_observed - (z_position + interval*z_velocity)).

    Numbers and arrays are taken, arrays of any shapes that broadcast. Where all inputs are float32
    so are the results; otherwise everything becomes float64, integers too. `out`: a tuple of arrays
    to fill. `workers`: threads that share the work on long arrays.

    ValueError: an input outside its domain, with its place; `out` or `workers` that does not fit.
    TypeError: an input that is no real number of these types; in `out` what is no array of the
    results' type.

    Source: derivation filter-step
    """
    if (
        type(x_position) is float
        and type(y_position) is float
        and type(z_position) is float
        and type(x_velocity) is float
        and type(y_velocity) is float
        and type(z_velocity) is float
        and type(interval) is float
        and type(x_observed) is float
        and type(y_observed) is float
        and type(z_observed) is float
        and type(position_gain_11) is float
        and type(position_gain_12) is float
        and type(position_gain_13) is float
        and type(position_gain_21) is float
        and type(position_gain_22) is float
        and type(position_gain_23) is float
        and type(position_gain_31) is float
        and type(position_gain_32) is float
        and type(position_gain_33) is float
        and type(velocity_gain_11) is float
        and type(velocity_gain_12) is float
        and type(velocity_gain_13) is float
        and type(velocity_gain_21) is float
        and type(velocity_gain_22) is float
        and type(velocity_gain_23) is float
        and type(velocity_gain_31) is float
        and type(velocity_gain_32) is float
        and type(velocity_gain_33) is float
        and -1e40 <= x_position <= 1e40
        and -1e40 <= y_position <= 1e40
        and -1e40 <= z_position <= 1e40
        and -1e40 <= x_velocity <= 1e40
        and -1e40 <= y_velocity <= 1e40
        and -1e40 <= z_velocity <= 1e40
        and 1e-10 <= interval <= 10000000000.0
        and -1e40 <= x_observed <= 1e40
        and -1e40 <= y_observed <= 1e40
        and -1e40 <= z_observed <= 1e40
        and -10000.0 <= position_gain_11 <= 10000.0
        and -10000.0 <= position_gain_12 <= 10000.0
        and -10000.0 <= position_gain_13 <= 10000.0
        and -10000.0 <= position_gain_21 <= 10000.0
        and -10000.0 <= position_gain_22 <= 10000.0
        and -10000.0 <= position_gain_23 <= 10000.0
        and -10000.0 <= position_gain_31 <= 10000.0
        and -10000.0 <= position_gain_32 <= 10000.0
        and -10000.0 <= position_gain_33 <= 10000.0
        and -100000000000000.0 <= velocity_gain_11 <= 100000000000000.0
        and -100000000000000.0 <= velocity_gain_12 <= 100000000000000.0
        and -100000000000000.0 <= velocity_gain_13 <= 100000000000000.0
        and -100000000000000.0 <= velocity_gain_21 <= 100000000000000.0
        and -100000000000000.0 <= velocity_gain_22 <= 100000000000000.0
        and -100000000000000.0 <= velocity_gain_23 <= 100000000000000.0
        and -100000000000000.0 <= velocity_gain_31 <= 100000000000000.0
        and -100000000000000.0 <= velocity_gain_32 <= 100000000000000.0
        and -100000000000000.0 <= velocity_gain_33 <= 100000000000000.0
        and out is None
        and workers is ONE
    ):
        try:
            return named(
                StepInteracting,
                _step_interacting_of_numbers(
                    x_position,
                    y_position,
                    z_position,
                    x_velocity,
                    y_velocity,
                    z_velocity,
                    interval,
                    x_observed,
                    y_observed,
                    z_observed,
                    position_gain_11,
                    position_gain_12,
                    position_gain_13,
                    position_gain_21,
                    position_gain_22,
                    position_gain_23,
                    position_gain_31,
                    position_gain_32,
                    position_gain_33,
                    velocity_gain_11,
                    velocity_gain_12,
                    velocity_gain_13,
                    velocity_gain_21,
                    velocity_gain_22,
                    velocity_gain_23,
                    velocity_gain_31,
                    velocity_gain_32,
                    velocity_gain_33,
                ),
            )
        except (ArithmeticError, ValueError):
            pass  # arrays say what is wrong
    return StepInteracting(
        *evaluate(
            _STEP_INTERACTING,
            (
                x_position,
                y_position,
                z_position,
                x_velocity,
                y_velocity,
                z_velocity,
                interval,
                x_observed,
                y_observed,
                z_observed,
                position_gain_11,
                position_gain_12,
                position_gain_13,
                position_gain_21,
                position_gain_22,
                position_gain_23,
                position_gain_31,
                position_gain_32,
                position_gain_33,
                velocity_gain_11,
                velocity_gain_12,
                velocity_gain_13,
                velocity_gain_21,
                velocity_gain_22,
                velocity_gain_23,
                velocity_gain_31,
                velocity_gain_32,
                velocity_gain_33,
            ),
            out,
            workers,
        )
    )


def _step_interacting_of_numbers(
    x_position: float,
    y_position: float,
    z_position: float,
    x_velocity: float,
    y_velocity: float,
    z_velocity: float,
    interval: float,
    x_observed: float,
    y_observed: float,
    z_observed: float,
    position_gain_11: float,
    position_gain_12: float,
    position_gain_13: float,
    position_gain_21: float,
    position_gain_22: float,
    position_gain_23: float,
    position_gain_31: float,
    position_gain_32: float,
    position_gain_33: float,
    velocity_gain_11: float,
    velocity_gain_12: float,
    velocity_gain_13: float,
    velocity_gain_21: float,
    velocity_gain_22: float,
    velocity_gain_23: float,
    velocity_gain_31: float,
    velocity_gain_32: float,
    velocity_gain_33: float,
    _form: Form = Double,
) -> tuple[float, ...]:
    t29 = x_position + (interval * x_velocity)
    t31 = y_position + (interval * y_velocity)
    t33 = z_position + (interval * z_velocity)
    t34 = x_observed - t29
    t35 = y_observed - t31
    t36 = z_observed - t33
    t39 = (position_gain_11 * t34) + (position_gain_12 * t35)
    t45 = (position_gain_21 * t34) + (position_gain_22 * t35)
    t51 = (position_gain_31 * t34) + (position_gain_32 * t35)
    t57 = (velocity_gain_11 * t34) + (velocity_gain_12 * t35)
    t63 = (velocity_gain_21 * t34) + (velocity_gain_22 * t35)
    t69 = (velocity_gain_31 * t34) + (velocity_gain_32 * t35)
    t42 = t29 + (t39 + (position_gain_13 * t36))
    t48 = t31 + (t45 + (position_gain_23 * t36))
    t54 = t33 + (t51 + (position_gain_33 * t36))
    t60 = x_velocity + (t57 + (velocity_gain_13 * t36))
    t66 = y_velocity + (t63 + (velocity_gain_23 * t36))
    t72 = z_velocity + (t69 + (velocity_gain_33 * t36))
    return (t42, t48, t54, t60, t66, t72)


def _step_interacting_block(given: Arrays, out: Arrays, work: Arrays, _single: bool) -> None:
    (
        x_position,
        y_position,
        z_position,
        x_velocity,
        y_velocity,
        z_velocity,
        interval,
        x_observed,
        y_observed,
        z_observed,
        position_gain_11,
        position_gain_12,
        position_gain_13,
        position_gain_21,
        position_gain_22,
        position_gain_23,
        position_gain_31,
        position_gain_32,
        position_gain_33,
        velocity_gain_11,
        velocity_gain_12,
        velocity_gain_13,
        velocity_gain_21,
        velocity_gain_22,
        velocity_gain_23,
        velocity_gain_31,
        velocity_gain_32,
        velocity_gain_33,
    ) = given
    (
        updated_x_position,
        updated_y_position,
        updated_z_position,
        updated_x_velocity,
        updated_y_velocity,
        updated_z_velocity,
    ) = out
    w0, w1, w2, w3, w4, w5, w6, w7, w8, w9, w10, w11 = work
    t28 = multiply(interval, x_velocity, w0)
    t29 = add(x_position, t28, w0)
    t30 = multiply(interval, y_velocity, w1)
    t31 = add(y_position, t30, w1)
    t32 = multiply(interval, z_velocity, w2)
    t33 = add(z_position, t32, w2)
    t34 = subtract(x_observed, t29, w3)
    t35 = subtract(y_observed, t31, w4)
    t36 = subtract(z_observed, t33, w5)
    t37 = multiply(position_gain_11, t34, w6)
    t38 = multiply(position_gain_12, t35, w7)
    t39 = add(t37, t38, w6)
    t40 = multiply(position_gain_13, t36, w7)
    t41 = add(t39, t40, w6)
    t43 = multiply(position_gain_21, t34, w7)
    t44 = multiply(position_gain_22, t35, w8)
    t45 = add(t43, t44, w7)
    t46 = multiply(position_gain_23, t36, w8)
    t47 = add(t45, t46, w7)
    t49 = multiply(position_gain_31, t34, w8)
    t50 = multiply(position_gain_32, t35, w9)
    t51 = add(t49, t50, w8)
    t52 = multiply(position_gain_33, t36, w9)
    t53 = add(t51, t52, w8)
    t55 = multiply(velocity_gain_11, t34, w9)
    t56 = multiply(velocity_gain_12, t35, w10)
    t57 = add(t55, t56, w9)
    t58 = multiply(velocity_gain_13, t36, w10)
    t59 = add(t57, t58, w9)
    t61 = multiply(velocity_gain_21, t34, w10)
    t62 = multiply(velocity_gain_22, t35, w11)
    t63 = add(t61, t62, w10)
    t64 = multiply(velocity_gain_23, t36, w11)
    t65 = add(t63, t64, w10)
    t67 = multiply(velocity_gain_31, t34, w3)
    t68 = multiply(velocity_gain_32, t35, w4)
    t69 = add(t67, t68, w3)
    t70 = multiply(velocity_gain_33, t36, w5)
    t71 = add(t69, t70, w3)
    add(t29, t41, updated_x_position)
    add(t31, t47, updated_y_position)
    add(t33, t53, updated_z_position)
    add(x_velocity, t59, updated_x_velocity)
    add(y_velocity, t65, updated_y_velocity)
    add(z_velocity, t71, updated_z_velocity)


_STEP_INTERACTING = Signature(
    "step_interacting",
    (
        _X_POSITION_DOMAIN,
        _Y_POSITION_DOMAIN,
        _Z_POSITION_DOMAIN,
        _X_VELOCITY_DOMAIN,
        _Y_VELOCITY_DOMAIN,
        _Z_VELOCITY_DOMAIN,
        _INTERVAL_DOMAIN,
        _X_OBSERVED_DOMAIN,
        _Y_OBSERVED_DOMAIN,
        _Z_OBSERVED_DOMAIN,
        _POSITION_GAIN_11_DOMAIN,
        _POSITION_GAIN_12_DOMAIN,
        _POSITION_GAIN_13_DOMAIN,
        _POSITION_GAIN_21_DOMAIN,
        _POSITION_GAIN_22_DOMAIN,
        _POSITION_GAIN_23_DOMAIN,
        _POSITION_GAIN_31_DOMAIN,
        _POSITION_GAIN_32_DOMAIN,
        _POSITION_GAIN_33_DOMAIN,
        _VELOCITY_GAIN_11_DOMAIN,
        _VELOCITY_GAIN_12_DOMAIN,
        _VELOCITY_GAIN_13_DOMAIN,
        _VELOCITY_GAIN_21_DOMAIN,
        _VELOCITY_GAIN_22_DOMAIN,
        _VELOCITY_GAIN_23_DOMAIN,
        _VELOCITY_GAIN_31_DOMAIN,
        _VELOCITY_GAIN_32_DOMAIN,
        _VELOCITY_GAIN_33_DOMAIN,
    ),
    (
        "updated_x_position",
        "updated_y_position",
        "updated_z_position",
        "updated_x_velocity",
        "updated_y_velocity",
        "updated_z_velocity",
    ),
    12,
    _step_interacting_block,
    numbers=_step_interacting_of_numbers,
)
