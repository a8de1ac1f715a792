"""Which ranges are taken as free of multipath: a chi-square test of each bias, (55)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from statistics import NormalDist


@dataclass(frozen=True)
class Decision:
    """One range: its station, the bias that bias detection finds and its deviation in m, the
    statistic bias^2/variance, and whether it is taken as clean.
    """

    station: str
    bias: float
    deviation: float
    statistic: float
    clean: bool


@dataclass(frozen=True)
class Selection:
    """The test: how often it may call a clean range biased, the threshold d that follows, and what
    it says of each range.
    """

    false_alarm: float
    threshold: float
    decisions: tuple[Decision, ...]

    @property
    def clean(self) -> tuple[str, ...]:
        return tuple(each.station for each in self.decisions if each.clean)


def threshold(false_alarm: float) -> float:
    """d with P(chi-square of 1 degree of freedom > d) = false_alarm; 3.841 at 5 %.

    The square of the normal quantile at half of it, on the side where no digit is lost. ValueError:
    not between 0 and 1.
    """
    if not 0 < false_alarm < 1:
        raise ValueError(f"the false-alarm probability is between 0 and 1, got {false_alarm!s}")
    return NormalDist().inv_cdf(false_alarm / 2) ** 2


def detection(bias: float, deviation: float, false_alarm: float) -> float:
    """How often a range of this bias is called biased: noncentral chi-square of 1 degree of freedom
    beyond the threshold, noncentrality (bias/deviation)^2.
    """
    shift, root = abs(bias) / deviation, threshold(false_alarm) ** 0.5
    normal = NormalDist()
    return normal.cdf(shift - root) + normal.cdf(-shift - root)


def exceeded(cost: float, degrees_of_freedom: int) -> float:
    """How often noise alone gives a larger cost: P(chi-square of these degrees of freedom > cost).

    For whole degrees of freedom the incomplete gamma function is a finite sum.
    """
    half = cost / 2
    if degrees_of_freedom % 2:
        tail, first, power = math.erfc(math.sqrt(half)), 1.5, 0.5
    else:
        tail, first, power = 0.0, 1.0, 0.0
    for j in range(degrees_of_freedom // 2):
        if half > 0:
            tail += math.exp((j + power) * math.log(half) - half - math.lgamma(j + first))
        elif j + power == 0:
            tail += 1.0
    return min(tail, 1.0)


def select(
    names: tuple[str, ...],
    biases: tuple[float, ...],
    deviations: tuple[float, ...],
    false_alarm: float,
) -> Selection:
    """The test (55) on the biases that bias detection estimated."""
    most = threshold(false_alarm)
    decisions = []
    for name, bias, deviation in zip(names, biases, deviations, strict=True):
        statistic = (bias / deviation) ** 2
        decisions.append(Decision(name, bias, deviation, statistic, statistic <= most))
    return Selection(false_alarm, most, tuple(decisions))
