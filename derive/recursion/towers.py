"""The parameters of the recursion of two states, and what is made of them."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.algebra.variables import above_zero, from_zero
from gainproof.derive.recursion import forms
from gainproof.derive.recursion.names import (
    B1,
    B2,
    D1,
    D2,
    ENTRIES,
    Q,
    R,
    T,
    U,
    Y,
    predicted_names,
    start_names,
    step_names,
)
from gainproof.derive.recursion.noise import Noise

Elements = dict[str, sp.Expr]


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
