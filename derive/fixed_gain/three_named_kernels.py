"""The kernels that design named alpha-beta-gamma filters, without a subtraction of values."""

from __future__ import annotations

from gainproof.derive.printer.fixed_point import fixed_point, near_cbrt
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node


def minimum_variance_by_lag() -> Graph:
    """The gains and the variance at the lag 1/gamma."""
    builder = GraphBuilder()
    lag = builder.symbol("lag")
    inner: list[Node] = []

    def step(u: Node) -> Node:
        inner.append(builder.sqrt(lag * u))
        return builder.sqrt(inner[0])

    root = fixed_point(near_cbrt(lag), step, within="1/25")
    twice = root * 2
    x = (lag * 8 - 1) / ((twice + 1) * twice + 1)
    product = x * (x + 1)
    return builder.graph(
        {
            "minimum_variance_alpha": (product * 2 + 1) / (lag * 4),
            "minimum_variance_beta": x / (lag * 2),
            "minimum_variance_gamma": 1 / lag,
            "minimum_variance_predicted_11": (product * 3 + 1) / x / x / x,
        },
        {"root": root, "root_of_map": inner[0]},
    )


def random_acceleration_by_gain() -> Graph:
    """beta, gamma and variance of random acceleration."""
    builder = GraphBuilder()
    alpha = builder.symbol("alpha")
    root = builder.sqrt(1 - alpha)
    slow = alpha / (root + 1)
    square = slow * slow
    return builder.graph(
        {
            "random_acceleration_beta": square * 2,
            "random_acceleration_gamma": square * square * 2 / alpha,
            "random_acceleration_predicted_11": alpha
            * (root + 4)
            / (root * ((root + 4) * root + 1)),
        },
        {"root": root},
    )
