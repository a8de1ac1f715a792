"""The kernels of a two-state family as expression graphs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.steady_state import inverses, poles
from gainproof.derive.steady_state.forms import Basis, times

Names = dict[str, Node]
SHIFT = 30  # h is taken as 2^30 sqrt(h^2/2^60), so that 4/Lambda cannot overflow


def graph_basis(builder: GraphBuilder, e: Fraction, n: Fraction) -> tuple[Basis, Names]:
    """Lambda and the quantities made from it as nodes, with their names."""
    index = builder.symbol("tracking_index")
    p = builder.sqrt(index)
    half = p / 2
    names: Names = {"p": p, "half_p": half}
    if e == 0:
        h = 2 / p
        s = builder.sqrt(index / 4 + 2)
    else:
        small = Fraction(4, 4**SHIFT) / index + index * (e / 4 / 4**SHIFT)
        names["h_scaled"] = builder.sqrt(small)
        h = names["h_scaled"] * 2**SHIFT
        # s^2 = (1 + e) p (p + 4 h/(1 + e))/4, so taken that nothing overflows before s does
        if e == 1:
            names["s_half"] = builder.sqrt((p / 4) * (half + h))
            s = names["s_half"] * 2
        else:
            s = builder.sqrt(times((1 + e) / 4, p) * (p + h * (4 / (1 + e))))
    basis = Basis(index, p, half, h, s, e, n)
    names |= {"h": h, "s": s, "m": basis.m}
    return basis, names


FormsOf = Callable[[Basis], Mapping[str, Any]]


def index_graph(e: Fraction, n: Fraction, *parts: FormsOf) -> Graph:
    """The graph of the outputs of one or more forms; a name met again is prefixed d_."""
    builder = GraphBuilder()
    basis, names = graph_basis(builder, e, n)
    outputs: dict[str, Any] = {}
    for part in parts:
        for key, value in part(basis).items():
            outputs[f"d_{key}" if key in outputs else key] = value
    return builder.graph(outputs, names)


def alpha_graph(e: Fraction, output: str) -> Graph:
    """beta or the index as a function of alpha."""
    builder = GraphBuilder()
    alpha = builder.symbol("alpha")
    radical = inverses.alpha_radical(alpha, e, builder.sqrt)
    names = {"alpha_radical": radical}
    if output == "beta":
        return builder.graph({"beta": inverses.beta_from_alpha(alpha, radical)}, names)
    names["root_of_rest"] = builder.sqrt(1 - alpha)
    index = inverses.index_from_alpha(alpha, radical, names["root_of_rest"])
    return builder.graph({"tracking_index": index}, names)


def beta_graph(e: Fraction, output: str) -> Graph:
    """alpha or the index as a function of beta."""
    builder = GraphBuilder()
    beta = builder.symbol("beta")
    scale = inverses.SCALE if output == "alpha" else 1
    radical = inverses.beta_radical(beta, e, builder.sqrt, scale)
    names = {"beta_radical" if scale == 1 else "scaled_beta_radical": radical}
    if output == "alpha":
        return builder.graph({"alpha": inverses.alpha_from_beta(beta, e, radical, scale)}, names)
    names["root_of_e"] = builder.sqrt(builder.number(e))
    rest = inverses.rest_from_beta(beta, e, radical, names["root_of_e"])
    names["root_of_rest"] = builder.sqrt(rest)
    return builder.graph({"tracking_index": beta / names["root_of_rest"]}, names)


def largest_beta(e: Fraction) -> Graph:
    """The supremum 2/(1 + sqrt(e)) of the velocity gain as a constant graph."""
    builder = GraphBuilder()
    if e in (0, 1):
        return builder.graph({"value": builder.number(2 / (1 + e))})
    root = builder.sqrt(builder.number(e))
    return builder.graph({"value": (2 - 2 * root) / (1 - e)}, {"root_of_e": root})


def pole_graph(e: Fraction, n: Fraction) -> Graph:
    """Both closed-loop poles, each as real and imaginary part, and their moduli."""
    builder = GraphBuilder()
    x, names = graph_basis(builder, e, n)
    mean_modulus = x.inverse_deviation
    if e == 1:
        middle, width = poles.centre(x, None), poles.half_width(x, None, None)
        return builder.graph(_outputs(middle, middle, width, -width, mean_modulus), names)
    limit = builder.number(8 / (1 - e))
    names["turning_root"] = builder.sqrt(builder.number(1 - e))
    turning = builder.number(4) if e == 0 else 4 / names["turning_root"]
    names["distance"] = builder.absolute(limit / 4 - x.index / 4)
    names["below"] = builder.sqrt(names["distance"])
    names["above"] = builder.sqrt(limit / 4 + x.index / 4)
    middle = poles.centre(x, turning)
    width = poles.half_width(x, names["below"], names["above"])
    names["middle_size"] = builder.absolute(middle)
    larger = names["middle_size"] + width
    smaller = (mean_modulus / larger) * mean_modulus

    def choose(name: str, complex_pair: Any, real_pair: Any) -> Node:
        names[name] = builder.select(x.index, limit, complex_pair, real_pair)
        return names[name]

    zero = builder.number(0)
    outputs = _outputs(
        choose("choice_1", middle, -larger),
        choose("choice_2", middle, -smaller),
        choose("choice_3", width, zero),
        choose("choice_4", -width, zero),
        mean_modulus,
    )
    outputs["first_modulus"] = choose("choice_5", mean_modulus, larger)
    outputs["second_modulus"] = choose("choice_6", mean_modulus, smaller)
    return builder.graph(outputs, names)


def _outputs(first: Any, second: Any, up: Any, down: Any, size: Any) -> dict[str, Any]:
    return {
        "first_real": first,
        "first_imaginary": up,
        "second_real": second,
        "second_imaginary": down,
        "first_modulus": size,
        "second_modulus": size,
    }
