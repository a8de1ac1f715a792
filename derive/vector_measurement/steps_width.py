"""Steps on the step: from 1.1 times the accuracy with an exact velocity to 1/1.1 without it.

S1 is where P11 is 1.1 times its value at S = 0, S2 where it is 1/1.1 times its limit for large S.
In each corner P11 tends to a function of one variable; S1 and S2 tend to where these take the
value, being the crossings of monotone functions.
"""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import cited, increasing_onto
from gainproof.derive.source import ELEMENTARY
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.ends import ratio_ends
from gainproof.derive.vector_measurement.steps_width_equation import equation_steps
from gainproof.derive.vector_measurement.steps_width_large import large_index_steps
from gainproof.derive.vector_measurement.steps_width_small import small_index_steps

P11 = real("predicted_11")


def width_steps(c: Context) -> list[Step]:
    """Existence and uniqueness of S1 and S2, and where they go for small and large index."""
    noise = c.noise
    if not noise.determinant:
        return []
    ends = ratio_ends(noise)
    return [
        Step(
            "width-range",
            "For every index `P11` takes each value between its limits at exactly one `S`. So "
            "`S1`, where it is 1.1 times the first, and `S2`, where it is the second over 1.1, "
            "exist and are unique: the step of `P11` reaches from `S1` to `S2`.",
            increasing_onto(
                P11, real("known_predicted_11"), real("only_predicted_11"), "velocity_ratio"
            ),
            "`P11` grows with `S` (step @increasing-predicted-11-velocity-ratio); its limits are "
            "in steps @velocity-known-predicted-11 and @velocity-absent-predicted-11. The ratio of "
            "both is below `1/1.1^2` by step @improvement-range, so `S1` lies before `S2`.",
            tower="ends",
            heading="The width of the step",
            hint={"ends": ends},
        ),
        *equation_steps(c),
        *small_index_steps(c),
        *large_index_steps(c),
        Step(
            "width-crossings",
            "That `S1` and `S2` themselves tend to these crossings of the limits rests on a "
            "theorem.",
            cited(
                "If strictly monotone functions tend at every point to a strictly monotone "
                "function, the points where they cross a value tend to where it does.",
                ELEMENTARY.text(),
            ),
            "Compare the values a little before and a little after the limit's crossing. The "
            "theorem is cited, not proved here.",
        ),
    ]
