"""The kernels of gains that follow the index, as expression graphs."""

from __future__ import annotations

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node

Names = dict[str, Node]


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    return {
        "tracking_index": tracking_index(),
        "first_order_gains": first_order_gains(),
        "recursive_gains": recursive_gains(),
        "update_limits": update_limits(),
        "first_order_errors": first_order_errors(),
        "cycle_drift": cycle_drift(),
        "mismatch_variances": mismatch_variances(),
        "line_of_sight_gains": line_of_sight_gains(),
    }


def excess_of_deviation(builder: GraphBuilder, index: Node, name: str) -> tuple[Node, Names]:
    """e = Lambda (1 + sqrt(1 + 8/Lambda))/4, the innovation's deviation less 1."""
    root = builder.sqrt(8 / index + 1)
    return index * (root + 1) / 4, {name: root}


def tracking_index() -> Graph:
    """Of an axis."""
    builder = GraphBuilder()
    deviation, interval, variance = (
        builder.symbol(name) for name in ("acceleration_deviation", "interval", "variance")
    )
    root = builder.sqrt(variance)
    return builder.graph(
        {"tracking_index": deviation * (interval * interval) / root}, {"deviation": root}
    )


def first_order_gains() -> Graph:
    """On the tangents at the nominal index: what they leave at an index of 0, and the rise."""
    builder = GraphBuilder()
    nominal, index = builder.symbol("nominal_index"), builder.symbol("tracking_index")
    n, names = excess_of_deviation(builder, nominal, "nominal_root")
    one, two = n + 1, n + 2
    below = one * two
    alpha = (n * ((n + 4) * n + 2) / one + index / n) / below
    beta = (n * n * (n / one) + index) * 2 / below
    return builder.graph({"alpha": alpha, "beta": beta}, names)


def recursive_gains() -> Graph:
    """Gains so far, plus the slopes at the last index times its step."""
    builder = GraphBuilder()
    alpha, beta, index, following = (
        builder.symbol(name) for name in ("alpha", "beta", "tracking_index", "next_index")
    )
    e, names = excess_of_deviation(builder, index, "root")
    change = (following - index) / ((e + 1) * (e + 2))
    return builder.graph({"next_alpha": alpha + change / e, "next_beta": beta + change * 2}, names)


def update_limits() -> Graph:
    """Ratios of the index to the nominal one."""
    builder = GraphBuilder()
    nominal = builder.symbol("nominal_index")
    n, names = excess_of_deviation(builder, nominal, "nominal_root")
    inverse = 1 / n
    far = builder.sqrt((n * 5 + 10) * n + 1)
    near = builder.sqrt((n * 4 + 8) * n + 1)
    wide = builder.sqrt((n * 5 + 4) * n + 4)
    rise = ((n * 5 + 10) / (far + 1) + 1) / 2
    alpha = rise * rise * ((n + 1) * 2 / (far + n + 1))
    place = (near + 1) * inverse / 2 + 1
    beta = place * place * ((n + 1) * 2 / (near + 3 + n * 2))
    return builder.graph(
        {
            "alpha_one_ratio": inverse + "3/2",
            "unstable_ratio": inverse * 2 + 2,
            "variance_ratio": (wide + n + 2) * (inverse / 2),
            "alpha_gain_ratio": alpha,
            "beta_gain_ratio": beta,
        },
        names | {"s": far, "u": near, "v": wide},
    )


def _pair(builder: GraphBuilder) -> tuple[Node, Node, Node, Names]:
    """n, e, 2 (n + e + n e), and the names of roots."""
    n, names = excess_of_deviation(builder, builder.symbol("nominal_index"), "nominal_root")
    e, more = excess_of_deviation(builder, builder.symbol("tracking_index"), "root")
    return n, e, (n + e + n * e) * 2, names | more


OVER = "_over_square"
"""What errors are given over: the square of the step of the index, which needs no care."""


def first_order_errors() -> Graph:
    """Errors of first-order gains over the square of the step."""
    builder = GraphBuilder()
    n, e, both, names = _pair(builder)
    alpha = ((n + 1) * (e + 1) * 2 + n * (n + 2)) / (n * (n + 2))
    beta = ((n * e + e) * 2 + n) * 2 / (n + 2)
    found = {"alpha_excess": alpha / both / both, "beta_excess": beta / both / both}
    return builder.graph({f"{name}{OVER}": each for name, each in found.items()}, names)


def cycle_drift() -> Graph:
    """What a cycle of two indices adds to gains of the recursive form, over the square."""
    builder = GraphBuilder()
    n, e, both, names = _pair(builder)
    alpha = (n * n + n * e + e * e + (n + e) * 3 + 2) / (n * (n + 2)) * (1 / (e * (e + 2)))
    beta = (n + e + 3) / (n + 2) * (2 / (e + 2))
    found = {"alpha_drift": alpha / both, "beta_drift": beta / both}
    return builder.graph({f"{name}{OVER}": each for name, each in found.items()}, names)


def mismatch_variances() -> Graph:
    """Variances with the gains of the nominal index, and over the least ones."""
    builder = GraphBuilder()
    nominal, index = builder.symbol("nominal_index"), builder.symbol("tracking_index")
    n, names = excess_of_deviation(builder, nominal, "nominal_root")
    e, more = excess_of_deviation(builder, index, "root")
    ratio = index / nominal
    square = ratio * ratio
    one, other = n + 1, e + 1
    part = n / (n + 2)
    share = part / one
    found = {
        "predicted_11": part * ((n * 2 + 3) + square * (one * one)),
        "updated_11": share * ((n + 3) + square / one),
        "updated_22": share * (n * n * 2) * (square * ((n + 3) / one) + 1),
    }
    least = {
        "predicted_11": e * (e + 2),
        "updated_11": e / other * ((e + 2) / other),
        "updated_22": e / other * (e / other) * (e * 4),
    }
    found["predicted_22"] = found["updated_22"] + index * index
    least["predicted_22"] = e * e * (e / other) * 4
    names = names | more
    ratios = {f"{name}_ratio": found[name] / least[name] for name in found}
    return builder.graph(found | ratios, names)


def line_of_sight_gains() -> Graph:
    """One block of the turned gain: the entries xx, xy and yy of alpha, or of beta."""
    builder = GraphBuilder()
    along, across, cosine, sine = (
        builder.symbol(name) for name in ("along", "across", "cosine", "sine")
    )
    square, other = cosine * cosine, sine * sine
    return builder.graph(
        {
            "gain_xx": along * square + across * other,
            "gain_xy": (along - across) * (cosine * sine),
            "gain_yy": along * other + across * square,
        }
    )
