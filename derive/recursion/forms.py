"""Prediction and update of a factored covariance, without a subtraction of computed numbers.

The forms take anything with + * /: SymPy's symbols, where they are proved, and the nodes of
graphs, from which kernels are printed. The covariance of position and velocity is

    P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]:

d2 is the velocity's variance, u a time (how much the position errs for each unit of velocity), d1
what is left of the position's variance once the velocity is known.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from gainproof.derive.recursion.noise import Noise


@dataclass(frozen=True)
class Factors:
    """d1, u and d2; `cross` is u d2 where that is known before u."""

    position: Any
    shear: Any
    velocity: Any
    cross: Any


@dataclass(frozen=True)
class Updated:
    """What a measurement does: the new factors, the gains, the innovation's variance."""

    position: Any
    shear: Any
    velocity: Any
    position_gain: Any
    velocity_gain: Any
    innovation: Any


def factors(position: Any, shear: Any, velocity: Any) -> Factors:
    """Factors as they are given."""
    return Factors(position, shear, velocity, shear * velocity)


def covariance(f: Factors) -> tuple[Any, Any, Any]:
    """Entries 11, 12 and 22."""
    return f.position + f.shear * f.cross, f.cross, f.velocity


def predicted(noise: Noise, f: Factors, interval: Any, strength: Any) -> Factors:
    """F P F' + Q over an interval.

    F alone adds the interval to the shear. Two sheared covariances add up to one whose shear is
    their mean, weighed by the variances, and whose d1 grows by the spread of the two.
    """
    gained = noise.velocity(strength, interval)
    total = f.velocity + gained
    cross = (f.shear + interval) * f.velocity
    arm = f.shear + (interval / 2 if noise.share else interval)
    if noise.share:
        cross = cross + (interval / 2) * gained
    spread = (arm * arm) * (f.velocity * (gained / total))
    own = noise.position(strength, interval)
    more = spread if own is None else spread + own
    return Factors(f.position + more, cross / total, total, cross)


def updated(f: Factors, measurement: Any) -> Updated:
    """The factors after a position measured with a variance."""
    known = f.position + measurement
    own, cross, _ = covariance(f)
    innovation = own + measurement
    left = measurement / known
    return Updated(
        f.position * left,
        f.shear * left,
        f.velocity * (known / innovation),
        own / innovation,
        cross / innovation,
        innovation,
    )


def started(noise: Noise, interval: Any, strength: Any, measurement: Any) -> Factors:
    """The factors after the first two positions, an interval apart, and nothing known before."""
    rate = measurement / (interval * interval)
    gained = noise.velocity(strength, interval)
    if noise.chord != 1:
        gained = gained * noise.chord.numerator / noise.chord.denominator
    total = rate * 2 + gained
    cross = measurement / interval
    return Factors(measurement * ((rate + gained) / total), cross / total, total, cross)
