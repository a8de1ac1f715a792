"""The kernels of a two-state family as expression graphs."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

from gainproof.derive.pages.kernel_formulas import (
    FIRST,
    formula_graph,
    formula_of,
    page_values,
)
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.steady_state import gain_kernels, inverses
from gainproof.derive.steady_state.names import INDEX, KAPPA, PREDICTED, RHO, ROOT_3, UPDATED

FORMULAS = Path(__file__).with_name("kernels.md")
"""What the outputs are computed by; says how a formula is checked and how to make another."""

GAINS = ("alpha", "beta")
PREDICTOR = ("position", "velocity")
KERNELS: Mapping[str, tuple[str, ...]] = {
    "gains": GAINS,
    "gain_derivatives": GAINS,
    "gains_with_derivatives": (*GAINS, *(f"{FIRST}{name}" for name in GAINS)),
    "predictor_gains": PREDICTOR,
    "predictor_gain_derivatives": PREDICTOR,
    "predicted_covariance": PREDICTED,
    "predicted_covariance_derivatives": PREDICTED,
    "updated_covariance": UPDATED,
    "updated_covariance_derivatives": UPDATED,
    "gain_second_derivatives": GAINS,
    "predictor_gain_second_derivatives": PREDICTOR,
    "predicted_covariance_second_derivatives": PREDICTED,
    "updated_covariance_second_derivatives": UPDATED,
}
"""Outputs of the kernels of the index."""
AT_ONCE = "at_once_"
"""Begins the names of what gains with derivatives are computed by."""
SCALE = Fraction(1, 2**40)
"""Of h and r where e > 0: 16/Lambda stays finite and p normal in either format."""
HALF = Fraction(1, 2)
"""Does where e = 0: Lambda + 8 could overflow."""


def unit_root(e: Fraction) -> Fraction:
    """The root of the unit of a kernel's formulas.

    Times the unit 2/Lambda is finite, and over it (e = 0: twice it) beta is normal, for every
    positive float64; its square keeps e Lambda/4 out of the way of float32's least numbers.
    """
    return Fraction(1, 2**27 if e == 0 else 2**26)


def scale_of(e: Fraction) -> Fraction:
    """What h and r are multiplied by."""
    return SCALE if e else HALF


def index_graph(e: Fraction, n: Fraction, kernel: str) -> Graph:
    """The graph of a kernel of the index."""
    if kernel in gain_kernels.KERNELS:
        return gain_kernels.gain_graph(e, kernel)
    before = AT_ONCE if kernel == "gains_with_derivatives" else ""
    builder = GraphBuilder()
    known, names = _known(builder, e, n)
    outputs = {output: before + formula_of(kernel, output) for output in KERNELS[kernel]}
    return formula_graph(builder, FORMULAS, known, outputs, names)


def accurate_gains(e: Fraction, n: Fraction) -> Graph:
    """The graph of both gains by the page, for numbers of twice as many digits."""
    builder = GraphBuilder()
    known, names = _known(builder, e, n)
    return formula_graph(builder, FORMULAS, known, {name: name for name in GAINS}, names)


def symbolic_forms(
    e: Fraction, n: Fraction, names: Iterable[str], more: Mapping[str, Any] | None = None
) -> dict[str, Any]:
    """Formulas of the page over the named quantities, by name; `more` is known besides."""
    known: dict[str, Any] = {"Lambda": INDEX, "kappa": KAPPA, "rho": RHO, "twice": 2 * RHO}
    known |= {"half_eta": INDEX * KAPPA, "root_3": ROOT_3, "unit": Fraction(1), "e": e, "n": n}
    return page_values(FORMULAS, {**known, **(more or {})}, names)


def _known(
    builder: GraphBuilder, e: Fraction, n: Fraction
) -> tuple[dict[str, Any], dict[str, Node]]:
    """The nodes and numbers that formulas are over, and the names of nodes."""
    index = builder.symbol("tracking_index")
    root = unit_root(e)
    unit = root * root
    names = {"p": builder.sqrt(index), "root_of_3": builder.sqrt(builder.number(3))}
    p = names["p"]
    if e == 0:
        kappa, half_eta = (2 * unit) / index, builder.number(2 * unit)
    else:
        # a square of Lambda could overflow: eta/2 = p h and kappa = h/p with p = sqrt(Lambda)
        high = (4 * unit * unit) / index + index * (e / 4 * unit * unit)
        names["h_scaled"] = builder.sqrt(high)
        kappa, half_eta = names["h_scaled"] / p, p * names["h_scaled"]
    names["rho_scaled"] = builder.sqrt(kappa + unit * (1 + e) / 4)
    rho, twice = names["rho_scaled"] * root, names["rho_scaled"] * (2 * root)
    names |= {"kappa": kappa, "rho": rho, "twice_rho": twice, "half_eta": half_eta}
    known = {"Lambda": index, "kappa": kappa, "rho": rho, "twice": twice, "half_eta": half_eta}
    numbers = {"unit": unit, "root_3": names["root_of_3"], "e": e, "n": n}
    return {**known, **numbers, **_at_once(builder, e, index, names)}, names


def _at_once(
    builder: GraphBuilder, e: Fraction, index: Node, names: dict[str, Node]
) -> dict[str, Any]:
    """The nodes that gains with derivatives are over; `names` is told of roots."""
    scale, p = scale_of(e), names["p"]
    low, twice_p = p * scale, p * (2 * scale)
    if e == 0:
        h = (4 * scale) / p
        near, square = h, index * scale**2 + 8 * scale**2
    else:
        h = names["h_at_once"] = builder.sqrt((16 * scale**2) / index + index * (e * scale**2))
        near = low + h if e == 1 else gain_kernels.times(e, low) + h
        # the mean of both stands with 2 p under the root
        total = low + h
        square = twice_p * total if e == 1 else low * (total + near)
    r = names["twice_ratio"] = builder.sqrt(square)
    nodes = {"p": p, "low": low, "twice_p": twice_p, "h": h, "near": near, "r": r}
    return {**nodes, "scale": scale}


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
    known, names = _known(builder, e, n)
    index = known["Lambda"]
    if e == 1:
        middle, width, mean_modulus = _poles(known)
        return builder.graph(_outputs(middle, middle, width, -width, mean_modulus), names)
    limit = builder.number(8 / (1 - e))
    names["turning_root"] = builder.sqrt(builder.number(1 - e))
    turning = builder.number(4) if e == 0 else 4 / names["turning_root"]
    names["distance"] = builder.absolute(limit / 4 - index / 4)
    names["below"] = builder.sqrt(names["distance"])
    names["above"] = builder.sqrt(limit / 4 + index / 4)
    roots = {"turning": turning, "below": names["below"], "above": names["above"]}
    middle, width, mean_modulus = _poles({**known, **roots})
    names["middle_size"] = builder.absolute(middle)
    larger = names["middle_size"] + width
    smaller = (mean_modulus / larger) * mean_modulus

    def choose(name: str, complex_pair: Any, real_pair: Any) -> Node:
        names[name] = builder.select(index, limit, complex_pair, real_pair)
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


def _poles(known: Mapping[str, Any]) -> tuple[Any, Any, Any]:
    """The mean of the poles, half their distance, and the root of their product."""
    names = ("centre", "half_width", "inverse_sigma")
    found = page_values(FORMULAS, known, names)
    return found["centre"], found["half_width"], found["inverse_sigma"]


def _outputs(first: Any, second: Any, up: Any, down: Any, size: Any) -> dict[str, Any]:
    return {
        "first_real": first,
        "first_imaginary": up,
        "second_real": second,
        "second_imaginary": down,
        "first_modulus": size,
        "second_modulus": size,
    }
