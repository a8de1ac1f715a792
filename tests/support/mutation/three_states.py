"""Quantities of a three-state filter that derivations name, from its gains and its motion.

z = (1 + s)/(1 - s) takes the unit circle to the line of imaginary s: the closed loop's polynomial
over its value at z = 1, times (1 - s)^3, is 1 + xi s + eta s^2 + delta s^3. Its coefficients come
from F (I - K H) by traces and minors; no relation between the names is used.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import mpmath

NAMES = ("xi", "eta", "delta", "nu", "tau", "rest", "w", "predictor_velocity")
"""Beside the gains, covariances, index and innovation's deviation."""


def of_three_states(motion: Sequence[Sequence[Any]], gain: Sequence[Any]) -> Mapping[str, Any]:
    """Every quantity of `NAMES`, in the precision that is set."""
    rest = [[mpmath.mpf(i == j) - (gain[i] if j == 0 else 0) for j in range(3)] for i in range(3)]
    loop = [
        [mpmath.fsum(motion[i][k] * rest[k][j] for k in range(3)) for j in range(3)]
        for i in range(3)
    ]
    # z^3 - first z^2 + second z - third
    first = mpmath.fsum(loop[i][i] for i in range(3))
    second = mpmath.fsum(
        loop[i][i] * loop[j][j] - loop[i][j] * loop[j][i] for i in range(3) for j in range(i)
    )
    third = mpmath.det(mpmath.matrix(loop))
    at_one = 1 - first + second - third
    xi = (3 - first - second + 3 * third) / at_one
    eta = (3 + first - second - 3 * third) / at_one
    delta = (1 + first + second + third) / at_one
    return {
        "xi": xi,
        "eta": eta,
        "delta": delta,
        "nu": 1 + xi + eta + delta,
        "tau": eta * xi - delta,
        "rest": 1 - gain[0],
        "w": mpmath.sqrt(1 - gain[0]),
        "predictor_velocity": mpmath.fsum(f * k for f, k in zip(motion[1], gain, strict=True)),
    }
