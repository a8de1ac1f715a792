"""The kernels of alpha-beta-gamma filters as expression graphs, without a subtraction of values.

`share` is gamma over the largest stable one at these alpha and beta, 2 alpha beta/(2 - alpha): with
it the domain is a product. 4 - 2 alpha - beta is 2 (1 - alpha) + (2 - beta), 2 alpha beta - gamma
(2 - alpha) is 2 alpha beta (1 - share), 2 beta - gamma is 2 beta (2 (1 - alpha) + alpha (1 -
share))/(2 - alpha).
"""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.derive.fixed_gain.three_named_lag_kernels import (
    random_acceleration_by_lag,
    random_jerk_by_gain,
    random_jerk_by_lag,
)
from gainproof.derive.fixed_gain.three_noise_kernels import noise_graphs
from gainproof.derive.fixed_gain.three_pole_kernels import POLES, poles
from gainproof.derive.fixed_gain.two_kernels import SCALE, difference
from gainproof.derive.printer.fixed_point import fixed_point, near_cbrt
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node

UPDATED = "updated_variances_of_coordinates"


@dataclass(frozen=True)
class Given:
    """The gains and what they make; `slack` is 1 - share, `gap` 2 beta - gamma."""

    builder: GraphBuilder
    alpha: Node
    beta: Node
    gamma: Node
    share: Node
    slack: Node
    rest: Node
    beyond: Node
    margin: Node
    gap: Node


def _given() -> Given:
    builder = GraphBuilder()
    alpha, beta, share = (builder.symbol(name) for name in ("alpha", "beta", "share"))
    rest, beyond, slack = 1 - alpha, 2 - alpha, 1 - share
    margin = rest * 2 + (2 - beta)
    twice = beta * 2 / beyond
    gamma = alpha * share * twice
    gap = twice * (rest * 2 + alpha * slack)
    return Given(builder, alpha, beta, gamma, share, slack, rest, beyond, margin, gap)


def coordinates() -> Graph:
    """gamma, the margin and the coordinates of the region."""
    g = _given()
    ratio = g.beta / g.gamma
    return g.builder.graph(
        {
            "gamma": g.gamma,
            "margin": g.margin,
            "linear_coefficient": ratio * 2,
            "cubic_coefficient": g.margin * 2 / g.gamma,
            "hurwitz_determinant": (g.alpha / g.gamma) * ratio * g.slack * 8,
        }
    )


def variances() -> Graph:
    """Covariances of prediction and update under measurement noise."""
    g = _given()
    part = g.share / (g.beyond * g.slack)  # gamma/(2 alpha beta - gamma (2 - alpha))
    wide = g.alpha * g.slack
    below = wide * g.margin
    plus = g.beta * 2 + g.gamma
    first = (g.beta * 4 / below + g.alpha) / g.beyond
    weight = g.beta * part * plus / g.margin
    turned = g.beta * part * g.gap / g.margin
    last = g.beta * part * 4 * g.gamma / g.margin
    near_12, far_12 = g.gap / (g.slack * g.margin), g.beta / 2 * g.gap / below
    near_13, far_13 = g.gamma * 2 / g.margin, turned
    second, third = near_12 - far_12, near_13 - far_13
    return g.builder.graph(
        {
            "predicted_11": first,
            "predicted_12": (g.alpha * 2 + g.beta) * plus / (below * 2),
            "predicted_13": g.gamma * 2 / g.margin + weight,
            "predicted_22": (g.beta * (g.beta + g.gamma) / wide + g.gamma * (g.share / g.slack))
            * 2
            / g.margin,
            "predicted_23": weight * 2,
            "predicted_33": last,
            "updated_11": g.rest * g.rest * first + g.alpha * g.alpha,
            "updated_12": second,
            "updated_13": third,
            "updated_22": g.gap * g.gap / (below * 2) + g.gamma * part,
            "updated_23": turned * 2,
            "updated_12" + SCALE: near_12 + far_12,
            "updated_13" + SCALE: near_13 + far_13,
        },
        {difference("updated_12"): second, difference("updated_13"): third},
    )


def lags() -> Graph:
    """Errors behind a constant jerk 1."""
    g = _given()
    near = g.alpha / g.gamma + g.builder.number("1/12")
    far = g.beta / (g.gamma * 2)
    turn = near - far
    return g.builder.graph(
        {
            "predicted_position_lag": 1 / g.gamma,
            "predicted_velocity_lag": near + far,
            "predicted_acceleration_lag": g.beta / g.gamma + g.builder.number("1/2"),
            "updated_position_lag": g.rest / g.gamma,
            "updated_velocity_lag": turn,
            "updated_acceleration_lag": g.gap / (g.gamma * 2),
        },
        {difference("updated_velocity_lag"): turn},
    )


def _coordinates(builder: GraphBuilder) -> tuple[Node, Node, Node]:
    names = ("linear_coefficient", "cubic_coefficient", "hurwitz_determinant")
    x, d, m = (builder.symbol(name) for name in names)
    return x, d, m


def gains() -> Graph:
    """The gains of a place in the region."""
    builder = GraphBuilder()
    x, d, m = _coordinates(builder)
    y = (d + m) / x
    below = ((1 + x) + y) + d
    return builder.graph({"alpha": (1 + y) * 2 / below, "beta": x * 4 / below, "gamma": 8 / below})


def region_variances() -> Graph:
    """The covariance of the prediction, for every stable filter."""
    builder = GraphBuilder()
    x, d, m = _coordinates(builder)
    more = 1 + x
    w, both = x * more, d * m
    total = w + m
    return builder.graph(
        {
            "predicted_11": (d * (m + w * more) + total * total) / (both * x),
            "predicted_12": more * (total + d) * 2 / both,
            "predicted_13": total * 4 / both,
            "predicted_22": (d + w * more) * 4 / both,
            "predicted_23": w * 8 / both,
            "predicted_33": x * 16 / both,
        }
    )


def region_updated() -> Graph:
    """What is left of it after the update, but for the variance of the position."""
    builder = GraphBuilder()
    x, d, m = _coordinates(builder)
    more = (d + m) / x + 1
    both, square = d * m, x * x
    part = x / both * 2
    first = (more + 1) * x * part, (square + more) * part
    second = (m + x) / both * 4, square / both * 4
    less = x - 1
    last = x * 8 / both
    outputs, differences = {}, {}
    for ij, (ahead, behind) in {"12": first, "13": second, "23": (last * x, last)}.items():
        name = f"updated_{ij}"
        outputs[name] = ahead - behind
        outputs[name + SCALE] = ahead + behind
        differences[difference(name)] = outputs[name]
    outputs["updated_22"] = last * less * less / 2 + 4 / m
    return builder.graph(outputs, differences)


def graphs() -> dict[str, Graph]:
    """The graph of each kernel."""
    return {
        "coordinates": coordinates(),
        "gains_of_coordinates": gains(),
        "variances": variances(),
        "variances_of_coordinates": region_variances(),
        UPDATED: region_updated(),
        **noise_graphs(),
        "lags": lags(),
        POLES: poles(),
        "minimum_variance_by_lag": minimum_variance_by_lag(),
        "random_acceleration_by_lag": random_acceleration_by_lag(),
        "random_jerk_by_lag": random_jerk_by_lag(),
        "random_acceleration_by_gain": random_acceleration_by_gain(),
        "random_jerk_by_gain": random_jerk_by_gain(),
    }


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
