"""A difference of roots that as it is written loses every digit for large numbers."""

import sympy as sp

from gainproof.derive.own_expressions.expressions import (
    Argument,
    ExpressionKernel,
    ExpressionSet,
    Result,
)
from gainproof.derive.quantity import ONE, Quantity

NUMBER = Quantity("x", "x", "any number above 0", ONE)
STEP = Quantity("step", "d", "sqrt(x + 1) less sqrt(x)", ONE)
x = NUMBER.symbol

EXPRESSIONS = ExpressionSet(
    name="root-difference",
    title="Difference of two roots",
    kernels=(
        ExpressionKernel(
            name="root_difference",
            title="From one root to the next",
            inputs=(Argument(NUMBER),),
            outputs=(Result(STEP, sp.sqrt(x + 1) - sp.sqrt(x)),),
        ),
    ),
)
