"""The kernels that design named alpha-beta filters, as expression graphs without a subtraction."""

from __future__ import annotations

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node


def minimum_variance_by_lag() -> Graph:
    """alpha, beta and variance at the lag 1/beta."""
    builder = GraphBuilder()
    lag = builder.symbol("lag")
    root = builder.sqrt(lag)
    twice = root * 2
    x = (lag * 4 - 1) / (twice + 1)
    alpha = x / (lag * 2)
    return builder.graph(
        _named("minimum_variance", alpha, 1 / lag, (x * 2 + 1) / x / x), {"root": root}
    )


def minimum_smoothed_variance_by_lag() -> Graph:
    """The gains and both variances of least smoothed variance; n is twice the root of the lag."""
    builder = GraphBuilder()
    lag = builder.symbol("lag")
    root = builder.sqrt(lag)
    n = root * 2
    more = n + 1
    square = more * more
    beyond = lag * 4 - 2
    above = ((n * 2 + 7) * n + 8) * n + 2
    return builder.graph(
        _smoothed(
            more / (root * (n + 2)), 1 / lag, above / square / beyond, (more * 2 + 1) / square
        ),
        {"root": root},
    )


def _smoothed(alpha: Node | None, beta: Node, predicted: Node, updated: Node) -> dict[str, Node]:
    filter_name = "minimum_smoothed_variance"
    first = {} if alpha is None else {f"{filter_name}_alpha": alpha}
    return {
        **first,
        f"{filter_name}_beta": beta,
        f"{filter_name}_predicted_11": predicted,
        f"{filter_name}_updated_11": updated,
    }


def random_acceleration_by_lag() -> Graph:
    """The same of random acceleration; p11 = (1 + x + x^2 (...))/..., see the steps."""
    builder = GraphBuilder()
    lag = builder.symbol("lag")
    eight = lag * 8
    root = builder.sqrt(eight)
    x = (eight - 1) / (root + 1)
    beyond = (lag * 2 - 1) * 4 / (root + 2)
    alpha = x / (lag * 2)
    # r^2 - x (x - 1) = 3 x + 1 with r = x + 1 the root and x - 1 = r - 2
    variance = (x * 3 + 1) / x / beyond
    return builder.graph(_named("random_acceleration", alpha, 1 / lag, variance), {"root": root})


def random_velocity_by_lag() -> Graph:
    """The same of random velocity; y = (4 L - 1 - sqrt 2) (4 L - 1 + sqrt 2)/(4 L + v)."""
    builder = GraphBuilder()
    lag = builder.symbol("lag")
    two = builder.sqrt(2)
    four = lag * 4
    root = builder.sqrt(lag * 8 + 1)
    x = lag * 8 / (root + 1)
    y = (four - (1 + two)) * (four + (two - 1)) / (four + root)
    variance = (root * root + y) / x / y
    return builder.graph(
        _named("random_velocity", 4 / (root + 1), 1 / lag, variance), {"root": root, "two": two}
    )


def _named(filter_name: str, alpha: Node, beta: Node, variance: Node) -> dict[str, Node]:
    return {
        f"{filter_name}_alpha": alpha,
        f"{filter_name}_beta": beta,
        f"{filter_name}_predicted_11": variance,
    }


def minimum_variance_by_gain() -> Graph:
    """Both filters of minimum variance with one alpha, the slow one first."""
    builder = GraphBuilder()
    alpha = builder.symbol("alpha")
    root = builder.sqrt(1 - alpha * 2)
    above = root + 1
    slow = alpha * 2 / above
    inner = 1 - alpha
    return builder.graph(
        {
            "slow_minimum_variance_beta": slow * slow,
            "slow_minimum_variance_predicted_11": slow * (root + 3) / (above * above),
            "fast_minimum_variance_beta": above * above,
            "fast_minimum_variance_predicted_11": (inner + root)
            / alpha
            * ((above + alpha) / alpha),
        },
        {"root": root},
    )


def minimum_smoothed_variance_by_gain() -> Graph:
    """beta and both variances; m = alpha n = 1 - alpha + sqrt(1 + alpha^2)."""
    builder = GraphBuilder()
    alpha = builder.symbol("alpha")
    root = builder.sqrt(1 + alpha * alpha)
    rest = 1 - alpha
    m = rest + root
    share = alpha * 2 / m
    above = 1 + root
    part = alpha / above
    cubic = ((m * 2 + alpha * 7) * m + alpha * alpha * 8) * m + alpha * alpha * alpha * 2
    predicted = part * cubic / (rest * 2 * (above * above))
    return builder.graph(
        _smoothed(None, share * share, predicted, part * (part + 2)), {"root": root}
    )


def random_acceleration_by_gain() -> Graph:
    """beta and variance of random acceleration."""
    builder = GraphBuilder()
    alpha = builder.symbol("alpha")
    root = builder.sqrt(1 - alpha)
    above = root + 1
    slow = alpha / above
    return builder.graph(
        {
            "random_acceleration_beta": slow * slow * 2,
            "random_acceleration_predicted_11": slow * (root + 2) / (root * above),
        },
        {"root": root},
    )


def random_velocity_by_gain() -> Graph:
    """beta and variance of random velocity."""
    builder = GraphBuilder()
    alpha = builder.symbol("alpha")
    below = (1 - alpha) * 8 + alpha * alpha
    return builder.graph(
        {
            "random_velocity_beta": alpha * alpha / (2 - alpha),
            "random_velocity_predicted_11": alpha * (6 - alpha) / below,
        }
    )
