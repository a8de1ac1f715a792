"""The closed-loop poles: the real one, and of the pair modulus, half sum and quarter discriminant.

The real pole has z = (1 + s)/(1 - s) with s = -1/t and t^2 = 1 + G, where G is the one positive
root of G (G^2 + (2 - m1) G + 1 - m1 + m2) = 64/Lambda^2. The other factor 1 + a s + g s^2 of d(s)
has g^2 = G^2 + (1 - m1) G + m2 and a^2 = m1 + 2 g - G, which is a sum for m1 <= 1. For V with
1/G = Lambda V the equation is V^3 = A + B V + 3 h V^2, and for Z = V - h it is
Z^3 = A + B h + 2 h^3 + (B + 3 h^2) Z: its fourth root, times Z, is a map with a logarithmic
slope between 1/4 and 1/2. Half sum and discriminant vanish at one index each; there G - G0 goes by
the difference of the index and that one.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from gainproof.derive.printer.fixed_point import fixed_point_values, near_cbrt
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.three_state.graph_constants import constant_root
from gainproof.derive.three_state.kernel_basis import KernelBasis, kernel_basis, scaled_delta
from gainproof.derive.three_state.spectrum import Spectrum

POLES = "closed_loop_poles"
REAL, MODULUS, MEAN, SQUARE = "real_pole", "modulus", "half_sum", "quarter_discriminant"
WITHIN, WITHIN_WIDELY = "1/13", "1/9"
"""The latter where V is the root of B for many indices."""


def pole_graph(spectrum: Spectrum) -> Graph:
    """The graph of the kernel.

    The noise is within reach of `pole_tower`.
    """
    builder = GraphBuilder()
    if spectrum.rational_in_root:
        k = kernel_basis(builder, spectrum)
        return builder.graph(_in_root(builder, k), k.names)
    return _over_level(builder, spectrum)


def _in_root(builder: GraphBuilder, k: KernelBasis) -> Mapping[str, Any]:
    """All is rational in xi: w = 1/sigma, half sum (xi^2 - 8)/(xi^2 + 2 xi), quarter discriminant
    4 (16 - 3 xi^2)/(xi^2 + 2 xi)^2.
    """
    names = k.names
    names["root_2"], names["root_3"] = builder.sqrt(2), builder.sqrt(3)
    xi = (k.x / k.r) * 2
    names["modulus_inverse"] = builder.sqrt(k.deviation)
    middle, turn = names["root_2"] * 2, names["root_3"] * Fraction(4, 3)

    def above(place: Any, number: int, limit: Any) -> Any:
        """(xi - place)/xi; `number` is the square of place, less 4, times 3."""
        below = xi * (xi + place) + Fraction(number, 3)
        return ((((limit - k.index) / below) / k.index) * (64 / limit)) / xi

    first = above(middle, 12, names["root_2"] * 4)
    second = above(turn, 4, names["root_3"] * 12)
    wide = xi + 2
    return {
        REAL: 1 / k.deviation,
        MODULUS: 1 / names["modulus_inverse"],
        MEAN: first * ((xi + middle) / wide),
        SQUARE: ((second / wide) * ((xi + turn) / xi)) / wide * -12,
    }


def _over_level(builder: GraphBuilder, s: Spectrum) -> Graph:
    """All over V."""
    names: dict[str, Node] = {}
    index = builder.symbol("tracking_index")
    names["p"] = p = builder.sqrt(index)
    v, inverse = _share(builder, s, index, p, names)
    names["v_root"] = root_of_v = builder.sqrt(v)
    level = inverse / index
    names["t"] = t = builder.sqrt(level + 1)
    g = ((scaled_delta(builder, s, index, p, names) * 8) / t) / p
    more = total(weighted(level, 1 - s.m1), s.m2 or None) if s.m1 < 1 or s.m2 else None
    square = total(g, s.m1 or None, None if more is None else more / (level + g))
    names["a"] = a = builder.sqrt(square)
    below, step, rise = (a + 1) + g, t + 1, 2 - s.m1

    def away(zero: Any, limit: Any) -> Any:
        """G - zero, where `limit` is the index at which G is `zero`."""
        part = builder.node(zero) / 64
        under = v + (inverse * part + index * (part * (zero + rise)))
        return ((((limit - index) / under) / index) * (limit + index)) * (1 / (limit * limit))

    middle = _middle(builder, s, names)
    names["middle_root"] = builder.sqrt(middle + (1 - s.m2))
    first = away(middle, 8 / names["middle_root"])
    outputs = {
        REAL: (level / step) / step,
        MODULUS: ((root_of_v / p) * 8) / below,
        MEAN: (first * ((level + (middle + (1 - s.m1))) / (g + 1))) / below,
    }
    whole, sharp = Fraction(2, 3) * rise, s.m1 * s.m1 - 4 * s.m2
    if sharp <= 0:
        # the discriminant is negative everywhere
        part = level * ((level + whole) / square)
        outputs[SQUARE] = (total(part, weighted(1 / square, -sharp / 3)) / below) / below * -3
        return builder.graph(outputs, names)
    root = constant_root(builder, rise * rise + 3 * sharp, "turning_surd", names)
    turn = sharp / (root + rise)
    names["turning_root"] = builder.sqrt(turn * (turn * (turn + rise) + (1 - s.m1 + s.m2)))
    second = away(turn, 8 / names["turning_root"])
    outputs[SQUARE] = ((second / below) * ((level + (turn + whole)) / square)) / below * -3
    return builder.graph(outputs, names)


def _middle(builder: GraphBuilder, s: Spectrum, names: dict[str, Node]) -> Any:
    """G where the half sum vanishes: G^2 + (1 - m1) G + m2 = 1."""
    less = 1 - s.m1
    root = constant_root(builder, less * less + 4 * (1 - s.m2), "middle_surd", names)
    return builder.node(2 * (1 - s.m2) / (root + less))


def _share(
    builder: GraphBuilder, s: Spectrum, index: Node, p: Node, names: dict[str, Node]
) -> tuple[Node, Node]:
    """V and its inverse, made of the nodes h and z, a certified root: they are h u and Z u.

    With u = 1/(Lambda^(-1/4) + Lambda/64) the fourth power of z stays between those of numbers and
    of Lambda^(-1/12), so that no index is too large for Newton's steps. `share`, which is
    u Lambda^(-1/4), and the square of u may be 0 for a large index, where they are added to what is
    not.
    """
    names["r"] = r = builder.sqrt(p)
    over = 1 / r
    u = 1 / (over + index * Fraction(1, 64))
    share = u * over
    a = (share * share) * ((share * over) * Fraction(1, 64))
    square, h = u * u, (index * u) * ((1 - s.m1 + s.m2) / 192)
    b, cube = square * ((2 - s.m1) / 64), (h * h) * h
    free, times = a + (h * b + cube * 2), (h * h) * 3 + b
    # near the root of b, which matters between both ends of the index
    between = Fraction(round(2**30 * 1.2 * float((2 - s.m1) / 64) ** 1.5), 2**30)
    flat = (2 - s.m1) ** 2 / (1 - s.m1 + s.m2)
    start = near_cbrt((a + (square * u) * between) + (h * (b * 2) + cube * 8))

    def step(z: Node) -> tuple[Node, ...]:
        names["inner"] = inner = builder.sqrt(z * (times * z + free))
        return (builder.sqrt(inner),)

    names["z"] = z = fixed_point_values(start, step, WITHIN if flat < 8 else WITHIN_WIDELY)[0]
    return (z + h) / u, u / (z + h)


def weighted(value: Any, number: Any) -> Any:
    """value times a number, or None where that is zero."""
    if number == 0:
        return None
    return value if number == 1 else value * number


def total(*terms: Any) -> Any:
    """The sum of those terms that are not None, from the left."""
    first, *others = (term for term in terms if term is not None)
    for term in others:
        first = first + term
    return first
