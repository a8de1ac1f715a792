"""The named quantities of the recursion of three states, and how they are printed."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.recursion.triple_noise import TripleNoise

D1, D2, D3, A, B, C = map(real, ("d1", "d2", "d3", "a", "b", "c"))
S, T, Q, R = map(real, "stqr")
PARAMETERS = {
    "diagonal_1": "d1",
    "diagonal_2": "d2",
    "diagonal_3": "d3",
    "first_shear": "a",
    "second_shear": "b",
    "third_shear": "c",
    "first_interval": "s",
    "interval": "t",
    "strength": "q",
    "measurement_variance": "r",
}
"""The parameter that each input of a kernel stands for."""
ENTRIES = ("11", "12", "13", "22", "23", "33")
PLACES = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
GAINS = ("position_gain", "velocity_gain", "acceleration_gain")
FACTORS = tuple(PARAMETERS)[:6]
GIVEN = ("d_1", "d_2", "d_3", "a", "b", "c")
PRINTED = ("e_1", "e_2", "e_3", r"\alpha", r"\beta", r"\gamma")

LATEX = {
    **{name: name for name in ("a", "b", "c", "t", "s", "q", "r", "k", "z")},
    "det": r"\det P",
    "minor": "m",
    "mixed": "n",
    "alpha": r"\alpha_k",
    **{f"d{i}": f"d_{i}" for i in (1, 2, 3)},
    **{gain: f"K_{i}" for i, gain in enumerate(GAINS, 1)},
    "innovation_variance": "S",
    **{f"updated_{name}": latex for name, latex in zip(FACTORS, PRINTED, strict=True)},
    **{f"covariance_{ij}": f"P_{{{ij}}}" for ij in ENTRIES},
    **{f"updated_{ij}": f"X_{{{ij}}}" for ij in ENTRIES},
    **{f"{letter}{ij}": f"{letter.upper()}_{{{ij}}}" for letter in "pbgc" for ij in ENTRIES},
    **{
        f"{name}_{i}{j}": f"{letter}_{{{i}{j}}}"
        for name, letter in (("w", "W"), ("newer", "A"), ("older", "B"))
        for i in (2, 3)
        for j in (1, 2, 3)
    },
}


def latex(noises: tuple[TripleNoise, ...]) -> dict[str, str]:
    """Symbols in print, with those of each noise."""
    own: dict[str, str] = {}
    for noise in noises:
        own |= {f"{noise.name}_noise_{ij}": f"Q_{{{ij}}}" for ij in ENTRIES}
        own |= {f"{noise.name}_predicted_{ij}": f"M_{{{ij}}}" for ij in ENTRIES}
        own |= dict(zip(predicted_names(noise), PRINTED, strict=True))
        own |= dict(zip(start_names(noise), GIVEN, strict=True))
    return {**LATEX, **own}


def predicted_names(noise: TripleNoise) -> tuple[str, ...]:
    """Names of the predicted factors."""
    return tuple(f"{noise.name}_{factor}" for factor in FACTORS)


def start_names(noise: TripleNoise) -> tuple[str, ...]:
    """Names of the factors after three positions."""
    return tuple(f"{noise.name}_start_{factor}" for factor in FACTORS)


def symmetric(prefix: str) -> sp.ImmutableDenseMatrix:
    """The symmetric matrix of named entries."""
    return filled([real(f"{prefix}_{ij}") for ij in ENTRIES])


def filled(entries: list[sp.Expr]) -> sp.ImmutableDenseMatrix:
    """The symmetric matrix of entries 11, 12, 13, 22, 23, 33."""
    at = dict(zip(PLACES, entries, strict=True))
    return sp.ImmutableDenseMatrix(3, 3, lambda i, j: at[min(i, j), max(i, j)])


def rows(prefix: str) -> list[list[str]]:
    """The names of its entries."""
    return [[f"{prefix}_{min(i, j)}{max(i, j)}" for j in (1, 2, 3)] for i in (1, 2, 3)]


def first_shear(amount: sp.Expr) -> sp.ImmutableDenseMatrix:
    """Adds so much of the velocity to the position."""
    return sp.ImmutableDenseMatrix([[1, amount, 0], [0, 1, 0], [0, 0, 1]])


def second_shear(amount: sp.Expr) -> sp.ImmutableDenseMatrix:
    """Adds so much of the acceleration to the velocity."""
    return sp.ImmutableDenseMatrix([[1, 0, 0], [0, 1, amount], [0, 0, 1]])


def upper(a: sp.Expr, b: sp.Expr, c: sp.Expr) -> sp.ImmutableDenseMatrix:
    """U."""
    return sp.ImmutableDenseMatrix([[1, a + c, a * b], [0, 1, b], [0, 0, 1]])


def transition(t: sp.Expr) -> sp.ImmutableDenseMatrix:
    """F over an interval."""
    return sp.ImmutableDenseMatrix([[1, t, t**2 / 2], [0, 1, t], [0, 0, 1]])


def sheared(values: tuple[sp.Expr, ...]) -> sp.MatMul:
    """U D U' of six factors."""
    d1, d2, d3, a, b, c = values
    diagonal = sp.ImmutableDenseMatrix(sp.diag(d1, d2, d3))
    return sp.MatMul(upper(a, b, c), diagonal, upper(a, b, c).T, evaluate=False)
