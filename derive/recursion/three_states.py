"""The recursion of position, velocity and acceleration with measured position, any intervals.

The derivation is the page `recursion-three-states` of `derive/pages`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.derivation import Derivation, Step, kernel_step
from gainproof.derive.expression import real
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed
from gainproof.derive.recursion.three_state_kernels import graphs
from gainproof.derive.recursion.three_state_names import (
    FACTORS,
    PARAMETERS,
    PLACES,
    S,
    T,
    filled,
    predicted_names,
    start_names,
    transition,
)
from gainproof.derive.recursion.three_state_noise import TripleNoise, triple_noises
from gainproof.derive.recursion.three_state_towers import (
    entries_tower,
    intervals_tower,
    pair_tower,
    predict_tower,
    samples_tower,
    start_tower,
    update_tower,
)
from gainproof.derive.source import GAUSS_MARKOV, SPECTRAL
from gainproof.derive.subject import Program, Subject

NAME = "recursion-three-states"
SHAPES = {
    "acceleration_increments": (sp.Integer(0), sp.Integer(0), sp.Integer(1)),
    "wiener_acceleration": (T**2 / 2, T, sp.Integer(1)),
    "random_jerk": (T**3 / 6, T**2 / 2, T),
}
"""What one unit of a noise of the samples does until the interval's end."""
VARIANCE = ("1e-30", "1e30", ("1e-4", "1e5"))
SHEAR = ("1e-15", "1e15", ("1e-3", "1e3"))
TIME = ("1e-10", "1e10", ("1e-2", "1e2"))
STRENGTH = ("1e-30", "1e30", ("1e-4", "1e4"))

MEANINGS = {
    "diagonal_1": "d1, variance of the position, velocity and acceleration known, m^2",
    "diagonal_2": "d2, variance of the velocity, acceleration known, m^2/s^2",
    "diagonal_3": "d3, variance of the acceleration, m^2/s^4",
    "first_shear": "a, s",
    "second_shear": "b, s",
    "third_shear": "c, s",
    "position_gain": "gain of the position, dimensionless",
    "velocity_gain": "gain of the velocity, 1/s",
    "acceleration_gain": "gain of the acceleration, 1/s^2",
    "innovation_variance": "variance of the innovation, m^2",
    "covariance_11": "variance of the position, m^2",
    "covariance_12": "covariance of position and velocity, m^2/s",
    "covariance_13": "covariance of position and acceleration, m^2/s^2",
    "covariance_22": "variance of the velocity, m^2/s^2",
    "covariance_23": "covariance of velocity and acceleration, m^2/s^3",
    "covariance_33": "variance of the acceleration, m^2/s^4",
}
SUMMARIES = {
    "covariance": "Covariance of position, velocity and acceleration from its factors.",
    "gains": "Kalman gain and variance of the innovation, before the position is measured.",
    "update": "Factors of the covariance after the position is measured.",
}
PLAIN = (
    "P = U diag(d1, d2, d3) U', U = [1, a + c, a b; 0, 1, b; 0, 0, 1]",
    "  = [1, a, 0; 0, 1, 0; 0, 0, 1] [1, 0, 0; 0, 1, b; 0, 0, 1] [1, c, 0; 0, 1, 0; 0, 0, 1]",
)
EQUATIONS = {
    "covariance": PLAIN,
    "gains": ("P H'/S, S = innovation_variance = H P H' + r, H = [1, 0, 0],", *PLAIN),
    "update": (
        "P - P H' H P/(H P H' + r) = U D U' with the factors that come, H = [1, 0, 0],",
        *PLAIN,
    ),
}
PREDICTION = (
    "F P F' + Q = U D U' with the factors that come, F = [1, t, t^2/2; 0, 1, t; 0, 0, 1],",
)
START = (
    "r W W' + A Q(t) A' + B Q(s) B' = U D U' with the factors that come; the state is",
    "W (z2, z1, z0)', the parabola through three positions, the newest first,",
    "W = [1, 0, 0; 1, -t, t^2/2; 1, -(s + t), (s + t)^2/2]^-1,",
    "A = W [0, 0, 0; 1, -t, t^2/2; 1, -(s + t), (s + t)^2/2],",
    "B = W [0, 0, 0; 0, 0, 0; 1, -s, s^2/2],",
)


def build() -> Subject:
    """Derive the recursion with the process noises of the three-state families."""
    known = triple_noises()
    made = graphs(known)
    towers = (
        update_tower(),
        intervals_tower(),
        entries_tower(),
        *map(predict_tower, known),
        start_tower(known),
        pair_tower(),
        samples_tower(),
    )
    page = written(NAME, Given(towers, slots={noise.name: _slots(noise) for noise in known}))
    steps = (*page.steps, *(_program(name, graph, known) for name, graph in made.items()))
    latex = {**page.latex, "det": r"\det P"}
    return Subject(
        name=NAME,
        title=page.title,
        model=None,
        derivation=Derivation(page.opening, steps, (SPECTRAL.key, GAUSS_MARKOV.key), latex),
        towers=page.towers,
        programs={
            name: Program({entry: PARAMETERS[entry] for entry in symbols_of(graph)}, graph)
            for name, graph in made.items()
        },
        module=kernel_module(NAME, page.title, known, made),
        textbook=dict,
    )


def _slots(noise: TripleNoise) -> dict[str, Any]:
    """What the shared parts say of one noise."""
    slots: dict[str, Any] = {
        "name": noise.name,
        "key": noise.name.replace("_", "-"),
        "words": noise.words,
    }
    if noise.continuous:
        return slots
    matrix = noise.covariance
    first, both = matrix.subs(T, S), matrix.subs(T, S + T)
    apart = transition(T) * first * transition(T).T + matrix - both
    return slots | {
        "shape": sp.ImmutableDenseMatrix(SHAPES[noise.name]),
        "noise": matrix,
        "first": first,
        "both": both,
        "left": filled([sp.factor(apart[place]) for place in PLACES]),
    }


def _program(name: str, graph: Graph, known: tuple[TripleNoise, ...]) -> Step:
    noise = next((each for each in known if name.endswith(each.name)), None)
    starts = name.startswith("start")
    names = {output: output for output in graph["outputs"]}
    if noise is not None:
        meant = start_names(noise) if starts else predicted_names(noise)
        names = dict(zip(FACTORS, meant, strict=True))
    elif name == "update":
        names = {output: f"updated_{output}" for output in FACTORS}
    outputs = {output: real(meant) for output, meant in names.items()}
    tower = "main" if noise is None else "start" if starts else noise.name
    return kernel_step(name, graph, outputs, tower)


def kernel_module(
    name: str, title: str, noises: tuple[TripleNoise, ...], graphs: Mapping[str, Graph]
) -> Module:
    """The module of the recursion."""
    kernels = (_kernel(name, kernel, graph, noises) for kernel, graph in graphs.items())
    return catalogue_module(name, title, kernels)


def _kernel(name: str, kernel: str, graph: Graph, noises: tuple[TripleNoise, ...]) -> Kernel:
    noise = next((each for each in noises if kernel.endswith(each.name)), None)
    symbols = symbols_of(graph)
    if noise is None:
        summary, equations = SUMMARIES[kernel], EQUATIONS[kernel]
    else:
        summary, equations = _of_noise(kernel, noise)
    results = {"covariance": "Covariance", "gains": "Gains", "update": "Update"}
    return Kernel(
        name=kernel,
        result=results.get(kernel, "".join(word.capitalize() for word in kernel.split("_"))),
        summary=summary,
        equations=equations,
        inputs=tuple(_input(kernel, entry, noise) for entry in PARAMETERS if entry in symbols),
        outputs=tuple(Output(entry, MEANINGS[entry]) for entry in graph["outputs"]),
        graph=graph,
        source=f"derivation {name}",
    )


def _of_noise(kernel: str, noise: TripleNoise) -> tuple[str, tuple[str, ...]]:
    """Summary and equations of a kernel with process noise."""
    title = noise.name.replace("_", " ")
    covariance = _covariance(noise)
    if kernel.startswith("start"):
        summary = f"Factors of the covariance after the first three positions, {title}."
        return summary, (*START, *(line.replace("Q =", "Q(t) =") for line in covariance), *PLAIN)
    summary = f"Factors of the covariance after an interval, {title}."
    return summary, (*PREDICTION, *covariance, *PLAIN)


def _covariance(noise: TripleNoise) -> tuple[str, ...]:
    """Q as its docstring says it."""
    rows = [
        ", ".join(str(entry).replace("**", "^").replace("*", " ") for entry in row)
        for row in noise.covariance.tolist()
    ]
    return (f"Q = [{'; '.join(rows)}],",)


def _input(kernel: str, entry: str, noise: TripleNoise | None) -> Input:
    if entry.endswith("shear"):
        return closed(entry, MEANINGS[entry], *SHEAR, zero=True)
    if entry == "first_interval":
        return closed(entry, "s, time between the first two positions, s", *TIME)
    if entry == "interval" and kernel.startswith("start"):
        return closed(entry, "t, time between the last two positions, s", *TIME)
    if entry == "interval":
        return closed(entry, "t, time since the covariance given, s", *TIME)
    if entry == "strength":
        assert noise is not None
        return closed(entry, f"q, {noise.meaning}", *STRENGTH, zero=True)
    if entry == "measurement_variance":
        return closed(entry, "r, variance of the measured position, m^2", *VARIANCE)
    return closed(entry, MEANINGS[entry], *VARIANCE)
