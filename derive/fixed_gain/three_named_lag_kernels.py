"""Random acceleration and random jerk of three states by lag, random jerk by its position gain.

Both are curves over x = 2 beta/gamma; their lag is a polynomial of degree three or four in x. What
is solved for is written so that the map of the fixed point has positive terms only:

    random acceleration, x + 2 = 4 s:     s^4 = lag/2 + lag s + s^2/4  (s^3 = lag + s^2/2, s + 1/2)
    random jerk, x = 1 + 2 w:             12 lag (1 + 2 w) = (1 + w)^2 (2 + 6 w + 3 w^2)
        by lag, 1 + w = c + 1/z with c^3 = 4 lag:
            c^2 (c (c - 1) + 1/3) z^4 = 1 + 4 c z + (6 c^2 - 1/3) z^2 + 2 c (c^2 - 1/3) z^3
        by alpha, r = 1 - alpha:          3 alpha w^4 = 2 r + 10 r w + (1 + 17 r) w^2 + 12 r w^3
"""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.printer.fixed_point import fixed_point, near_cbrt
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node

Inner = list[Node]


def _fourth_root(builder: GraphBuilder, value: Node, inner: Inner) -> Node:
    inner.append(builder.sqrt(value))
    return builder.sqrt(inner[-1])


def _eighth_root(builder: GraphBuilder, value: Node, inner: Inner) -> Node:
    inner.append(builder.sqrt(value))
    return _fourth_root(builder, inner[-1], inner)


def _eighth_power(a: Node, b: Node, c: Node, d: Node) -> tuple[Node, ...]:
    """z^8 = r3 z^3 + r2 z^2 + r1 z + r0 from z^4 = a z^3 + b z^2 + c z + d.

    Both have the one positive z: the first is the second times a polynomial with positive terms.
    Of its eighth root the slope is 3/8 at most, not 3/4.
    """
    first = a
    second = a * first + b
    third = a * second + b * first + c
    fourth = a * third + b * second + c * first + d
    return (
        a * fourth + b * third + c * second + d * first,
        b * fourth + c * third + d * second,
        c * fourth + d * third,
        d * fourth,
    )


def _polynomial(coefficients: tuple[Node, ...], u: Node) -> Node:
    """Horner's rule, the highest power first."""
    found, *rest = coefficients
    for entry in rest:
        found = found * u + entry
    return found


def random_acceleration_by_lag() -> Graph:
    """The gains and the variance at the lag 1/gamma."""
    builder = GraphBuilder()
    lag = builder.symbol("lag")
    half = lag / 2
    inner: Inner = []
    root = fixed_point(
        near_cbrt(lag) + builder.number("9/50"),
        lambda s: _fourth_root(builder, (s / 4 + lag) * s + half, inner),
        within="1/16",
    )
    square = root * root
    x = lag * 4 / square
    beyond = (lag * 2 - 1) * 32 / ((x + 6) * x + 16)
    variance = (x * 5 + 6) * 4 * x / beyond / (beyond * (x + 2) * 3 + 8)
    outputs = _named("random_acceleration", x / (square * 2), 2 / square, 1 / lag, variance)
    return builder.graph(outputs, {"root": root, "root_of_map": inner[0]})


def random_jerk_by_lag() -> Graph:
    """The gains of random jerk; rounding in float32 leaves too little of a variance."""
    builder = GraphBuilder()
    lag = builder.symbol("lag")
    four = lag * 4
    outer: Inner = []
    inner: Inner = []
    third = builder.number("1/3")
    c = fixed_point(
        near_cbrt(four), lambda u: _fourth_root(builder, four * u, outer), within="1/25"
    )
    above = (four - 1) / ((c + 1) * c + 1)
    size = c * c * (c * above + third)
    second = above * (c + 1) * 6 + builder.number("17/3")
    last = (above * (c + 1) + builder.number("2/3")) * c * 2
    start = ((c + builder.number("16/25")) * c + builder.number("1/5")) / (
        c * c * c * builder.number("13/50")
    )
    rest = _eighth_power(last / size, second / size, c * 4 / size, 1 / size)
    z = fixed_point(
        start,
        lambda u: _eighth_root(builder, _polynomial(rest, u), inner),
        within="1/32",
    )
    x = (above + 1 / z) * 2 + 1
    outputs = {
        "random_jerk_alpha": (x * x * 3 + 1) / (lag * 24),
        "random_jerk_beta": x / (lag * 2),
        "random_jerk_gamma": 1 / lag,
    }
    names = {"c": c, "c_of_map": outer[0], "z": z, "z_of_map": inner[1], "z_inside": inner[0]}
    return builder.graph(outputs, names)


def variance_of(x: Node, d: Node, m: Node) -> Node:
    """The variance of the predicted position of any stable filter."""
    more = x + 1
    w = x * more
    total = w + m
    return ((m + w * more) / m + (total / d) * (total / m)) / x


def random_jerk_by_gain() -> Graph:
    """beta, gamma and the variance of random jerk at a gain of the position below 1."""
    builder = GraphBuilder()
    alpha = builder.symbol("alpha")
    rest = 1 - alpha
    triple = alpha * 3
    inner: Inner = []
    second = rest * 17 + 1
    # of v = 1/w: 12 r v + (1 + 17 r) v^2 and a part for 10 r v^3 + 2 r v^4 are 3 alpha
    part = rest * alpha * builder.number("8/5") / (rest + builder.number("3/40"))
    half = builder.sqrt(rest * rest * 36 + triple * (second + part))
    start = (rest * 6 + half) / triple
    square = alpha * alpha
    coefficients = _eighth_power(
        rest * 4, second * alpha / 3, rest * 10 * square / 3, rest * 2 * (square * alpha) / 3
    )
    # alpha w, which no power makes too large
    scaled = fixed_point(
        start * alpha,
        lambda u: _eighth_root(builder, _polynomial(coefficients, u), inner),
        within="1/14",
    )
    w = scaled / alpha
    x = w * 2 + 1
    more = w + 1
    square = more * more
    part = (w * 3 + 6) * w + 2
    below = square * part
    # 3 w^2 - 1, which is alpha below 1
    beyond = rest * (square / w) * (part / w)
    scale = x * 3
    d = (beyond * square * 2 + (w * 2 + 1)) / scale
    # 9 x^2 - 1 = 4 (1 + 3 w) (2 + 3 w), x^2 - 1 = 4 w (1 + w)
    m = (w * 3 + 1) * (w * 3 + 2) * (w * more) * 2 / scale
    return builder.graph(
        {
            "random_jerk_beta": x * x * 6 / below,
            "random_jerk_gamma": x * 12 / below,
            "random_jerk_predicted_11": variance_of(x, d, m),
        },
        {"half": half, "w": scaled, "w_of_map": inner[1], "w_inside": inner[0]},
    )


def _named(name: str, alpha: Node, beta: Node, gamma: Node, variance: Node) -> Mapping[str, Node]:
    return {
        f"{name}_alpha": alpha,
        f"{name}_beta": beta,
        f"{name}_gamma": gamma,
        f"{name}_predicted_11": variance,
    }
