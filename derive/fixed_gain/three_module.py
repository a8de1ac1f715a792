"""The printed module of alpha-beta-gamma filters: kernels, what they say, what they compute."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.names import MEANINGS
from gainproof.derive.fixed_gain.three_curve_towers import BY_GAIN, BY_LAG, curve_roots
from gainproof.derive.fixed_gain.three_kernel_words import EQUATIONS, SUMMARIES
from gainproof.derive.fixed_gain.three_kernels import UPDATED, graphs
from gainproof.derive.fixed_gain.three_noise_kernels import TURNING, noise_graphs
from gainproof.derive.fixed_gain.three_noises import TOWER as NOISE_TOWER
from gainproof.derive.fixed_gain.three_noises import noise_meanings
from gainproof.derive.fixed_gain.three_pole_kernels import MEANINGS as POLE_MEANINGS
from gainproof.derive.fixed_gain.three_pole_kernels import POLES, pole_input, pole_meanings
from gainproof.derive.fixed_gain.three_pole_kernels import TOWER as POLE_TOWER
from gainproof.derive.fixed_gain.three_pole_kernels import TURNING as POLE_TURNING
from gainproof.derive.fixed_gain.three_towers import ALPHA, BETA, GAMMA, MARGIN
from gainproof.derive.fixed_gain.two_kernels import SCALE, difference
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed
from gainproof.derive.relation import Relation

SCALES = {
    "updated_12": "updated_12" + SCALE,
    "updated_13": "updated_13" + SCALE,
    "updated_23": "updated_23" + SCALE,
    "updated_velocity_lag": "predicted_velocity_lag",
    **{name: name + SCALE for name in POLE_TURNING},
}
NOISE_SCALES = {name: name + SCALE for name in TURNING}
REASON = "changes its sign"
NOISE_REASON = "terms of both signs"
TOWERS = {
    "minimum_variance_by_lag": "minimum_variance",
    "random_acceleration_by_lag": "stable_acceleration",
    "random_jerk_by_lag": BY_LAG,
    "random_jerk_by_gain": BY_GAIN,
    "random_acceleration_by_gain": "stable_acceleration",
    **dict.fromkeys(noise_graphs(), NOISE_TOWER),
    POLES: POLE_TOWER,
}
LEAST_LAGS = {
    "minimum_variance": "1/8",
    "random_acceleration": "1/2",
    "random_jerk": "69/128",  # x = 2, just inside
}
SYMBOLS = {"linear_coefficient": "x", "cubic_coefficient": "d", "hurwitz_determinant": "m"}
OWN_MEANINGS = {
    "lag": "1/gamma, lag of the predicted position behind a constant jerk j over j T^3",
    "share": "gamma over its largest stable value 2 alpha beta/(2 - alpha)",
    "cubic_coefficient": "d, that of s^3",
    "hurwitz_determinant": "m = x y - d with y the coefficient of s^2",
    **POLE_MEANINGS,
}


def kernel_module(name: str, title: str, made: Mapping[str, Graph]) -> Module:
    """The module of alpha-beta-gamma filters."""
    kernels = (_kernel(name, kernel, graph) for kernel, graph in made.items())
    return catalogue_module(name, title, kernels)


def _kernel(name: str, kernel: str, graph: Graph) -> Kernel:
    symbols = symbols_of(graph)
    named = graph.get("names", {})
    meanings, scales, reason = {**MEANINGS, **OWN_MEANINGS}, SCALES, REASON
    if TOWERS.get(kernel) == NOISE_TOWER:
        scales, reason = NOISE_SCALES, NOISE_REASON
        meanings |= {x: f"added to the {meanings[x]}" for x in meanings if x[-2:].isdigit()}
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=SUMMARIES[kernel],
        equations=EQUATIONS[kernel],
        inputs=tuple(_input(kernel, symbol, meanings[symbol]) for symbol in symbols),
        outputs=tuple(
            Output(entry, meanings[entry], scales[entry] if difference(entry) in named else None)
            for entry in graph["outputs"]
            if not entry.endswith(SCALE)
        ),
        graph=graph,
        source=f"derivation {name}",
        cancellations={difference(x): reason for x in scales if difference(x) in named},
    )


def _input(kernel: str, entry: str, meaning: str) -> Input:
    if kernel == POLES:
        return pole_input(entry, meaning)
    if entry == "lag":
        low = LEAST_LAGS[kernel.removesuffix("_by_lag")]
        return Input(entry, meaning, low, "1e30", True, False, single=(low, "1e9"))
    if kernel.endswith("_by_gain"):
        return Input(entry, meaning, "1e-15", "1", False, True, single=("1e-6", "1"))
    if entry in ("alpha", "share"):
        return closed(entry, meaning, "1e-20", "0.999999", ("1e-5", "0.99999"))
    if entry == "beta":
        return closed(entry, meaning, "1e-20", "1.9999999", ("1e-5", "1.99999"))
    return closed(entry, meaning, "1e-20", "1e20", ("1e-4", "1e4"))


def kernel_steps(made: Mapping[str, Graph]) -> list[Step]:
    """The kernels compute what they say."""
    e, cube = real("e"), real("cube")
    roots = {
        "minimum_variance_by_lag": {"root": cube, "root_of_map": cube**2},
        "random_acceleration_by_lag": {"root": 1 + e / 4, "root_of_map": (1 + e / 4) ** 2},
        "random_acceleration_by_gain": {"root": e / (4 + e)},
        **curve_roots(),
    }
    return [
        Step(
            f"kernel-{name.replace('_', '-')}",
            f"The kernel {name} computes what it says.",
            Relation("program", {"program": name, "outputs": _meant(name, graph)}),
            "Evaluate the kernel's graph as a rational function.",
            tower=TOWERS.get(name, "main"),
            hint={"graph": graph, "roots": roots.get(name, {})},
            shown=False,
        )
        for name, graph in made.items()
    ]


def _meant(kernel: str, graph: Graph) -> dict[str, sp.Expr]:
    """What each output stands for, over the names of its tower."""
    if kernel == POLES:
        return pole_meanings()
    if TOWERS.get(kernel) == NOISE_TOWER:
        return noise_meanings(kernel, graph)
    if kernel == UPDATED:
        x, y, d, m = (real(name) for name in "xydm")
        parts = {"12": x * (x + 1) * (1 + y + x) / 4, "13": (m + x + x**2) / 2, "23": x * (x + 1)}
        scales = {f"updated_{ij}{SCALE}": 8 * part / (d * m) for ij, part in parts.items()}
        return {output: scales.get(output, real(output)) for output in graph["outputs"]}
    g = 2 * ALPHA * BETA - GAMMA * (2 - ALPHA)
    gap, below = 2 * BETA - GAMMA, g * MARGIN
    known: dict[str, sp.Expr] = {
        "margin": MARGIN,
        **{name: real(symbol) for name, symbol in SYMBOLS.items()},
        "predicted_position_lag": 1 / GAMMA,
        "predicted_velocity_lag": (12 * ALPHA + 6 * BETA + GAMMA) / (12 * GAMMA),
        "predicted_acceleration_lag": (2 * BETA + GAMMA) / (2 * GAMMA),
        "updated_position_lag": (1 - ALPHA) / GAMMA,
        "updated_velocity_lag": (12 * ALPHA - 6 * BETA + GAMMA) / (12 * GAMMA),
        "updated_acceleration_lag": gap / (2 * GAMMA),
        "updated_12" + SCALE: BETA * (2 * ALPHA + BETA) * gap / below,
        "updated_13" + SCALE: GAMMA * (2 * g + BETA * gap) / below,
    }

    def meaning(output: str) -> sp.Expr:
        for prefix in ("minimum_variance_", "random_acceleration_", "random_jerk_"):
            if output.startswith(prefix):
                return real(output.removeprefix(prefix))
        return known.get(output, real(output))

    return {output: meaning(output) for output in graph["outputs"]}


__all__ = ["graphs", "kernel_module", "kernel_steps"]
