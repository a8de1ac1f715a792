"""The kernels of a two-state family as expression graphs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.steady_state import inverses, poles
from gainproof.derive.steady_state.forms import Basis

Names = dict[str, Node]


def unit_root(e: Fraction) -> Fraction:
    """The root of the unit of a kernel's basis.

    Times the unit 2/Lambda is finite, and over it (e = 0: twice it) beta is normal, for every
    positive float64; its square keeps e Lambda/4 out of the way of float32's least numbers.
    """
    return Fraction(1, 2**27 if e == 0 else 2**26)


def graph_basis(builder: GraphBuilder, e: Fraction, n: Fraction) -> tuple[Basis, Names]:
    """Lambda and the quantities made from it as nodes, with their names."""
    index = builder.symbol("tracking_index")
    names: Names = {}
    root = unit_root(e)
    unit = root * root
    if e == 0:
        kappa = (2 * unit) / index
        half_eta = builder.number(2 * unit)
    else:
        # a square of Lambda could overflow: eta/2 = p h and kappa = h/p with p = sqrt(Lambda)
        names["p"] = builder.sqrt(index)
        small = (4 * unit * unit) / index + index * (e / 4 * unit * unit)
        names["h_scaled"] = builder.sqrt(small)
        kappa = names["h_scaled"] / names["p"]
        half_eta = names["p"] * names["h_scaled"]
    names["rho_scaled"] = builder.sqrt(kappa + unit * (1 + e) / 4)
    rho, twice = names["rho_scaled"] * root, names["rho_scaled"] * (2 * root)
    basis = Basis(index, kappa, rho, twice, half_eta, e, n, unit, root)
    return basis, names | {"kappa": kappa, "rho": rho, "twice_rho": twice, "half_eta": half_eta}


FormsOf = Callable[[Basis], Mapping[str, Any]]


@dataclass(frozen=True)
class NodesOf:
    """Forms that need more than the basis: `made` gives outputs, with names of nodes."""

    made: Callable[[GraphBuilder, Fraction, Fraction], tuple[Mapping[str, Any], Names]]


Part = FormsOf | NodesOf


def index_graph(e: Fraction, n: Fraction, *parts: Part) -> Graph:
    """The graph of the outputs of one or more forms; a name met again is prefixed d_."""
    builder = GraphBuilder()
    outputs: dict[str, Any] = {}
    names: Names = {}
    for part in parts:
        found, own = _made(builder, e, n, part)
        names |= own
        for key, value in found.items():
            outputs[f"d_{key}" if key in outputs else key] = value
    return builder.graph(outputs, names)


def _made(
    builder: GraphBuilder, e: Fraction, n: Fraction, part: Part
) -> tuple[Mapping[str, Any], Names]:
    if isinstance(part, NodesOf):
        return part.made(builder, e, n)
    basis, names = graph_basis(builder, e, n)
    return part(basis), names


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
    mean_modulus = x.inverse_deviation()
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
