"""The printed module of a family: what each kernel is called and says of itself."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

from gainproof.derive.pages.kernel_page import page_module
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Module
from gainproof.derive.vector_measurement import forms, poles
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.derivative_kernels import DERIVATIVES, derivative_graph
from gainproof.derive.vector_measurement.kernels import FormsOf, known_graph, steady_graph
from gainproof.derive.vector_measurement.names import in_words
from gainproof.derive.vector_measurement.pole_kernels import pole_graphs
from gainproof.derive.vector_measurement.process_noise import Noise

WORDS = Path(__file__).with_name("kernels.md")
STEADY_KERNELS: Mapping[str, tuple[FormsOf, ...]] = {
    "gains": (forms.gains,),
    "predicted_covariance": (forms.predicted_covariance,),
    "updated_covariance": (forms.updated_covariance,),
}

VALUES = {True: ("[1e-8, 1e8]", "[1e-8, 1e8]"), False: ("[1e-8, 4e6]", "[1e-6, 1e8]")}
"""Domains in float32 of Lambda and S by whether the noise acts all through the interval.

Without noise in the position the updated cross covariance falls like S^4/Lambda^2, and is no normal
number of float32 beyond.
"""
DECADES = {True: ("5", "6"), False: ("4", "4")}
"""Of derivatives, where some are no normal number of float32 a decade earlier than others, by the
same.
"""
KNOWN = "known_velocity"
SEARCH = 4
"""How many times the boxes of other kernels those of the gains may be: 0.1 s a format.

With the usual number the gain of the position has bounds of 28.34, 12.33 and 10.30 * 2^-52 where
noise is continuous, constant over each interval and in the velocity, with this 9.32, 8.03, 10.11.
"""


def graphs(noise: Noise) -> dict[str, Graph]:
    """The graphs of all kernels of a family by name."""
    found = {name: steady_graph(noise, *parts) for name, parts in STEADY_KERNELS.items()}
    found |= {name: derivative_graph(noise, name) for name in DERIVATIVES}
    if noise.first:
        found[KNOWN] = known_graph(noise)
    return {**found, **pole_graphs(noise)}


def kernel_module(c: Context, graphs: Mapping[str, Graph]) -> Module:
    """The module of a family."""
    found = page_module(WORDS, graphs, c.model.name, c.model.title, words(c))
    kernels = (replace(x, search=SEARCH) if x.name == "gains" else x for x in found.kernels)
    return replace(found, kernels=tuple(kernels))


def words(c: Context) -> dict[str, str]:
    """What the page of kernels leaves open."""
    e, d, n, first = c.noise.e, c.noise.determinant, c.noise.n, c.noise.first
    centre, spread, slope = poles.centre(c.noise), poles.spread(c.noise), poles.slope(c.noise)
    single, narrow = VALUES[c.noise.interval], DECADES[c.noise.interval]
    (ratio,) = c.model.ratios.values()
    own = f"{centre} + " if centre else ""
    root = f"sqrt(1 + {_product(spread)})" if spread else "1"
    real: tuple[str, ...] = (f"positive_from = {own}2 r/Lambda, r = {root}",)
    if e != 1:
        last = f"negative_up_to = {centre} - 2 r/Lambda = product of both/positive_from"
        real = (f"{real[0]},", last)
    near = f"(16 + {_product(e)})" if e else "16"
    through = f"{near} (1 + t^2/4)", "eta/(4 + t^2)"
    eta, share = through if c.noise.interval else ("16 + Lambda^2 + 4 t^2", "sigma")
    return {
        "noise_ratio": in_words(c.model.noise_ratio),
        "ratio": in_words(ratio),
        **dict(zip(("single_index", "single_ratio"), single, strict=True)),
        **dict(zip(("narrow", "narrowest"), narrow, strict=True)),
        "rate": "(S^2 g + Lambda^2/sigma)/delta" if n else "delta h",
        "added": _product(1 - n),
        "first": f" + {_product(first)}" if first else "",
        "share": share,
        "level": f"w^2 = 1 + {d} t^2" if d else "w = 1",
        "eta": eta,
        "known": "\n".join(_known_equations(c)) if first else "",
        "mean": f"4/Lambda^2 + 1/S^2 - {slope}" if slope else "4/Lambda^2 + 1/S^2",
        "discriminant": (f"(1/S^2 - {centre})^2" if centre else "1/S^4")
        + (f" - {4 * spread}" if spread else ""),
        "real_poles": "\n".join(real),
    }


def _known_equations(c: Context) -> tuple[str, ...]:
    if not c.noise.determinant:
        own = _product(c.noise.first)
        return (f"predicted_11 = {own}, the limit for S -> 0; that of the updated variance is 0",)
    far = 16 / c.noise.e
    return (
        f"updated_11 = 2 Lambda/(Lambda + sqrt(Lambda^2 + {far})),",
        f"predicted_11 = updated_11 + {_product(c.noise.first)}: the limits for S -> 0",
    )


def _product(number: Fraction) -> str:
    """A number times Lambda^2."""
    return "Lambda^2" if number == 1 else f"Lambda^2/{1 / number}"
