"""The chart of index and S that a process noise has."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from gainproof.verify.judge.exact.expression import Expr, sqrt
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.setting import plane_chart, quadrant_chart
from gainproof.verify.judge.setting.chart_field import ChartField, SignInside
from gainproof.verify.judge.setting.triangle import sign_on_triangle
from gainproof.verify.judge.setting.two_measurements import Entries, Noise


@dataclass(frozen=True)
class Chart:
    """Index, the squares of index and S, and the covariances in the base variables of a chart;
    `onto` shows that all positive pairs are met, `sign_inside` is what is known of signs there.
    """

    index: Expr
    index2: Expr
    ratio2: Expr
    entries: Entries
    onto: Callable[[ChartField], Mapping[str, str]]
    sign_inside: SignInside


def chart_of(noise: Noise) -> Chart:
    """Raises Undecided where there is none."""
    if noise == plane_chart.COVERED:
        index2, ratio2 = plane_chart.squares()
        found, onto = plane_chart.charted_entries(), plane_chart.refuse_unless_onto
        return Chart(sqrt(index2), index2, ratio2, found, onto, sign_on_triangle)
    if quadrant_chart.is_covered(noise):
        index, _ = quadrant_chart.coordinates(noise)
        index2, ratio2 = quadrant_chart.squares(noise)
        return Chart(
            index,
            index2,
            ratio2,
            quadrant_chart.charted_entries(noise),
            lambda field: quadrant_chart.refuse_unless_onto(field, noise),
            quadrant_chart.sign_on_quadrant,
        )
    raise Undecided("position and velocity measured, with a process noise that has no chart")
