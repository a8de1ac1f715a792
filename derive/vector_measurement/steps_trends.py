"""Steps on trends: what grows and what falls with the index, and with the velocity's error."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import limit, monotone
from gainproof.derive.vector_measurement.by_ratio import updated_by_ratio
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.ends import root_of_e
from gainproof.derive.vector_measurement.forms import gains
from gainproof.derive.vector_measurement.names import PREDICTED, RATIO, UPDATED
from gainproof.derive.vector_measurement.noise import Noise
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
            "variance in units of the position's grows, `S` held, and so do the gains on the "
            "diagonal.",
            "The derivative of each is positive: the checker writes it as a quotient of sums "
            "without a minus sign. Step @derivative-updated-22-tracking-index shows one.",
            "What grows and what falls",
        ),
        *_trends(
            c,
            (WITH_RATIO, rising, "velocity_ratio"),
            "With the velocity's error every covariance grows, `Lambda` held, and the measured "
            "position is believed more.",
            "Likewise; step @derivative-predicted-22-velocity-ratio shows three. `K11` and `K21` "
            "are `U11` and `U12`.",
        ),
        *_trends(
            c,
            (FALLING, "decreasing", "velocity_ratio"),
            "The less accurate the velocity is measured, the less it is believed.",
            "Their derivatives with the sign reversed are such quotients too.",
        ),
        *_turning(c),
    ]


def _trends(
    c: Context,
    what: tuple[tuple[str, ...], str, str],
    sentence: str,
    reason: str,
    heading: str = "",
) -> list[Step]:
    names, trend, variable = what
    steps = []
    for name in names:
        hint: dict[str, Any] = {}
        if not c.noise.interval and (name, variable) in (
            ("updated_11", "velocity_ratio"),
            ("gain_11", "velocity_ratio"),
        ):
            hint["form"] = updated_by_ratio(Rates(c.basis))["updated_11"]
        label = f"{trend}-{name}-{variable}".replace("_", "-")
        steps.append(joined(label, monotone(real(name), trend, variable), hint=hint))
    first, *others = steps
    return [
        replace(first, sentence=sentence, reason=reason, heading=heading, joins=False),
        *others,
    ]


def _turning(c: Context) -> list[Step]:
    """The velocity's gain on the measured position at both ends of the index."""
    ends = index_ends(c.noise)
    stable = gains(c.basis)["gain_21"]
    value, text = sp.Integer(0), "vanishes with the index and again when it grows without bound"
    if c.noise.interval and not c.noise.e:
        value = 2 * RATIO**2 / (RATIO + 2) ** 2
        text = "vanishes with the index and tends to a limit when it grows without bound"
    return [
        Step(
            "turning-gain-21-small",
            f"The velocity's gain on the measured position is positive; it {text}.",
            limit(real("gain_21"), "0", sp.Integer(0), "tracking_index"),
            "With `S` held insert the leading terms of the roots in `K21 = U12 = h/sigma` (step "
            "@result). With a large index the velocity is taken from its own measurement.",
            hint={"ends": ends},
        ),
        joined(
            "turning-gain-21-large",
            limit(real("gain_21"), "infinity", value, "tracking_index"),
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
