"""The named quantities of the recursion of two states."""

from __future__ import annotations

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
