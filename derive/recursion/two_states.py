"""The recursion of position and velocity with measured position, over any intervals.

The derivation is the page `recursion-two-states` of `derive/pages`.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import sympy as sp

from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.algebra.variables import above_zero, from_zero
from gainproof.derive.derivation import Step, kernel_step
from gainproof.derive.expression import real
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.pages.kernel_page import page_module
from gainproof.derive.printer.graph import Graph
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
from gainproof.derive.subject import Subject, page_subject

NAME = "recursion-two-states"
WORDS = Path(__file__).with_name("two_states.md")
Elements = dict[str, sp.Expr]


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
    given = Given(
        towers,
        slots={noise.name: _slots(noise) for noise in known},
        steps={"kernels": [_program(name, graph, known) for name, graph in made.items()]},
    )
    page = written(NAME, given)
    module = page_module(WORDS, made, NAME, page.title)
    sources = SPECTRAL.key, GAUSS_MARKOV.key
    return page_subject(NAME, page, module, made, sources, {}, PARAMETERS)


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
