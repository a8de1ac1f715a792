"""Kernels of three-state filter gains, from the spectrum's factor in scaled form: for tests.

With p the root of the tracking index L and r that of p, xi = X r and eta = Y p solve
eta^2 = a2 L + 2 chi r xi and xi^2 = a1 p + 2 eta, where chi^2 = 64/L + e L; alpha, beta and gamma
are 2 (eta + p), 4 xi r and 8 p over p + xi r + eta + chi.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from gainproof.derive.printer.fixed_point import fixed_point_values, near_cbrt
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node, Number
from gainproof.derive.printer.kernel import Input, Kernel, Output


@dataclass(frozen=True)
class Factor:
    """Of a noise: its a1, a2 and e, its matrix, and the start (start[0] 8 D + start[1])^(1/3)."""

    a1: Fraction
    a2: Fraction
    e: Fraction
    noise: tuple[tuple[str, str, str], ...]
    start: tuple[Fraction, Fraction]


FACTORS: Mapping[str, Factor] = {
    "increments": Factor(
        Fraction(2),
        Fraction(1),
        Fraction(0),
        (("0", "0", "0"), ("0", "0", "0"), ("0", "0", "1")),
        (Fraction(13, 12), Fraction(26, 3)),
    ),
    "held": Factor(
        Fraction(5, 3),
        Fraction(7, 9),
        Fraction(1, 9),
        (("1/36", "1/12", "1/6"), ("1/12", "1/4", "1/2"), ("1/6", "1/2", "1")),
        (Fraction(18, 17), Fraction(31, 4)),
    ),
    "white": Factor(
        Fraction(2),
        Fraction(17, 15),
        Fraction(2, 15),
        (("1/20", "1/8", "1/6"), ("1/8", "1/3", "1/2"), ("1/6", "1/2", "1")),
        (Fraction(18, 17), Fraction(10)),
    ),
}

LARGE = 2**64  # keeps 64/L finite for the least numbers of both formats


def gains_graph(factor: Factor, within: Number = "1/16", push: Number = 1) -> Graph:
    """The gains; the start is multiplied by `push`."""
    b = GraphBuilder()
    index = b.symbol("tracking_index")
    p = b.sqrt(index)
    r = b.sqrt(p)
    if factor.e:
        chi = b.sqrt(Fraction(64, LARGE) / index + factor.e / LARGE * index) * 2**32
    else:
        chi = 8 / p
    cubed = chi * r
    near, shift = (number * Fraction(push) ** 3 for number in factor.start)
    start = near_cbrt(8 * near * cubed + shift * (p * r))
    slope, first, second = 2 * cubed, factor.a1 * p, factor.a2 * index

    def step(x: Node) -> tuple[Node, Node]:
        eta = b.sqrt(second + slope * x)
        return b.sqrt(first + 2 * eta), eta

    xi, eta = fixed_point_values(start, step, within)
    middle = xi * r
    whole = (eta + chi) + (middle + p)
    gains = {"alpha": 2 * (eta + p) / whole, "beta": 4 * middle / whole, "gamma": 8 * p / whole}
    return b.graph(gains, {"xi": xi, "eta": eta})


def gains_kernel(which: str, within: Number = "1/16", push: Number = 1) -> Kernel:
    """The kernel of one of the noises, for every index up to 1e300 (float32: 1e36)."""
    return Kernel(
        "gains",
        "Gains",
        "Filter gains of three states, position measured.",
        (),
        (Input("tracking_index", "the index", single=("0", 10**36), upper=10**300),),
        tuple(Output(name, "a gain") for name in ("alpha", "beta", "gamma")),
        gains_graph(FACTORS[which], within, push),
        "this test",
    )
