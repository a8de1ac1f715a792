"""Steps on the equation without roots that S1 and S2 satisfy."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import equal
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import RATIO
from gainproof.derive.vector_measurement.position_equation import VARIANCE, position_equation

P11, KNOWN, ONLY = map(real, ("predicted_11", "known_predicted_11", "only_predicted_11"))


def equation_steps(c: Context) -> list[Step]:
    """The polynomial equation between Lambda, S and P11, and its ends."""
    coefficients = position_equation(c.spectrum)
    terms = [entry * RATIO ** (2 * power) for power, entry in enumerate(coefficients)]
    return [
        Step(
            "width-equation",
            "`S1` and `S2` satisfy an equation without roots. For every `S` the variance `P11` "
            "satisfies this one, of degree four in `S^2`; so `S1^2` is a positive root of it with "
            "`1.1 P11^d` for `P11`, and `S2^2` one with `P11^o/1.1`.",
            equal(sp.Add(*terms).subs(VARIANCE, P11), sp.Integer(0)),
            "`P11` is a rational function of `w`, `eta` and `delta` (step @result), whose squares "
            "are rational. Multiply by what it becomes under the other signs of the roots, which "
            "removes them. The checker inserts `P11`.",
        ),
        Step(
            "width-equation-ends",
            "What goes in for `P11` satisfies such equations, too: the term without `S` vanishes "
            "for `P11^d`, the last coefficient for `P11^o`.",
            equal(coefficients[0].subs(VARIANCE, KNOWN), sp.Integer(0)),
            "Let `S` fall to 0 in step @width-equation, or divide by `S^8` and let it grow.",
            tower="without_ratio",
        ),
        joined(
            "width-equation-far",
            equal(coefficients[-1].subs(VARIANCE, ONLY), sp.Integer(0)),
            "without_ratio",
        ),
    ]
