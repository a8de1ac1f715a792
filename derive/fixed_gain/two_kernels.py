"""The kernels of alpha-beta filters as expression graphs, without a subtraction of computed values.

Of the gains 4 - 2 alpha - beta is computed as 2 (1 - alpha) + (2 - beta), each difference exact but
for one rounding; so these kernels take alpha below 1 and beta below 2. The others take the
coordinates of the whole region.
"""

from __future__ import annotations

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node

SCALE = "_scale"
HALF_SUM, DISCRIMINANT = "half_sum", "quarter_discriminant"


def difference(output: str) -> str:
    """The name of the subtraction of computed values that gives an output."""
    return f"{output}_difference"


def _gains(builder: GraphBuilder) -> tuple[Node, Node, Node, Node]:
    """alpha, beta, 1 - alpha, 4 - 2 alpha - beta."""
    alpha, beta = builder.symbol("alpha"), builder.symbol("beta")
    rest = 1 - alpha
    return alpha, beta, rest, rest * 2 + (2 - beta)


def variances() -> Graph:
    """Covariances of prediction and update under measurement noise, from the gains."""
    builder = GraphBuilder()
    alpha, beta, rest, margin = _gains(builder)
    ratio = beta / alpha
    predicted = ((alpha * 2 + ratio * 2) + beta) / margin
    near, far = beta * 2 / margin, ratio * beta / margin
    cross = near - far
    last = ratio * beta * 2 / margin
    return builder.graph(
        {
            "predicted_11": predicted,
            "predicted_12": near + far,
            "predicted_22": last,
            "updated_11": rest * rest * predicted + alpha * alpha,
            "updated_12": cross,
            "updated_22": last,
        },
        {difference("updated_12"): cross},
    )


def lags() -> Graph:
    """Errors behind a constant acceleration 1."""
    builder = GraphBuilder()
    alpha, beta, rest, _ = _gains(builder)
    double = beta * 2
    near, far = alpha * 2 / double, beta / double
    turn = near - far
    return builder.graph(
        {
            "predicted_position_lag": 1 / beta,
            "predicted_velocity_lag": near + far,
            "updated_position_lag": rest / beta,
            "updated_velocity_lag": turn,
        },
        {difference("updated_velocity_lag"): turn},
    )


def poles() -> Graph:
    """Half the sum of the poles, their product's root, the square of half their difference."""
    builder = GraphBuilder()
    alpha, beta, rest, _ = _gains(builder)
    half = (alpha + beta) / 2
    middle, square = 1 - half, half * half
    discriminant = square - beta
    return builder.graph(
        {
            HALF_SUM: middle,
            "modulus": builder.sqrt(rest),
            DISCRIMINANT: discriminant,
            HALF_SUM + SCALE: 1 + half,
            DISCRIMINANT + SCALE: square + beta,
        },
        {
            difference(HALF_SUM): middle,
            difference(DISCRIMINANT): discriminant,
            "modulus": builder.sqrt(rest),
        },
    )


def coordinates() -> Graph:
    """The margin and the coordinates of the region, from the gains."""
    builder = GraphBuilder()
    alpha, beta, _, margin = _gains(builder)
    return builder.graph(
        {
            "margin": margin,
            "linear_coefficient": alpha * 2 / beta,
            "quadratic_coefficient": margin / beta,
        }
    )


def _coordinates(builder: GraphBuilder) -> tuple[Node, Node]:
    return builder.symbol("linear_coefficient"), builder.symbol("quadratic_coefficient")


def gains() -> Graph:
    """The gains of a place in the region."""
    builder = GraphBuilder()
    x, y = _coordinates(builder)
    below = (1 + x) + y
    return builder.graph({"alpha": x * 2 / below, "beta": 4 / below})


def region_variances() -> Graph:
    """Covariances of prediction and update, for every stable filter."""
    builder = GraphBuilder()
    x, y = _coordinates(builder)
    more, less, area = 1 + x, x - 1, x * y
    return builder.graph(
        {
            "predicted_11": (more * more + y) / area,
            "predicted_12": more * 2 / area,
            "predicted_22": 4 / area,
            "updated_11": (less * less + y) / area,
            "updated_12": less * 2 / area,
            "updated_22": 4 / area,
        }
    )
