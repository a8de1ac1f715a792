"""Steps on the model and on the factored covariance."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.recursion.names import D1, D2, T, U, rows, shear_matrix, sheared, symmetric
from gainproof.derive.relation import Relation, described, equal


def model_steps() -> list[Step]:
    """What is filtered, and how its covariance is kept."""
    s = real("s")
    c11, c12, c22, det = map(real, ("c11", "c12", "c22", "det"))
    return [
        Step(
            "model",
            "A target's position and velocity are estimated; the position is measured with "
            "variance `r`, at any times. Between two times lies an interval `t`, in which the "
            "position moves on by `t` times the velocity: `F = [1, t; 0, 1]`, `H = [1, 0]`.",
            described("position and velocity, position measured, over any interval"),
            "All in units that fit together, metres and seconds for instance. What disturbs the "
            "velocity is the process noise `Q`, below.",
            heading="The model and its covariance",
        ),
        Step(
            "intervals-add",
            "Two intervals, one after the other, are one.",
            equal(
                sp.MatMul(shear_matrix(T), shear_matrix(s), evaluate=False),
                shear_matrix(s + T),
            ),
            "Multiply out.",
            tower="intervals",
        ),
        Step(
            "factors",
            "The covariance `P` is kept as two variances and a time: `d2` is the variance of the "
            "velocity, `u` says how much the position errs for each unit of velocity, `d1` is the "
            "variance that is left of the position once the velocity is known.",
            equal(symmetric("covariance"), sheared(D1, U, D2)),
            "Multiply out. This is the factorisation `U D U'` of a covariance, which Bierman's "
            "filters use.",
        ),
        Step(
            "definite",
            "With `d1` and `d2` above zero it is positive definite, whatever `u`. So no rounding "
            "can take that away: it is enough that two numbers stay above zero, which products, "
            "quotients and sums of positive numbers do.",
            Relation("positive_definite", {"matrix": rows("covariance")}),
            "Its first entry has no minus sign, its determinant is `d1 d2`.",
        ),
        Step(
            "from-entries",
            "Every positive definite matrix is of this form, with `d2` its entry 22, `u` the "
            "quotient of entries 12 and 22, `d1` that of determinant and entry 22.",
            equal(
                sp.ImmutableDenseMatrix([[c11, c12], [c12, c22]]),
                sheared(det / c22, c12 / c22, c22),
            ),
            "Multiply out; entry 11 is `(det + c12^2)/c22`. Here position and velocity are not "
            "correlated negatively: `u` starts at zero or above, and what follows keeps it there.",
            tower="entries",
        ),
    ]
