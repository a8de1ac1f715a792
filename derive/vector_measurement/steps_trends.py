"""Steps on trends: what grows and what falls with the index, and with the velocity's error."""

from __future__ import annotations

from typing import Any

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import limit, monotone
from gainproof.derive.vector_measurement.by_ratio import updated_by_ratio
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.ends import root_of_e
from gainproof.derive.vector_measurement.forms import Noise, gains
from gainproof.derive.vector_measurement.names import PREDICTED, RATIO, UPDATED, titled
from gainproof.derive.vector_measurement.rates import Rates

WITH_INDEX = (*PREDICTED, "updated_11", "updated_22", "gain_11", "gain_22", "innovation_ratio")
WITH_RATIO = (*PREDICTED, *UPDATED, "gain_11", "gain_21")
FALLING = ("gain_22", "innovation_ratio")


def trend_steps(c: Context) -> list[Step]:
    """Strict trends in Lambda and in S; then the gain that has none in Lambda."""
    rising = "increasing"
    return [
        *_trends(
            c,
            (WITH_INDEX, rising, "tracking_index"),
            "With the index, that is with more process noise or a better measured position, every "
            "variance in units of the position's grows, S held",
        ),
        *_trends(
            c,
            (WITH_RATIO, rising, "velocity_ratio"),
            "With the velocity's error every covariance grows, Lambda held",
        ),
        *_trends(
            c,
            (FALLING, "decreasing", "velocity_ratio"),
            "The less accurate the velocity is, the less it is believed",
        ),
        *_turning(c),
    ]


def _trends(c: Context, what: tuple[tuple[str, ...], str, str], lead: str) -> list[Step]:
    names, trend, variable = what
    steps = []
    for number, name in enumerate(names):
        hint: dict[str, Any] = {}
        if not c.noise.interval and (name, variable) in (
            ("updated_11", "velocity_ratio"),
            ("gain_11", "velocity_ratio"),
        ):
            hint["form"] = updated_by_ratio(Rates(c.basis))["updated_11"]
        steps.append(
            Step(
                f"{trend}-{name}-{variable}".replace("_", "-"),
                titled(lead, name, number),
                monotone(real(name), trend, variable),
                "The derivative, or its negative, has a form without a minus sign.",
                hint=hint,
            )
        )
    return steps


def _turning(c: Context) -> list[Step]:
    """The velocity's gain on the measured position at both ends of the index."""
    ends = index_ends(c.noise)
    stable = gains(c.basis)["gain_21"]
    value, text = sp.Integer(0), "vanishes again"
    if c.noise.interval and not c.noise.e:
        value, text = 2 * RATIO**2 / (RATIO + 2) ** 2, "tends to this value"
    return [
        Step(
            "turning-gain-21-small",
            "The velocity's gain on the measured position is positive and vanishes with the index.",
            limit(real("gain_21"), "0", sp.Integer(0), "tracking_index"),
            "Put the end values of the roots; S is held.",
            hint={"ends": ends},
        ),
        Step(
            "turning-gain-21-large",
            f"And it {text} when the index grows without bound.",
            limit(real("gain_21"), "infinity", value, "tracking_index"),
            "The velocity is then taken from its own measurement; S is held.",
            hint={"ends": ends, "limit_form": stable},
        ),
    ]


def index_ends(noise: Noise) -> dict[str, End]:
    """The main tower at both ends of the index, S held."""
    root, names = root_of_e(noise)
    near = {"eta_scaled": 4 * RATIO, "delta_scaled": RATIO * real("root_2")}
    constants: dict[str, int | sp.Expr] = {}
    if not noise.interval:
        constants["wide"] = RATIO**2 + 4
        wide = real("wide")
        far = {"eta_scaled": wide, "delta_scaled": (RATIO + wide) / 2}
        weights = {"eta_scaled": 2, "delta_scaled": 1}
    elif not noise.e:
        far = {"eta_scaled": sp.Integer(2), "delta_scaled": RATIO / 2 + 1}
        weights = {"eta_scaled": 2, "delta_scaled": 1}
    else:
        constants |= {f"{name}_held": number for name, number in names.items()}
        half = root.subs({real(name): real(f"{name}_held") for name in names}) / 2
        far = {"eta_scaled": half, "delta_scaled": half}
        weights = {"eta_scaled": 4, "delta_scaled": 3}
        if noise.determinant:
            near["level_scaled"], far["level_scaled"], weights["level_scaled"] = RATIO, half, 2
    return {
        "0": End(constants={"root_2": 2}, boundary=near),
        "infinity": End(weights=weights, constants=constants, boundary=far),
    }
