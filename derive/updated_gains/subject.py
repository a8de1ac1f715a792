"""Gains that follow the tracking index to first order: errors, limits, drift, variances.

The derivation is the page `updated-gains` of `derive/pages`; here is what it does not say.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.derivation import Derivation
from gainproof.derive.expression import real
from gainproof.derive.families.random_acceleration import model
from gainproof.derive.model import scale
from gainproof.derive.pages.derivation import FOLDER, Given, written
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node, symbols_of
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed, signed
from gainproof.derive.source import KALATA, MATRICES, UPDATED
from gainproof.derive.steady_state.names import LATEX
from gainproof.derive.subject import Program, Subject
from gainproof.derive.updated_gains.words import EQUATIONS, MEANINGS, SUMMARIES

NAME = "updated-gains"
INPUTS = {"alpha": "nominal_alpha", "beta": "nominal_beta", "next_index": "following_index"}
"""Of `recursive_gains`: the gains so far are any; those of a third index stand for them."""
ROOTS = {
    "nominal_root": "1 + 2/n",
    "root": "1 + 2/e",
    "deviation": "sigma_i",
    "s": "s",
    "u": "u",
    "v": "v",
}
BOUNDS = {
    "0": End(boundary={"s": sp.Integer(1), "u": sp.Integer(1), "v": sp.Integer(2)}),
    "infinity": End(
        weights={"s": 1, "u": 1, "v": 1},
        constants={"root_5": 5},
        boundary={"s": real("root_5"), "u": sp.Integer(2), "v": real("root_5")},
    ),
}
HINTS = {
    "alpha-bound-other": {"form": "(4 n^2 + 10 n + 1)/(s + n) + 1"},
    "alpha-bound-small": {"limit_form": "((1 + (5 n + 10)/(s + 1))/2)^2 2 (1 + n)/(s + n + 1)"},
}
"""Without the differences that hide a sign or a limit."""
INDEX = ("1e-12", "1e12", ("1e-5", "1e5"))
GAIN = ("1e-30", "1e30", ("1e-9", "1e9"))
BY_TERMS = {"next_alpha", "next_beta"}
"""Sums of a gain and a step of either sign."""
DOMAINS: dict[str, Input] = {
    name: closed(name, MEANINGS[name], *domain)
    for name, domain in {
        "nominal_index": INDEX,
        "tracking_index": INDEX,
        "next_index": INDEX,
        "acceleration_deviation": ("1e-30", "1e30", ("1e-6", "1e6")),
        "interval": ("1e-15", "1e15", ("1e-6", "1e6")),
        "variance": ("1e-60", "1e60", ("1e-12", "1e12")),
        "along": GAIN,
        "across": GAIN,
    }.items()
} | {
    name: signed(name, MEANINGS[name], *domain)
    for name, domain in {
        "alpha": GAIN,
        "beta": GAIN,
        "cosine": ("0", "2", ("0", "2")),
        "sine": ("0", "2", ("0", "2")),
    }.items()
}
Names = dict[str, Node]


def build(folder: Path = FOLDER) -> Subject:
    """Derive errors, limits and drift of first-order gains, and what wrong gains cost.

    `folder`: where the page is. Raises PageError with the line of a mistake on it.
    """
    made, scaled = graphs(), scale(model())
    given = Given(
        models={"random_acceleration": scaled.data()},
        hints=HINTS,
        ends={"bounds": BOUNDS},
        programs=made,
        roots=ROOTS,
    )
    page = written(NAME, given, folder)
    sources = (KALATA.key, MATRICES.key, UPDATED.key)
    latex = {**LATEX, **page.latex, "root_3": r"\sqrt{3}", "root_5": r"\sqrt{5}"}
    return Subject(
        name=NAME,
        title=page.title,
        model=scaled,
        derivation=Derivation(page.opening, page.steps, sources, latex),
        towers=page.towers,
        programs={name: Program(_inputs(name, graph), graph) for name, graph in made.items()},
        module=kernel_module(NAME, page.title, made),
        textbook=dict,
    )


def _inputs(name: str, graph: Graph) -> dict[str, str]:
    named = INPUTS if name == "recursive_gains" else {}
    return {symbol: named.get(symbol, symbol) for symbol in symbols_of(graph)}


def kernel_module(name: str, title: str, made: Mapping[str, Graph]) -> Module:
    """The module of gains that follow the index."""
    kernels = (_kernel(name, kernel, graph) for kernel, graph in made.items())
    return catalogue_module(name, title, kernels)


def _kernel(name: str, kernel: str, graph: Graph) -> Kernel:
    symbols = symbols_of(graph)
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=SUMMARIES[kernel],
        equations=EQUATIONS[kernel],
        inputs=tuple(DOMAINS[symbol] for symbol in symbols),
        outputs=tuple(
            Output(entry, MEANINGS[entry], by_terms=entry in BY_TERMS) for entry in graph["outputs"]
        ),
        graph=graph,
        source=f"derivation {name}",
    )


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
