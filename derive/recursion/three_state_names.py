"""The named quantities of the recursion of three states."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.recursion.three_state_noise import TripleNoise

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


def predicted_names(noise: TripleNoise) -> tuple[str, ...]:
    """Names of the predicted factors."""
    return tuple(f"{noise.name}_{factor}" for factor in FACTORS)


def start_names(noise: TripleNoise) -> tuple[str, ...]:
    """Names of the factors after three positions."""
    return tuple(f"{noise.name}_start_{factor}" for factor in FACTORS)


def filled(entries: list[sp.Expr]) -> sp.ImmutableDenseMatrix:
    """The symmetric matrix of entries 11, 12, 13, 22, 23, 33."""
    at = dict(zip(PLACES, entries, strict=True))
    return sp.ImmutableDenseMatrix(3, 3, lambda i, j: at[min(i, j), max(i, j)])


def transition(t: sp.Expr) -> sp.ImmutableDenseMatrix:
    """F over an interval."""
    return sp.ImmutableDenseMatrix([[1, t, t**2 / 2], [0, 1, t], [0, 0, 1]])
