"""Position and velocity both measured: the model as numbers, its steady state under names.

Independent because it holds matrices and nothing else: the numbers come from the general oracles
(``doubling``, ``recursion``, ``solver``), which take any number of measured quantities and know
no closed form. In units in which the sampling interval and the deviation of the measured
position are one,

    F = [[1, 1], [0, 1]], H = I, R = diag(1, S^2), Q = Lambda^2 Q0,

with S the velocity ratio (deviation of the measured velocity times T over that of the measured
position), Lambda the tracking index, and Q0 the process noise for index one.

The limits S to 0 and to infinity are reached by values of S so far out that what is left is
below the digits asked for; two such values and an extrapolation are compared, so that no formula
of a limit is needed. For S to infinity the filter with measured position alone is another model
with another measurement matrix: a second, separate way.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gainproof.verify.oracles import doubling
from gainproof.verify.oracles.multiprecision import bits_for, carried, context
from gainproof.verify.oracles.state_space import (
    Index,
    NotConverged,
    StateSpace,
    SteadyState,
    exact,
    state_space,
)

Noise = Sequence[Sequence[object]]
ZERO, ONE = Fraction(0), Fraction(1)
TRANSITION = ((ONE, ONE), (ZERO, ONE))
COVARIANCE = ("11", "12", "22")
GAIN = ("11", "12", "21", "22")


def model(noise: Noise, tracking_index: Index, velocity_ratio: Index) -> StateSpace:
    """The model with both quantities measured; ``noise`` is Q0, rows of numbers or number texts.

    Numbers are taken exactly. Raises ValueError unless both parameters are positive and finite.
    """
    ratio = exact(velocity_ratio)
    if ratio <= 0:
        raise ValueError(f"the velocity ratio must be positive, got {velocity_ratio!r}")
    data = {
        "transition": TRANSITION,
        "process_noise": noise,
        "measurement": ((ONE, ZERO), (ZERO, ONE)),
        "measurement_noise": ((ONE, ZERO), (ZERO, ratio * ratio)),
    }
    return state_space(data, tracking_index)


def position_only(noise: Noise, tracking_index: Index) -> StateSpace:
    """The model with measured position alone: what is left as the velocity ratio grows."""
    data = {
        "transition": TRANSITION,
        "process_noise": noise,
        "measurement": ((ONE, ZERO),),
        "measurement_noise": ((ONE,),),
    }
    return state_space(data, tracking_index)


def named(state: SteadyState) -> Mapping[str, Any]:
    """Covariances as ``predicted_ij``, ``updated_ij`` (i <= j), gains as ``gain_ij``, from 1."""
    found: dict[str, Any] = {}
    for kind, rows in (("predicted", state.predicted), ("updated", state.updated)):
        found |= {f"{kind}_{place}": rows[int(place[0]) - 1][int(place[1]) - 1]
                  for place in COVARIANCE}  # fmt: skip
    columns = len(state.gain[0])
    for place in GAIN:
        if int(place[1]) <= columns:
            found[f"gain_{place}"] = state.gain[int(place[0]) - 1][int(place[1]) - 1]
    return found


@dataclass(frozen=True)
class Limit:
    """A limit in multiprecision and how far its two computations lie apart, relative to it."""

    value: Any
    apart: float


def limit(noise: Noise, tracking_index: Index, name: str, side: str, digits: int = 40) -> Limit:
    """The limit of a named entry as S goes to ``side`` ("zero" or "infinity").

    Near either end an entry of a covariance is a power series in S or 1/S, so that its value at
    S = 10^-k is off by a factor 1 + O(10^-k) as long as the limit is not 0. Values at k and k + 5
    are compared; k leaves ``digits`` digits and room for constants that grow with the index.
    Raises NotConverged when the two disagree, as they do where the limit is 0 or infinite.
    """
    index = exact(tracking_index)
    room = len(str(int(max(index, 1 / index))))
    far = digits + 4 * room
    sign = {"zero": -1, "infinity": 1}[side]
    values = []
    for power in (far, far + 5):
        ratio = Fraction(10) ** (sign * power)
        # enough digits for a closed loop that comes as close to the unit circle as S^2 to 0
        state = doubling.steady_state(model(noise, index, ratio), 2 * power + 10).state
        values.append(named(state)[name])
    own = context(bits_for(digits) + 60)
    near, farther = (carried(value, own) for value in values)
    apart = abs(near - farther) / abs(farther)
    if apart > own.mpf(10) ** -digits:
        raise NotConverged(f"{name} has no limit other than 0 as S goes to {side}: {apart}")
    return Limit(farther, float(apart))
