"""Every named filter: a line of a tuple each, with the kernels that give its gains.

A filter is known by its name among those of as many states. A new one is a `NamedFilter` more in
`NAMED`; the table, the data, the plot and the pages show it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gainproof.design.named_filter import (
    Gains,
    NamedFilter,
    Reals,
    as_one,
    first_outputs,
    inverse,
    only,
    output,
    with_alpha,
)
from gainproof.fixed_gain import three_states as three
from gainproof.fixed_gain import two_states as two
from gainproof.fixed_gain.kernel_reach import gap
from gainproof.generated import (
    acceleration_increments,
    alpha_beta,
    alpha_beta_gamma,
    random_acceleration,
    random_jerk,
    random_velocity,
)

# As the index grows alpha goes to 1, beta to 2 and of three states gamma to 2, and 4 - 2 alpha -
# beta, which is 4 sqrt(1 - alpha), to 0: of rounded gains nothing is left of it. The index tells
# it: over beta, of three states over gamma, it is 4/index (steps random-acceleration-index of the
# derivations alpha-beta and alpha-beta-gamma). The other coordinates keep their digits.
_LARGE = 1.0
"""From this index on; below, the gains are far from the border."""
_LARGEST = 8e20
"""The end of the coordinates' kernel of three states."""


def _variance_by_index_of_two(index: Reals) -> Reals:
    """Variance of the predicted position over B under random acceleration, of tracking indices,
    next to the border too where gains lose it.
    """
    given = np.asarray(index)
    large = np.maximum(given, _LARGE)
    alpha, beta = random_acceleration.gains(large)
    near = alpha_beta.variances_of_coordinates(2 * (alpha / beta), 4 / large).predicted_11
    far = two.variances(*random_acceleration.gains(np.minimum(given, _LARGE))).predicted_11
    return np.where(given < _LARGE, far, near)


def _variance_by_index_of_three(index: Reals) -> Reals:
    """The same of three states; ValueError for an index beyond 8e20."""
    given = np.asarray(index)
    if np.any(given > _LARGEST):
        raise ValueError(f"variances are computed up to an index of 8e20, got {np.max(given)!s}")
    large = np.maximum(given, _LARGE)
    _, beta, gamma = gains = tuple(
        np.asarray(gain, np.float64) for gain in acceleration_increments.gains(large)
    )
    hurwitz = 8 * gap(three.DETERMINANT, gains) / (gamma * gamma)
    near = alpha_beta_gamma.variances_of_coordinates(2 * (beta / gamma), 8 / large, hurwitz)
    far = three.variances(*acceleration_increments.gains(np.minimum(given, _LARGE)))
    return np.where(given < _LARGE, far.predicted_11, near.predicted_11)


def _both_minima(alpha: Reals) -> Sequence[Gains]:
    """The slow and the fast minimum variance filter; at alpha = 1/2 they are one, of beta 1."""
    given = np.asarray(alpha)
    double = given == 0.5
    if double.all():
        return ((given, np.ones(given.shape)),)
    # the kernel ends below 1/2: there another number takes its place
    found = alpha_beta.minimum_variance_by_gain(np.where(double, 0.25, given))
    both = found.slow_minimum_variance_beta, found.fast_minimum_variance_beta
    return tuple((given, np.where(double, 1.0, beta)) for beta in both)


def _variances_of_both(alpha: Reals) -> Sequence[Reals]:
    """Of `_both_minima`; at alpha = 1/2 that of lag 1."""
    given = np.asarray(alpha)
    double = given == 0.5
    middle = alpha_beta.minimum_variance_by_lag(1.0).minimum_variance_predicted_11
    if double.all():
        return (np.full(given.shape, middle),)
    found = alpha_beta.minimum_variance_by_gain(np.where(double, 0.25, given))
    both = found.slow_minimum_variance_predicted_11, found.fast_minimum_variance_predicted_11
    return tuple(np.where(double, middle, each) for each in both)


_least = first_outputs(alpha_beta_gamma.minimum_variance_by_lag, 3)
NAMED: tuple[NamedFilter, ...] = (
    NamedFilter(
        "RV",
        "random velocity",
        2,
        first_outputs(alpha_beta.random_velocity_by_lag, 2),
        with_alpha(alpha_beta.random_velocity_by_gain, 1),
        first_outputs(random_velocity.gains, 2),
        ((1 + 2**0.5) / 4, "(1 + sqrt(2))/4 = 0.6036"),
        "faster ones are not stable",
        (1.0, "1"),
        "steady states of a Kalman filter have no other",
        "random-velocity",
        variance_by_lag=output(alpha_beta.random_velocity_by_lag, 2),
        variances_by_alpha=only(output(alpha_beta.random_velocity_by_gain, 1)),
        reach=alpha_beta._RANDOM_VELOCITY_BY_LAG.inputs[0].double,
        kalman_above=1.0,
    ),
    NamedFilter(
        "RA",
        "random acceleration",
        2,
        first_outputs(alpha_beta.random_acceleration_by_lag, 2),
        with_alpha(alpha_beta.random_acceleration_by_gain, 1),
        first_outputs(random_acceleration.gains, 2),
        (0.5, "1/2"),
        "there alpha is 1, on the border of stability",
        (1.0, "1"),
        "with alpha = 1 it is not stable",
        "random-acceleration",
        variance_by_lag=output(alpha_beta.random_acceleration_by_lag, 2),
        variances_by_alpha=only(output(alpha_beta.random_acceleration_by_gain, 1)),
        variance_by_index=_variance_by_index_of_two,
        reach=alpha_beta._RANDOM_ACCELERATION_BY_LAG.inputs[0].double,
    ),
    NamedFilter(
        "MV",
        "minimum variance, also NP-P",
        2,
        first_outputs(alpha_beta.minimum_variance_by_lag, 2),
        _both_minima,
        None,
        (0.25, "1/4"),
        "there beta is 4, on the border of stability",
        (0.5, "1/2"),
        "alpha = sqrt(beta) - beta/2 is never more",
        closed=True,
        variance_by_lag=output(alpha_beta.minimum_variance_by_lag, 2),
        variances_by_alpha=_variances_of_both,
        reach=alpha_beta._MINIMUM_VARIANCE_BY_LAG.inputs[0].double,
    ),
    NamedFilter(
        "NP-S",
        "minimum smoothed variance",
        2,
        first_outputs(alpha_beta.minimum_smoothed_variance_by_lag, 2),
        with_alpha(alpha_beta.minimum_smoothed_variance_by_gain, 1),
        None,
        (0.5, "1/2"),
        "from there on none smooths better than a single measurement",
        (1.0, "1"),
        "from there on none smooths better than a single measurement",
        variance_by_lag=output(alpha_beta.minimum_smoothed_variance_by_lag, 2),
        variances_by_alpha=only(output(alpha_beta.minimum_smoothed_variance_by_gain, 1)),
        reach=alpha_beta._MINIMUM_SMOOTHED_VARIANCE_BY_LAG.inputs[0].double,
    ),
    NamedFilter(
        "RA",
        "random acceleration",
        3,
        first_outputs(alpha_beta_gamma.random_acceleration_by_lag, 3),
        with_alpha(alpha_beta_gamma.random_acceleration_by_gain, 2),
        first_outputs(acceleration_increments.gains, 3),
        (0.5, "1/2"),
        "there alpha is 1, on the border of stability",
        (1.0, "1"),
        "with alpha = 1 it is not stable",
        "acceleration-increments",
        variance_by_lag=output(alpha_beta_gamma.random_acceleration_by_lag, 3),
        variances_by_alpha=only(output(alpha_beta_gamma.random_acceleration_by_gain, 2)),
        variance_by_index=_variance_by_index_of_three,
        reach=alpha_beta_gamma._RANDOM_ACCELERATION_BY_LAG.inputs[0].double,
    ),
    NamedFilter(
        "RJ",
        "random jerk",
        3,
        first_outputs(alpha_beta_gamma.random_jerk_by_lag, 3),
        with_alpha(alpha_beta_gamma.random_jerk_by_gain, 2),
        first_outputs(random_jerk.gains, 3),
        ((2 + 3**0.5) / 6, "(2 + sqrt(3))/6 = 0.622"),
        "there the tracking index is infinite",
        (1.0, "1"),
        "there the tracking index is infinite",
        "random-jerk",
        variances_by_alpha=only(output(alpha_beta_gamma.random_jerk_by_gain, 2)),
        reach=alpha_beta_gamma._RANDOM_JERK_BY_LAG.inputs[0].double,
    ),
    NamedFilter(
        "MV",
        "minimum variance",
        3,
        _least,
        as_one(inverse(_least, 0, 0.1251, 1e30)),
        None,
        (0.125, "1/8"),
        "there gamma is 8, on the border of stability",
        (2.0, "2"),
        "there gamma is 8, on the border of stability",
        variance_by_lag=output(alpha_beta_gamma.minimum_variance_by_lag, 3),
        reach=alpha_beta_gamma._MINIMUM_VARIANCE_BY_LAG.inputs[0].double,
    ),
)


def named_filters(states: int) -> tuple[NamedFilter, ...]:
    """Those of two or of three states."""
    return tuple(each for each in NAMED if each.states == states)
