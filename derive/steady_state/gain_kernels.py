"""The gains in forms chosen for few roundings, each of which counts little.

The root comes last: an error of what stands below it counts half, and the last operation alone
half a unit in the last place. So alpha is the root of its square, from 4/alpha^2 =
(rho + 1 + c/rho)^2 multiplied out, c = (1 - e)/4, where rho^2 = kappa + (1 + e)/4 needs no root.

For e = 0 kappa = 2/Lambda has one rounding. For other families kappa = eta/(2 Lambda), and eta^2 =
16 + e Lambda^2 would overflow. All forms are homogeneous in Lambda and 4, so that any pair a, b
with a : b = Lambda : 4 serves: Lambda and 4 themselves, which are exact, below `SWITCH`, and from
there on SWITCH and 4 SWITCH/Lambda, all times `UNIT`. SWITCH is no power of two: where beta comes
close to one from below, sums then do not come close to one from above, where their rounding weighs
most.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node

KERNELS = ("gains", "predictor_gains")
SWITCH = Fraction(3, 4)
"""The index from which the pair is scaled by it."""
UNIT = 2**54
"""Times this the least positive number is a normal one, and so are its products."""
RAISED = 2**30
"""Squares are those of numbers so many times as large: the least alpha has none that is normal."""
CHOICES = ("index_or_switch", "four_or_less")
LAST = Fraction(4, RAISED)
ROOT = Fraction(1, 2**27)
"""Times its square 2/Lambda is finite, and over it beta is normal, for every positive float64."""
Halves = tuple[Node, Callable[[], Node]]
"""What the root is taken of, and what makes beta after it."""


def gain_graph(e: Fraction, kernel: str) -> Graph:
    """The graph of the filter gain, or of the predictor gain F K: alpha + beta, and beta."""
    builder = GraphBuilder()
    index = builder.symbol("tracking_index")
    names: dict[str, Node] = {}
    at_once = kernel == "predictor_gains" and e == 1
    if e == 0:
        square, beta = _undamped(builder, index, names)
    else:
        square, beta = _damped(builder, index, e, names, at_once=at_once)
    root = names["position_raised" if at_once else "alpha_raised"] = builder.sqrt(square)
    first, second = root * LAST, beta()
    if kernel == "gains":
        return builder.graph({"alpha": first, "beta": second}, names)
    position = first if at_once else first + second
    return builder.graph({"position": position, "velocity": second}, names)


def _undamped(builder: GraphBuilder, index: Node, names: dict[str, Node]) -> Halves:
    """(RAISED alpha/4)^2 and beta for e = 0: kappa is a quotient, no index squared is needed."""
    unit = ROOT * ROOT
    kappa = (2 * unit) / index
    square = kappa + unit / 4
    names["rho_scaled"] = builder.sqrt(square)
    twice = names["rho_scaled"] * (2 * ROOT)
    z = (unit / 2) / twice
    total = square + (twice + (z * (z + 2) + Fraction(3, 2)) * unit)
    return (unit * RAISED**2 / 4) / total, lambda: (unit * 4) / (kappa * 2 + (twice + unit))


def _damped(
    builder: GraphBuilder, index: Node, e: Fraction, names: dict[str, Node], *, at_once: bool
) -> Halves:
    """(RAISED alpha/4)^2 and beta for e > 0; `at_once`: that of alpha + beta, which is 2/rho."""
    a = builder.select(index, SWITCH, index * UNIT, SWITCH * UNIT)
    b = builder.select(index, SWITCH, 4 * UNIT, (4 * SWITCH * UNIT) / index)
    eta = builder.sqrt(b * b + times(e, a * a))
    # 4 rho^2 a: times a it is the square of 2 rho a
    over = eta * 2 + times(1 + e, a)
    ratio = builder.sqrt(a * over)
    names |= {CHOICES[0]: a, CHOICES[1]: b, "eta_scaled": eta, "ratio_scaled": ratio}

    def beta() -> Node:
        return (a * 4) / (eta + (a + ratio))

    if at_once:
        return (a * RAISED**2) / over, beta
    # of the sum 4 rho^2 a + 8 rho a + 4 (1 + 2 c) a + 16 a (z + z^2) with z = c/(2 rho)
    rest = times(7 - e, a)
    if e != 1:
        z = times((1 - e) / 4, a) / ratio
        rest = rest + (a * 16) * (z * (z + 1))
    return (a * RAISED**2) / (eta * 2 + (ratio * 4 + rest)), beta


def times(number: Fraction, value: Node) -> Node:
    """number * value; a quotient by the denominator where the number is one over an integer."""
    if number == 1:
        return value
    return value / number.denominator if number.numerator == 1 else value * number
