"""The parameters of the recursion of three states, and what is made of them."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.algebra.variables import above_zero, from_zero
from gainproof.derive.expression import real
from gainproof.derive.recursion import three_state_forms as forms
from gainproof.derive.recursion.three_state_names import (
    D1,
    D2,
    D3,
    ENTRIES,
    FACTORS,
    GAINS,
    PLACES,
    A,
    B,
    C,
    Q,
    R,
    S,
    T,
    predicted_names,
    start_names,
)
from gainproof.derive.recursion.three_state_noise import TripleNoise
from gainproof.derive.recursion.three_state_start import MATRICES, entry_names, started

Elements = dict[str, sp.Expr]
GIVEN = forms.Triple(D1, D2, D3, A, B, C)


def values_of(f: forms.Triple) -> tuple[sp.Expr, ...]:
    """d1, d2, d3, a, b, c."""
    return f.first, f.second, f.third, f.a, f.b, f.c


def entries_of(prefix: str, f: forms.Triple) -> Elements:
    """The covariance of factors."""
    return {f"{prefix}_{ij}": entry for ij, entry in zip(ENTRIES, forms.covariance(f), strict=True)}


def update_tower() -> Tower:
    """A covariance and what a measurement makes of it."""
    new = forms.updated(GIVEN, R)
    gains = (new.position_gain, new.velocity_gain, new.acceleration_gain)
    names = (f"updated_{name}" for name in FACTORS)
    elements = {
        **entries_of("covariance", GIVEN),
        **dict(zip(GAINS, gains, strict=True)),
        "innovation_variance": new.innovation,
        **dict(zip(names, values_of(new.factors), strict=True)),
        **entries_of("updated", new.factors),
    }
    parameters = (*above_zero("d1", "d2", "d3", "r"), *from_zero("a", "b", "c"))
    return Tower("main", parameters, (), elements)


def predict_tower(noise: TripleNoise) -> Tower:
    """A covariance and what an interval makes of it."""
    after = forms.predicted(noise, GIVEN, T, Q)
    noisy = {
        f"{noise.name}_noise_{ij}": noise.covariance[place]
        for ij, place in zip(ENTRIES, PLACES, strict=True)
    }
    elements = {
        **entries_of("covariance", GIVEN),
        **noisy,
        **dict(zip(predicted_names(noise), values_of(after), strict=True)),
    }
    parameters = (*above_zero("d1", "d2", "d3", "t"), *from_zero("a", "b", "c", "q"))
    return Tower(noise.name, parameters, (), elements)


def intervals_tower() -> Tower:
    """Two intervals, one after the other."""
    return Tower("intervals", from_zero("s", "t", "q"), (), {})


def pair_tower() -> Tower:
    """Any two covariances, whose entries are free, under the same measurement."""
    return Tower("pair", (*above_zero("r"), *from_zero("t")), (), {})


def entries_tower() -> Tower:
    """A covariance from its last entries, two minors and the determinant."""
    last, near, far, minor, mixed, determinant = map(
        real, ("c33", "c23", "c13", "minor", "mixed", "det")
    )
    middle = (minor + near**2) / last
    cross = (mixed + far * middle) / near
    first = (determinant + cross * (cross * last - far * near) - far * mixed) / minor
    parameters = (*above_zero("c33", "c23", "minor", "det"), *from_zero("c13", "mixed"))
    return Tower("entries", parameters, (), {"c22": middle, "c12": cross, "c11": first})


def start_tower(noises: tuple[TripleNoise, ...]) -> Tower:
    """Three positions, intervals above zero apart."""
    at = {symbol: symbol for symbol in (Q, S, T, R)}
    elements: Elements = {}
    for prefix in MATRICES:
        elements |= entry_names(prefix)
    for noise in noises:
        elements |= dict(zip(start_names(noise), values_of(started(noise, at)), strict=True))
    return Tower("start", (*above_zero("s", "t", "r"), *from_zero("q")), (), elements)


def samples_tower() -> Tower:
    """k >= 2: the newest sample of a parabola fitted by least squares."""
    k = real("k")
    alpha = 3 * (3 * k**2 + 3 * k + 2) / ((k + 1) * (k + 2) * (k + 3))
    return Tower("samples", (Parameter("k", above=None, start="2"),), (), {"alpha": alpha})
