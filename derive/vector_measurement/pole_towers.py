"""Towers for the closed-loop poles: the steady state with S on either side of 1/sqrt(f), and the
index alone, over which the poles turn real.
"""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.expression import real
from gainproof.derive.steady_state.towers import surd
from gainproof.derive.vector_measurement import poles
from gainproof.derive.vector_measurement.names import ETA, INDEX, LEVEL, RATIO, ROOT, SIGMA
from gainproof.derive.vector_measurement.pole_kernels import NEGATIVE, POSITIVE
from gainproof.derive.vector_measurement.process_noise import Noise
from gainproof.derive.vector_measurement.towers import (
    rational,
    steady_elements,
    steady_generators,
    symbolic_noise,
)

X = real("x")
POLES, BELOW, ABOVE, TURNING = "poles", "poles_below", "poles_above", "turning"


def place(noise: Noise) -> sp.Expr:
    """1/sqrt(f) over a tower's root."""
    return surd(1 / poles.slope(noise))[0]


def centre_place(noise: Noise) -> sp.Expr:
    """1/sqrt(g) over a tower's root."""
    return surd(1 / poles.centre(noise))[0]


def _constants(*values: Fraction) -> tuple[Generator, ...]:
    """The roots of integers in 1/sqrt of these numbers, those that are not 0."""
    names: dict[str, int] = {}
    for value in values:
        names |= surd(1 / value)[1] if value else {}
    return tuple(Generator(name, sp.Integer(number)) for name, number in names.items())


def pole_elements(noise: Noise) -> dict[str, sp.Expr]:
    """The steady state with half the sum of the poles."""
    one_end = INDEX * (LEVEL if noise.determinant else 1)
    return {**steady_elements(noise), "pole_mean": (ETA - one_end) / (4 * SIGMA)}


def steady_pole_tower(noise: Noise) -> Tower:
    """The main tower after the roots of the poles' constants."""
    parameters = (Parameter("p"), Parameter("velocity_ratio"))
    generators = (*_constants(poles.slope(noise), poles.centre(noise)), *steady_generators(noise))
    return Tower(POLES, parameters, generators, pole_elements(noise))


def side_towers(noise: Noise) -> tuple[Tower, Tower]:
    """The steady state for S below 1/sqrt(f), as 1/((1 + x) sqrt(f)), and from there on."""
    return (
        _side_tower(noise, BELOW, place(noise) / (1 + X), 1 + X, Parameter("x")),
        _side_tower(
            noise, ABOVE, place(noise) + X, sp.Integer(1), Parameter("x", above=None, start="0")
        ),
    )


def _side_tower(
    noise: Noise, name: str, ratio: sp.Expr, multiple: sp.Expr, parameter: Parameter
) -> Tower:
    """The steady state over p and x; the roots are multiplied by `multiple` to be polynomials."""
    generators = list(_constants(poles.slope(noise)))
    values: dict[sp.Expr, sp.Expr] = {RATIO: ratio}
    for entry in steady_generators(noise):
        square = sp.cancel(sp.sympify(entry.radicand).subs(values) * multiple**2)
        generators.append(Generator(f"side_{entry.symbol}", sp.expand(square)))
        values[real(entry.symbol)] = real(f"side_{entry.symbol}") / multiple
    elements: dict[str, sp.Expr] = {"velocity_ratio": ratio}
    elements |= {str(symbol): value for symbol, value in values.items() if symbol != RATIO}
    elements |= pole_elements(noise)
    return Tower(name, (Parameter("p"), parameter), tuple(generators), elements)


def turning_tower(noise: Noise) -> Tower:
    """p and S with r, where it is not 1, and the two 1/S^2 at which the poles turn real."""
    numbers, index = symbolic_noise(noise), ROOT**2
    squared = poles.spread_squared(numbers, index)
    generators = [] if squared is None else [Generator("spread_root", sp.expand(squared))]
    distance = 2 * spread_root(noise) / INDEX
    centre = rational(poles.centre(noise))
    elements = {
        "tracking_index": index,
        POSITIVE: centre + distance,
        NEGATIVE: centre - distance,
    }
    return Tower(
        TURNING, (Parameter("p"), Parameter("velocity_ratio")), tuple(generators), elements
    )


def spread_root(noise: Noise) -> sp.Expr:
    """r over the turning tower."""
    return real("spread_root") if poles.spread(noise) else sp.Integer(1)


def pole_towers(noise: Noise) -> tuple[Tower, ...]:
    """All of them; where e = 1 no value of S changes what is computed."""
    sides = () if noise.e == 1 else side_towers(noise)
    return (steady_pole_tower(noise), *sides, turning_tower(noise))
