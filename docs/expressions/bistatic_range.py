"""How far a signal travels from a transmitter by way of a target to a receiver, in the plane."""

import sympy as sp

from gainproof.derive.own_expressions.expressions import (
    Argument,
    ExpressionKernel,
    ExpressionSet,
    Result,
)
from gainproof.derive.quantity import METRE, Quantity

NAMES = ("target_x", "target_y", "transmitter_x", "transmitter_y", "receiver_x", "receiver_y")
PLACES = [Quantity(name, name, name.replace("_", ", "), METRE) for name in NAMES]
x, y, tx, ty, rx, ry = (place.symbol for place in PLACES)
RANGE = Quantity("bistatic_range", "r", "length of the way by the target", METRE)

EXPRESSIONS = ExpressionSet(
    name="bistatic-range",
    title="Bistatic range in the plane",
    kernels=(
        ExpressionKernel(
            name="bistatic_range",
            title="Transmitter to target to receiver",
            inputs=tuple(Argument(place, "1e-3", "1e9", signed=True) for place in PLACES),
            outputs=(
                Result(
                    RANGE,
                    sp.sqrt((x - tx) ** 2 + (y - ty) ** 2) + sp.sqrt((x - rx) ** 2 + (y - ry) ** 2),
                ),
            ),
        ),
    ),
)
