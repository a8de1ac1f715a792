"""The velocity accuracy that a wanted position accuracy needs, in dimensionless form."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gainproof.position_velocity.arguments import positive, require
from gainproof.position_velocity.bracketing import Places, Point, Reals, increasing_root
from gainproof.position_velocity.process_noise import DEFAULT
from gainproof.position_velocity.reach import Limits, require_reachable
from gainproof.position_velocity.variance import Variance, position_variance

# of the computed residual: two units in the last place
ENOUGH = 2.0**-51
# the least and the greatest slope that a step of the search assumes
SLOPES = (0.9, 2.0)
# elements searched at once: what is worked on stays in the cache
BLOCK = 32768


def velocity_ratio_for(
    tracking_index: ArrayLike,
    position_variance_ratio: ArrayLike,
    *,
    covariance: str = "predicted",
    process_noise: str = DEFAULT,
) -> np.float64 | NDArray[np.float64]:
    """The velocity ratio S = sigma_d T/sigma_o at which the position is as accurate as wanted.

    tracking_index: Lambda = sigma_a T^2/sigma_o. position_variance_ratio: the wanted G1, variance
    of the position over sigma_o^2; of the predicted position, or with ``covariance="updated"``
    of the updated one. Numbers or arrays, broadcast together. process_noise: as in
    `steady_state`.

    There is one answer exactly when the wanted G1 lies between the limits with the velocity known
    exactly (S to 0) and with no velocity measured (S to infinity); else ValueError says which is
    in the way, with both limits and the place. The limits are computed like everything else: a
    wanted G1 nearer to one of them than the errors that its kernel states may be refused, since on
    which side it lies is not known. The search is over the S that the kernels take;
    where the answer lies beyond them, ValueError says so.

    **What is promised.** The S returned is the exact answer to a nearby question:

        |G1(S)/wanted - 1| <= b + 2^-50,

    with b the error bound that the kernel of the covariance states. (An S close to the true one
    cannot be promised: where G1 hardly changes, many S are as good.)

    **Why.** Let y = S^2. For a fixed stabilising gain the variance of the position is an affine
    function of y that does not fall, nowhere negative; G1 is the least of these functions, at the
    gain of the steady state (that the stabilising solution is the least covariance of all fixed
    gains is the textbook theorem, cited). So G1 is concave in y and does not fall. It rises
    strictly: its slope is that of the affine function at the best gain, for which the newest
    measurement alone counts k12^2 (updated) or (k12 + k22)^2 (predicted), and the gains are
    positive. And a concave function that is nowhere negative grows no faster than its argument:
    G1(t y) <= t G1(y) for t >= 1.

    The search (`bracketing`) starts from two S whose computed values lie on both sides of the
    wanted one, and ends in one of two ways. Either the computed residual is at most
    2^-51, and then the true one is at most b + 2^-51 and a rounding. Or there are two
    neighbouring floats S < S' with computed values below the wanted one and not below it. Then
    G1(S) <= wanted (1 + b), and since S'/S <= 1 + 2^-52, G1(S) >= G1(S')/(1 + 2^-52)^2 >=
    wanted (1 - b)(1 - 2^-51): the same bound, to first order in b, with room for the second.
    It ends after at most 136 evaluations of the kernel, for most questions after fewer than ten.

    Raises ValueError for numbers that are not positive and finite, a wanted G1 out of reach, an
    unknown name; TypeError for what is no real number.

    Source: Suzuki, section 4, where S is asked for at G1 = 1.1 G1(S=0) (figure 2).
    """
    index, wanted = positive(
        {"tracking_index": tracking_index, "position_variance_ratio": position_variance_ratio}
    )
    variance = position_variance(covariance, process_noise)
    limits = Limits(variance.known_exactly(index), variance.not_measured(index))
    require_reachable(variance.title, wanted, limits, index, "")
    _require_inside(variance, index, wanted)
    flat = [np.ravel(x) for x in (index, wanted, limits.least, limits.greatest)]
    found = np.empty(wanted.size)
    for start in range(0, wanted.size, BLOCK):
        part = slice(start, start + BLOCK)
        found[part] = _search(variance, *(x[part] for x in flat))
    return found.reshape(wanted.shape)[()]


def _require_inside(variance: Variance, index: Reals, wanted: Reals) -> None:
    """ValueError where the answer lies beyond the velocity ratios that the kernels take."""
    least, most = variance.smallest_ratio, variance.largest_ratio
    above = variance.at(index, np.array(least)) < wanted
    require(above, wanted, variance.title, f"one with a velocity ratio above {least!s}")
    below = variance.at(index, np.array(most)) > wanted
    require(below, wanted, variance.title, f"one with a velocity ratio below {most!s}")


def _search(
    variance: Variance, index: Reals, wanted: Reals, least: Reals, greatest: Reals
) -> Reals:
    goal = _odds(wanted, least, greatest)

    def value_at(ratio: Reals, places: Places) -> Reals:
        return variance.at(index[places], ratio)

    def suggest(last: Point, before: Point, places: Places) -> Reals:
        ends = least[places], greatest[places]
        here, there = _odds(last[1], *ends), _odds(before[1], *ends)
        with np.errstate(all="ignore"):
            slope = (here - there) / np.log(last[0] / before[0])
            # NaN where there is no earlier point, or no difference left
            slope = np.where(slope >= SLOPES[0], np.minimum(slope, SLOPES[1]), SLOPES[1])
            return np.asarray(last[0] * np.exp((goal[places] - here) / slope))

    ends = variance.smallest_ratio, variance.largest_ratio
    start = np.clip(np.sqrt(index), *ends)
    return increasing_root(value_at, wanted, *ends, start, ENOUGH, suggest)


def _odds(value: Reals, least: Reals, greatest: Reals) -> Reals:
    """log((G1 - least)/(greatest - G1)): against log S nearly a line, of slope 1 to 2."""
    with np.errstate(all="ignore"):
        return np.asarray(np.log((value - least) / (greatest - value)))
