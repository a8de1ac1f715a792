"""The named quantities of the recursion of two states, and how they are printed."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.recursion.noise import Noise

D1, U, D2, T, Q, R = map(real, ("d1", "u", "d2", "t", "q", "r"))
B1, Y, B2 = map(real, ("b1", "y", "b2"))
PARAMETERS = {
    "diagonal_1": "d1",
    "shear": "u",
    "diagonal_2": "d2",
    "interval": "t",
    "strength": "q",
    "measurement_variance": "r",
}
"""The parameter that each input of a kernel stands for."""
ENTRIES = ("11", "12", "22")
GAINS = ("position_gain", "velocity_gain")
FACTORS = ("diagonal_1", "shear", "diagonal_2")

LATEX = {
    "d1": "d_1",
    "u": "u",
    "d2": "d_2",
    "b1": "b_1",
    "y": "y",
    "b2": "b_2",
    "t": "t",
    "s": "s",
    "q": "q",
    "r": "r",
    "k": "k",
    "z": "z",
    "position_gain": "K_1",
    "velocity_gain": "K_2",
    "other_position_gain": "C_1",
    "other_velocity_gain": "C_2",
    "innovation_variance": "S",
    "updated_diagonal_1": "f_1",
    "updated_shear": "v",
    "updated_diagonal_2": "f_2",
    "alpha": r"\alpha_k",
    "root": r"\rho",
    **{f"g{ij}": f"G_{{{ij}}}" for ij in ENTRIES},
    **{f"covariance_{ij}": f"P_{{{ij}}}" for ij in ENTRIES},
    **{f"updated_{ij}": f"X_{{{ij}}}" for ij in ENTRIES},
    **{f"other_{ij}": f"B_{{{ij}}}" for ij in ENTRIES},
    **{f"other_updated_{ij}": f"Y_{{{ij}}}" for ij in ENTRIES},
}


def latex(noises: tuple[Noise, ...]) -> dict[str, str]:
    """Symbols in print, with those of each noise."""
    own: dict[str, str] = {}
    for noise in noises:
        own |= {f"{noise.name}_noise_{ij}": f"Q_{{{ij}}}" for ij in ENTRIES}
        own |= {f"{noise.name}_predicted_{ij}": f"M_{{{ij}}}" for ij in ENTRIES}
        own |= dict(zip(predicted_names(noise), ("e_1", "w", "e_2"), strict=True))
        own |= dict(zip(start_names(noise), ("d_1", "u", "d_2"), strict=True))
    return {**LATEX, **own}


def predicted_names(noise: Noise) -> tuple[str, str, str]:
    """Names of the predicted factors."""
    first, shear, second = (f"{noise.name}_{factor}" for factor in FACTORS)
    return first, shear, second


def start_names(noise: Noise) -> tuple[str, str, str]:
    """Names of the factors after two positions."""
    first, shear, second = (f"{noise.name}_start_{factor}" for factor in FACTORS)
    return first, shear, second


def step_names(noise: Noise) -> dict[str, str]:
    """Names of what one step gives, by output of its kernel."""
    outputs = (*FACTORS, *GAINS, "innovation_variance")
    return {output: f"{noise.name}_step_{output}" for output in outputs}


def symmetric(prefix: str) -> sp.ImmutableDenseMatrix:
    """The symmetric matrix of named entries."""
    first, cross, second = (real(f"{prefix}_{ij}") for ij in ENTRIES)
    return sp.ImmutableDenseMatrix([[first, cross], [cross, second]])


def rows(prefix: str) -> list[list[str]]:
    """The names of its entries."""
    first, cross, second = (f"{prefix}_{ij}" for ij in ENTRIES)
    return [[first, cross], [cross, second]]


def sheared(first: sp.Expr, shear: sp.Expr, second: sp.Expr) -> sp.MatMul:
    """U D U'."""
    upper = shear_matrix(shear)
    diagonal = sp.ImmutableDenseMatrix([[first, 0], [0, second]])
    return sp.MatMul(upper, diagonal, upper.T, evaluate=False)


def shear_matrix(shear: sp.Expr) -> sp.ImmutableDenseMatrix:
    """[1, x; 0, 1]: F over an interval x, and U."""
    return sp.ImmutableDenseMatrix([[1, shear], [0, 1]])
