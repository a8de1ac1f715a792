"""The recursion of position and velocity with measured position, over any intervals.

The derivation is the page `recursion-two-states` of `derive/pages`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.algebra.variables import above_zero, from_zero
from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.derivation import Derivation, Step, kernel_step
from gainproof.derive.expression import real
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed
from gainproof.derive.recursion import forms
from gainproof.derive.recursion.kernels import graphs
from gainproof.derive.recursion.names import (
    B1,
    B2,
    D1,
    D2,
    ENTRIES,
    FACTORS,
    PARAMETERS,
    Q,
    R,
    T,
    U,
    Y,
    predicted_names,
    start_names,
    step_names,
)
from gainproof.derive.recursion.noise import Noise, noises
from gainproof.derive.source import GAUSS_MARKOV, SPECTRAL
from gainproof.derive.subject import Program, Subject

NAME = "recursion-two-states"
Elements = dict[str, sp.Expr]
VARIANCE = ("1e-40", "1e40", ("1e-7", "1e9"))
TIME = ("1e-20", "1e20", ("1e-4", "1e4"))
STRENGTH = ("1e-40", "1e40", ("1e-7", "1e6"))

MEANINGS = {
    "diagonal_1": "d1, variance of the position where the velocity is known, m^2",
    "shear": "u, covariance of position and velocity over the velocity's variance, s",
    "diagonal_2": "d2, variance of the velocity, m^2/s^2",
    "position_gain": "gain of the position, dimensionless",
    "velocity_gain": "gain of the velocity, 1/s",
    "innovation_variance": "variance of the innovation, m^2",
    "covariance_11": "variance of the position, m^2",
    "covariance_12": "covariance of position and velocity, m^2/s",
    "covariance_22": "variance of the velocity, m^2/s^2",
    "last_sample": "real k; its whole part is the last sample of the fit",
}

SUMMARIES = {
    "covariance": "Covariance of position and velocity from its factors d1, u, d2.",
    "gains": "Kalman gain and variance of the innovation, before the position is measured.",
    "update": "Factors of the covariance after the position is measured.",
    "hand_over": "The last sample at which the gain of a line fitted by least squares is not below "
    "alpha.",
}
RESULTS = {"covariance": "Covariance", "gains": "Gains", "update": "Factors"}
PLAIN = "P = [1, u; 0, 1] diag(d1, d2) [1, 0; u, 1]"


def build() -> Subject:
    """Derive the recursion with the process noises of the two-state families."""
    known = noises()
    made = graphs(known)
    towers = (
        main_tower(known),
        intervals_tower(),
        entries_tower(),
        start_tower(known),
        pair_tower(),
        samples_tower(),
    )
    page = written(NAME, Given(towers, slots={noise.name: _slots(noise) for noise in known}))
    steps = (*page.steps, *(_program(name, graph, known) for name, graph in made.items()))
    return Subject(
        name=NAME,
        title=page.title,
        model=None,
        derivation=Derivation(page.opening, steps, (SPECTRAL.key, GAUSS_MARKOV.key), page.latex),
        towers=page.towers,
        programs={
            name: Program(
                {entry: PARAMETERS.get(entry, entry) for entry in symbols_of(graph)}, graph
            )
            for name, graph in made.items()
        },
        module=kernel_module(NAME, page.title, known, made),
        textbook=dict,
    )


def _slots(noise: Noise) -> dict[str, Any]:
    """What the prediction's part says of one noise."""
    return {
        "name": noise.name,
        "key": noise.name.replace("_", "-"),
        "gained": noise.velocity(Q, T),
        "middle": T / 2 if noise.share else sp.Integer(0),
        "own": noise.position(Q, T) or sp.Integer(0),
        "middle_words": "`t/2`" if noise.share else "0",
        "own_words": f"`q t^3/{1 / noise.floor}` of its own and " if noise.floor else "",
    }


def _program(name: str, graph: Graph, known: tuple[Noise, ...]) -> Step:
    tower = {"hand": "samples", "start": "start"}.get(name.split("_")[0], "main")
    return kernel_step(name, graph, _meant(name, graph, known), tower, roots={"root": real("root")})


def _meant(name: str, graph: Graph, known: tuple[Noise, ...]) -> dict[str, object]:
    """The quantity that each output stands for."""
    noise = next((each for each in known if name.endswith(each.name)), None)
    names = {output: output for output in graph["outputs"]}
    if noise is not None and name.startswith("start"):
        names = dict(zip(FACTORS, start_names(noise), strict=True))
    elif noise is not None and name.startswith("predict"):
        names = dict(zip(FACTORS, predicted_names(noise), strict=True))
    elif noise is not None:
        names = step_names(noise)
    elif name == "update":
        names = {output: f"updated_{output}" for output in FACTORS}
    return {output: real(meant) for output, meant in names.items()}


def main_tower(noises: tuple[Noise, ...]) -> Tower:
    """d1, d2 and r positive; u, t and q from 0 on: an uncorrelated start, two measurements at one
    time, no process noise.
    """
    given = forms.factors(D1, U, D2)
    elements = {**_entries("covariance", given), **_update("", given)}
    for noise in noises:
        elements |= _predicted(noise, given)
    parameters = (*above_zero("d1", "d2", "r"), *from_zero("u", "t", "q"))
    return Tower("main", parameters, (), elements)


def _entries(prefix: str, f: forms.Factors) -> Elements:
    return {f"{prefix}_{ij}": entry for ij, entry in zip(ENTRIES, forms.covariance(f), strict=True)}


def _update(prefix: str, f: forms.Factors) -> Elements:
    new = forms.updated(f, R)
    after = forms.factors(new.position, new.shear, new.velocity)
    return {
        f"{prefix}position_gain": new.position_gain,
        f"{prefix}velocity_gain": new.velocity_gain,
        f"{prefix}innovation_variance": new.innovation,
        f"{prefix}updated_diagonal_1": new.position,
        f"{prefix}updated_shear": new.shear,
        f"{prefix}updated_diagonal_2": new.velocity,
        **_entries(f"{prefix}updated", after),
    }


def _started(noise: Noise) -> Elements:
    first = forms.started(noise, T, Q, R)
    values = (first.position, first.shear, first.velocity)
    return dict(zip(start_names(noise), values, strict=True))


def _predicted(noise: Noise, given: forms.Factors) -> Elements:
    after = forms.predicted(noise, given, T, Q)
    new = forms.updated(after, R)
    outputs = (
        new.position,
        new.shear,
        new.velocity,
        new.position_gain,
        new.velocity_gain,
        new.innovation,
    )
    values = (after.position, after.shear, after.velocity)
    return {
        **_noise(noise),
        **dict(zip(predicted_names(noise), values, strict=True)),
        **_entries(f"{noise.name}_predicted", after),
        **dict(zip(step_names(noise).values(), outputs, strict=True)),
    }


def pair_tower() -> Tower:
    """Two covariances P and B, each with its gain and its update."""
    one, other = forms.factors(D1, U, D2), forms.factors(B1, Y, B2)
    elements = {
        **_entries("covariance", one),
        **_update("", one),
        **_entries("other", other),
        **_update("other_", other),
    }
    parameters = (*above_zero("d1", "d2", "b1", "b2", "r"), *from_zero("u", "y", "t"))
    return Tower("pair", parameters, (), elements)


def start_tower(noises: tuple[Noise, ...]) -> Tower:
    """Two positions, an interval above zero apart."""
    elements: Elements = {}
    for noise in noises:
        elements |= _noise(noise) | _started(noise)
    return Tower("start", (*above_zero("t", "r"), *from_zero("q")), (), elements)


def _noise(noise: Noise) -> Elements:
    matrix = noise.covariance
    return {
        f"{noise.name}_noise_{ij}": matrix[i, j]
        for ij, (i, j) in zip(ENTRIES, ((0, 0), (0, 1), (1, 1)), strict=True)
    }


def intervals_tower() -> Tower:
    """Two intervals, one after the other."""
    return Tower("intervals", from_zero("s", "t", "q"), (), {})


def entries_tower() -> Tower:
    """A covariance from the velocity's variance, the cross covariance and the determinant."""
    velocity, cross, determinant = (sp.Symbol(n, real=True) for n in ("c22", "c12", "det"))
    elements = {"c11": (determinant + cross**2) / velocity}
    return Tower("entries", (*above_zero("c22", "det"), *from_zero("c12")), (), elements)


def samples_tower() -> Tower:
    """k >= 1: the newest sample of a line fitted by least squares."""
    k = sp.Symbol("k", real=True)
    alpha = 2 * (2 * k + 1) / ((k + 1) * (k + 2))
    elements = {"alpha": alpha, "root": 2 * alpha * k + 3 * alpha - 4, "last_sample": k}
    return Tower("samples", (Parameter("k", above=None, start="1"),), (), elements)


def kernel_module(
    name: str, title: str, noises: tuple[Noise, ...], graphs: Mapping[str, Graph]
) -> Module:
    """The module of the recursion."""
    kernels = (_kernel(name, kernel, graph, noises) for kernel, graph in graphs.items())
    return catalogue_module(name, title, kernels)


def _kernel(name: str, kernel: str, graph: Graph, noises: tuple[Noise, ...]) -> Kernel:
    noise = next((each for each in noises if kernel.endswith(each.name)), None)
    symbols = symbols_of(graph)
    return Kernel(
        name=kernel,
        result=RESULTS.get(kernel, "".join(word.capitalize() for word in kernel.split("_"))),
        summary=_summary(kernel, noise),
        equations=_equations(kernel, noise),
        inputs=tuple(_input(kernel, entry, noise) for entry in INPUTS if entry in symbols),
        outputs=tuple(Output(entry, MEANINGS[entry]) for entry in graph["outputs"]),
        graph=graph,
        source=f"derivation {name}",
    )


INPUTS = (
    "diagonal_1",
    "shear",
    "diagonal_2",
    "interval",
    "strength",
    "measurement_variance",
    "alpha",
)
"""The order of arguments."""


def _input(kernel: str, entry: str, noise: Noise | None) -> Input:
    match entry:
        case "shear":
            return closed(entry, MEANINGS[entry], *TIME, zero=True)
        case "interval" if kernel.startswith("start"):
            return closed(entry, "t, time between the two positions, s", *TIME)
        case "interval":
            return closed(entry, "t, time since the covariance given, s", *TIME, zero=True)
        case "strength":
            assert noise is not None
            return closed(entry, f"q, {noise.meaning}", *STRENGTH, zero=True)
        case "measurement_variance":
            return closed(entry, "r, variance of the measured position, m^2", *VARIANCE)
        case "alpha":
            return Input(entry, "steady-state position gain", "0", "1")
    return closed(entry, MEANINGS[entry], *VARIANCE)


def _summary(kernel: str, noise: Noise | None) -> str:
    if noise is None:
        return SUMMARIES[kernel]
    title = noise.name.replace("_", " ")
    if kernel.startswith("start"):
        return f"Factors of the covariance after the first two positions, {title}."
    if kernel.startswith("predict"):
        return f"Factors of the covariance after an interval, {title}."
    return f"An interval, then a measured position: factors and gains, {title}."


def _equations(kernel: str, noise: Noise | None) -> tuple[str, ...]:
    update = (
        "diagonal_1 = d1 r/(d1 + r), shear = u r/(d1 + r), diagonal_2 = d2 (d1 + r)/S,",
        "position_gain = (d1 + u^2 d2)/S, velocity_gain = u d2/S,",
        "S = innovation_variance = d1 + u^2 d2 + r,",
    )
    match kernel:
        case "covariance":
            return (PLAIN,)
        case "gains":
            return (*update[1:], PLAIN)
        case "update":
            return (update[0], "S = d1 + u^2 d2 + r,", PLAIN)
        case "hand_over":
            return (
                "last_sample = (4 - 3 alpha + sqrt(16 - 16 alpha + alpha^2))/(2 alpha),",
                "where alpha = 2 (2 k + 1)/((k + 1) (k + 2))",
            )
    assert noise is not None
    if kernel.startswith("start"):
        return (
            "diagonal_1 = r (r/t^2 + c)/diagonal_2, shear = r/(t diagonal_2),",
            f"diagonal_2 = 2 r/t^2 + c, c = {_product(noise)},",
            PLAIN,
        )
    predict = (
        f"diagonal_1 = d1{_own(noise)} + (u + {'t/2' if noise.share else 't'})^2 d2 g/(d2 + g),",
        f"shear = ((u + t) d2{' + g t/2' if noise.share else ''})/(d2 + g), diagonal_2 = d2 + g,",
        f"g = {_gained(noise)},",
    )
    if kernel.startswith("predict"):
        return (*predict, PLAIN)
    return (*predict[:2], f"{predict[2]} then with these as d1, u, d2", *update, PLAIN)


def _own(noise: Noise) -> str:
    return f" + q t^3/{1 / noise.floor}" if noise.floor else ""


def _gained(noise: Noise) -> str:
    return ("q", "q t", "q t^2")[noise.power]


def _product(noise: Noise) -> str:
    return _gained(noise) if noise.chord == 1 else f"{_gained(noise)}/{1 / noise.chord}"
