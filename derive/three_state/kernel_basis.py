"""What every kernel of the index is made of: the root of the three equations, scaled.

With p = sqrt(Lambda) and r = sqrt(p) the nodes are X = xi r/2, E = eta p/4, C = delta p/8, which
neither over- nor underflow with the index:

C = sqrt(1/Lambda + e Lambda/64), E = sqrt(a2 Lambda/16 + 2 C X r), X = sqrt(a1 p/4 + 2 E).

X is the fixed point of the last two, a map with a logarithmic slope between 0 and 1/4. It starts
from xi^3 ~ (1 + b)^3 + 64/Lambda, which has the right value at both ends of the index.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from gainproof.derive.printer.fixed_point import fixed_point_values, near_cbrt
from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.three_state.graph_constants import graph_constants
from gainproof.derive.three_state.spectrum import Spectrum

START_WITHIN = "1/8"
UNIT = Fraction(1, 2**26)  # times its square 1/Lambda is finite for every positive float64


@dataclass(frozen=True)
class KernelBasis:
    """The nodes; `names` of what has a value in the tower."""

    index: Node
    p: Node
    r: Node
    x: Node
    e: Node
    c: Node
    names: dict[str, Node]

    @property
    def total(self) -> Node:
        """N = p/8 + X r/4 + E/2 + C."""
        return (self.c + self.e * Fraction(1, 2)) + (
            self.x * self.r * Fraction(1, 4) + self.p * Fraction(1, 8)
        )

    @property
    def deviation(self) -> Node:
        """sigma = p N."""
        return self.p * self.total


def kernel_basis(builder: GraphBuilder, spectrum: Spectrum) -> KernelBasis:
    """The index and the quantities made from it as nodes, with their names."""
    index = builder.symbol("tracking_index")
    k = graph_constants(builder, spectrum)
    names: dict[str, Node] = dict(k.names)
    names["p"] = p = builder.sqrt(index)
    names["r"] = r = builder.sqrt(p)
    c = scaled_delta(builder, spectrum, index, p, names)
    least = 1 + k.b
    cube = least * least * least
    slope = (c * r) * 2
    outside, inside = p * (spectrum.a1 / 4), index * (spectrum.a2 / 16)

    def step(x: Node) -> tuple[Node, ...]:
        eta = builder.sqrt(slope * x + inside if spectrum.a2 else slope * x)
        names["eta_of_map"] = eta
        xi = builder.sqrt(eta * 2 + outside)
        return xi, eta

    start = near_cbrt((p * r) * (cube * Fraction(1, 8)) + 8 / r)
    x, e = fixed_point_values(start, step, START_WITHIN)
    names |= {"x": x, "e": e}
    return KernelBasis(index, p, r, x, e, c, names)


def scaled_delta(
    builder: GraphBuilder, spectrum: Spectrum, index: Node, p: Node, names: dict[str, Node]
) -> Node:
    """C = delta p/8; `names` is told of its root where there is one."""
    if not spectrum.e:
        return 1 / p
    square = UNIT * UNIT
    names["c_scaled"] = builder.sqrt(square / index + index * (spectrum.e / 64 * square))
    return names["c_scaled"] * (1 / UNIT)
