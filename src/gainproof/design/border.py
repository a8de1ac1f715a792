"""The variance of random acceleration at a tracking index, next to the border where gains lose it.

As the index grows alpha goes to 1, beta to 2 and of three states gamma to 2, and 4 - 2 alpha -
beta, which is 4 sqrt(1 - alpha), to 0: of rounded gains nothing is left of it. The index tells it:
over beta, of three states over gamma, it is 4/index (steps random-acceleration-index of the
derivations alpha-beta and alpha-beta-gamma). The other coordinates keep their digits.
"""

from __future__ import annotations

import numpy as np

from gainproof.design.named_filter import Reals
from gainproof.fixed_gain import three_states as three
from gainproof.fixed_gain import two_states as two
from gainproof.fixed_gain.kernel_reach import gap
from gainproof.generated import (
    acceleration_increments,
    alpha_beta,
    alpha_beta_gamma,
    random_acceleration,
)

LARGE = 1.0
"""From this index on; below, the gains are far from the border."""
LARGEST = 8e20
"""The end of the coordinates' kernel of three states."""


def two_states(index: Reals) -> Reals:
    """Variance of the predicted position over B, of tracking indices."""
    given = np.asarray(index)
    large = np.maximum(given, LARGE)
    alpha, beta = random_acceleration.gains(large)
    near = alpha_beta.variances_of_coordinates(2 * (alpha / beta), 4 / large).predicted_11
    far = two.variances(*random_acceleration.gains(np.minimum(given, LARGE))).predicted_11
    return np.where(given < LARGE, far, near)


def three_states(index: Reals) -> Reals:
    """The same of three states; ValueError for an index beyond 8e20."""
    given = np.asarray(index)
    if np.any(given > LARGEST):
        raise ValueError(f"variances are computed up to an index of 8e20, got {np.max(given)!s}")
    large = np.maximum(given, LARGE)
    _, beta, gamma = gains = tuple(
        np.asarray(gain, np.float64) for gain in acceleration_increments.gains(large)
    )
    hurwitz = 8 * gap(three.DETERMINANT, gains) / (gamma * gamma)
    near = alpha_beta_gamma.variances_of_coordinates(2 * (beta / gamma), 8 / large, hurwitz)
    far = three.variances(*acceleration_increments.gains(np.minimum(given, LARGE)))
    return np.where(given < LARGE, far.predicted_11, near.predicted_11)
