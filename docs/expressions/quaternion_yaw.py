"""Yaw of a unit quaternion that is not next to a vertical pitch."""

import sympy as sp

from gainproof.derive.own_expressions.expressions import (
    Argument,
    Condition,
    ExpressionKernel,
    ExpressionSet,
    Result,
)
from gainproof.derive.quantity import ONE, Quantity

NAMES = ("real part", "part along x", "part along y", "part along z")
PARTS = [Quantity(f"q{n}", f"q_{n}", meaning, ONE) for n, meaning in enumerate(NAMES)]
YAW = Quantity("yaw", r"\psi", "yaw", ONE)
q0, q1, q2, q3 = (each.symbol for each in PARTS)
over, under = 2 * (q0 * q3 + q1 * q2), q0**2 + q1**2 - q2**2 - q3**2

EXPRESSIONS = ExpressionSet(
    name="quaternion-yaw",
    title="Yaw of a quaternion",
    kernels=(
        ExpressionKernel(
            name="yaw",
            title="Yaw",
            inputs=tuple(Argument(each, "1e-6", "1", signed=True) for each in PARTS),
            outputs=(Result(YAW, sp.atan2(over, under), by_terms=True),),
            conditions=(
                Condition(
                    sp.Eq(q0**2 + q1**2 + q2**2 + q3**2, 1),
                    "square of the norm",
                    within=("1e-9", "1e-4"),
                ),
                Condition(
                    over**2 + under**2 >= sp.Rational(1, 25), "square of the cosine of the pitch"
                ),
            ),
        ),
    ),
)
