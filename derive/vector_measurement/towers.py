"""The tower of radicals in which the steady state with position and velocity measured lives."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.expression import real
from gainproof.derive.vector_measurement import radicands
from gainproof.derive.vector_measurement.forms import Basis
from gainproof.derive.vector_measurement.names import (
    COUPLING,
    CROSS,
    DELTA,
    ETA,
    INDEX,
    LEVEL,
    MEAN,
    RATIO,
    ROOT,
    SIGMA,
    SPEED,
)
from gainproof.derive.vector_measurement.process_noise import Noise

LEVEL_SCALED, ETA_SCALED, DELTA_SCALED = map(real, ("level_scaled", "eta_scaled", "delta_scaled"))


def rational(value: Fraction) -> sp.Rational:
    """A fraction as a SymPy number."""
    return sp.Rational(value.numerator, value.denominator)


def symbolic_noise(noise: Noise) -> Noise:
    """The same numbers as SymPy's own, so that they mix with symbols."""
    return Noise(rational(noise.e), rational(noise.n))


def symbolic_basis(noise: Noise) -> Basis:
    """The basis of the stable forms over the named roots."""
    level = RATIO * LEVEL if noise.determinant else None
    return Basis(INDEX, RATIO, level, RATIO * ETA, RATIO * DELTA, symbolic_noise(noise))


def main_tower(noise: Noise, more: Mapping[str, sp.Expr] | None = None) -> Tower:
    """p = sqrt(Lambda), S > 0, and S w, S eta and S delta/p, whose squares are polynomials.

    For d = 0, w = 1 and its generator is left out.
    """
    parameters = (Parameter("p"), Parameter("velocity_ratio"))
    elements = {**steady_elements(noise), **(more or {})}
    return Tower("main", parameters, steady_generators(noise), elements)


def steady_generators(noise: Noise) -> tuple[Generator, ...]:
    """The roots of the steady state, times S, the last over p."""
    numbers, index = symbolic_noise(noise), ROOT**2
    generators = []
    width: sp.Expr = RATIO
    if noise.determinant:
        square = radicands.level_squared(numbers, index, RATIO)
        generators.append(Generator("level_scaled", sp.expand(square)))
        width = LEVEL_SCALED
    square = radicands.eta_squared(numbers, index, RATIO)
    generators.append(Generator("eta_scaled", sp.expand(square)))
    square = radicands.delta_squared(numbers, index, RATIO, width, ETA_SCALED)
    generators.append(Generator("delta_scaled", sp.expand(square / index)))
    return tuple(generators)


def steady_elements(noise: Noise) -> dict[str, sp.Expr]:
    """The named quantities over the generators.

    Differences are allowed here, where they make the fractions short: 1/sigma is (m - delta)/2.
    Without delta below the line the residuals are ten times shorter. The stable forms are proved
    equal to these.
    """
    one_end = INDEX * (LEVEL if noise.determinant else 1)
    share = ETA / (4 + SPEED**2) if noise.interval else SIGMA
    n, first = rational(noise.n), rational(noise.first)
    inverse = (MEAN - DELTA) / 2
    area = INDEX**2
    u12, u22 = real("updated_12"), real("updated_22")
    step = 2 * u12 + u22 + first * area
    elements: dict[str, sp.Expr] = {"tracking_index": ROOT**2, "velocity_index": INDEX / RATIO}
    if noise.determinant:
        elements["level"] = LEVEL_SCALED / RATIO
    return elements | {
        "eta": ETA_SCALED / RATIO,
        "delta": ROOT * DELTA_SCALED / RATIO,
        "mean_root": (one_end + ETA) / 2,
        "innovation_ratio": (MEAN + DELTA) / 2,
        "coupling": SPEED * share / RATIO,
        "cross_mean": INDEX / (COUPLING + (LEVEL if noise.determinant else 1)),
        "cross_rest": one_end - CROSS,
        "updated_12": CROSS * inverse,
        "updated_22": DELTA * CROSS - n * area,
        "updated_11": 1 - (u22 + area + RATIO**2) * inverse**2 / RATIO**2,
        "predicted_11": real("updated_11") + step,
        "predicted_12": CROSS * SIGMA,
        "predicted_22": DELTA * CROSS + (1 - n) * area,
        "gain_11": real("updated_11"),
        "gain_12": u12 / RATIO**2,
        "gain_21": u12,
        "gain_22": u22 / RATIO**2,
    }


def graph_roots(noise: Noise) -> dict[str, sp.Expr]:
    """Tower values of the roots in `kernels.graph_basis`."""
    roots = {"eta_scaled": RATIO * ETA, "delta_scaled": RATIO * DELTA}
    return {"level_scaled": RATIO * LEVEL, **roots} if noise.determinant else roots
