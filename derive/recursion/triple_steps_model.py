"""Steps on the model of three states and on the factored covariance."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.recursion.triple_names import (
    D1,
    D2,
    D3,
    ENTRIES,
    A,
    B,
    C,
    T,
    filled,
    first_shear,
    rows,
    second_shear,
    sheared,
    symmetric,
    transition,
    upper,
)
from gainproof.derive.relation import Relation, described, equal


def model_steps() -> list[Step]:
    """What is filtered, and how its covariance is kept."""
    s = real("s")
    c11, c12, c13, c22, c23, c33 = (real(f"c{ij}") for ij in ENTRIES)
    minor, mixed, det = map(real, ("minor", "mixed", "det"))
    return [
        Step(
            "model",
            "A target's position, velocity and acceleration are estimated; the position is "
            "measured with variance `r`, at any times, an interval `t` apart; `H = [1, 0, 0]`.",
            described("position, velocity and acceleration, position measured, over any interval"),
            "All in units that fit together. What disturbs the acceleration is the process noise "
            "`Q`, below.",
            heading="The model and its covariance",
        ),
        Step(
            "intervals-add",
            "The motion `F` over two intervals, one after the other, is that over their sum.",
            equal(
                sp.MatMul(transition(T), transition(s), evaluate=False),
                transition(s + T),
            ),
            "Multiply out.",
            tower="intervals",
        ),
        Step(
            "motion",
            "`F` is a product of three shears: some of the velocity to the position, some of the "
            "acceleration to the velocity, and the first once more.",
            equal(
                transition(T),
                sp.MatMul(first_shear(T / 2), second_shear(T), first_shear(T / 2), evaluate=False),
            ),
            "Multiply out.",
            tower="intervals",
        ),
        Step(
            "shears",
            "The covariance is kept like this: `P = U diag(d1, d2, d3) U'`, where `U` is a product "
            "of the same three shears by `a`, `b` and `c`, none of them negative.",
            equal(
                upper(A, B, C),
                sp.MatMul(first_shear(A), second_shear(B), first_shear(C), evaluate=False),
            ),
            "Multiply out. The entries of `U` alone will not do, as the update shows.",
        ),
        Step(
            "factors",
            "Its entries are sums without a minus sign.",
            equal(symmetric("covariance"), sheared((D1, D2, D3, A, B, C))),
            "Multiply out.",
        ),
        Step(
            "definite",
            "With `d1`, `d2` and `d3` above zero it is positive definite, whatever the shears; no "
            "rounding can take that away.",
            Relation("positive_definite", {"matrix": rows("covariance")}),
            "Its leading minors have no minus sign.",
        ),
        Step(
            "from-entries",
            "A positive definite matrix is of this form if its entries 13 and 23 and its minor "
            "`n = c12 c23 - c13 c22` are not negative; `m` is the minor `c22 c33 - c23^2`, which "
            "is above zero, as is the determinant.",
            equal(
                filled([c11, c12, c13, c22, c23, c33]),
                sheared(
                    (det / minor, minor / c33, c33, c13 / c23, c23 / c33, c33 * mixed / minor / c23)
                ),
            ),
            "Multiply out; `c22`, `c12` and `c11` follow from `m`, `n` and the determinant. Where "
            "`c23` is zero `c13` has to be, and `c` is `c12/c22`. What follows keeps the shears "
            "from zero on.",
            tower="entries",
        ),
        joined("from-entries-minor", equal(minor, c22 * c33 - c23**2), tower="entries"),
        joined("from-entries-mixed", equal(mixed, c12 * c23 - c13 * c22), tower="entries"),
        joined(
            "from-entries-determinant",
            equal(det, filled([c11, c12, c13, c22, c23, c33]).det()),
            tower="entries",
        ),
    ]
