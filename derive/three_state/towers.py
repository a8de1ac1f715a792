"""The tower of a three-state steady state: one parameter, few constants, at most one root.

xi, eta, delta are the coefficients of d(s) = 1 + xi s + eta s^2 + delta s^3 with roots in the left
half plane. xi is the rational parameter: it lies above 1 + b, its value without measurement noise,
with b = sqrt(m1 + 2 c) and c = sqrt(m2).
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from gainproof.derive.algebra import tower as algebra
from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.expression import real
from gainproof.derive.model import ScaledModel
from gainproof.derive.steady_state.towers import rational, surd
from gainproof.derive.three_state import covariance_entries
from gainproof.derive.three_state.lowest_terms import common_denominator, over_parameter, quotients
from gainproof.derive.three_state.names import (
    ALPHA,
    BETA,
    DELTA,
    DEVIATION,
    ETA,
    GAMMA,
    INDEX,
    NU,
    PARAMETER,
    PREDICTED,
    XI,
)
from gainproof.derive.three_state.spectrum import Spectrum


@dataclass(frozen=True)
class Constants:
    """b and c over the generators of numbers, and these generators."""

    b: sp.Expr
    c: sp.Expr
    generators: tuple[Generator, ...]

    @property
    def least(self) -> sp.Expr:
        """1 + b, below which xi does not fall."""
        return 1 + self.b


def constants(spectrum: Spectrum) -> Constants:
    """c = sqrt(m2) and b = sqrt(m1 + 2 c) as rationals, surds, or a generator b."""
    c, names = surd(spectrum.m2) if spectrum.m2 else (sp.Integer(0), {})
    generators = [Generator(name, sp.Integer(number)) for name, number in names.items()]
    square = rational(spectrum.m1) + 2 * c
    if names:
        generators.append(Generator("b", square))
        return Constants(real("b"), c, tuple(generators))
    if square == 0:
        return Constants(sp.Integer(0), c, ())
    b, names = surd(Fraction(str(square)))
    generators = [Generator(name, sp.Integer(number)) for name, number in names.items()]
    return Constants(b, c, tuple(generators))


def scale_of_parameter(spectrum: Spectrum) -> sp.Expr:
    """p, or p^2 where the index holds a root: 4 over it is xi - (1 + b)."""
    return PARAMETER**2 if spectrum.m2 else PARAMETER


def main_tower(model: ScaledModel, spectrum: Spectrum) -> Tower:
    """The steady state over p > 0."""
    k, wide = constants(spectrum), scale_of_parameter(spectrum)
    xi, above, _ = _coefficients(k, wide)
    generators = list(k.generators)
    index: sp.Expr = 8 / DELTA
    if spectrum.m2:
        radicand = _radicand(k, wide, xi, above)
        generators.append(Generator("r", radicand))
        index = 16 * XI * wide**4 / real("r")
    elements = named_elements(model, spectrum, index)
    if spectrum.m2:
        elements |= _shortened(k, spectrum, elements)
    return Tower("main", (Parameter("p"),), tuple(generators), elements)


def named_elements(
    model: ScaledModel, spectrum: Spectrum, index: sp.Expr = 8 / DELTA
) -> dict[str, sp.Expr]:
    """The named quantities, each over those before it."""
    xi, _, delta = _coefficients(constants(spectrum), scale_of_parameter(spectrum))
    return {
        "xi": xi,
        "eta": (XI**2 - rational(spectrum.a1)) / 2,
        "delta": delta,
        "nu": 1 + XI + ETA + DELTA,
        "tau": XI * ETA - DELTA,
        "tracking_index": index,
        "innovation_deviation": INDEX * NU / 8,
        "alpha": 2 * (1 + ETA) / NU,
        "beta": 4 * XI / NU,
        "gamma": 8 / NU,
        "rest": 1 / DEVIATION**2,
        **({"w": 1 / DEVIATION} if spectrum.rational_in_root else {}),
        "predictor_position": ALPHA + BETA + GAMMA / 2,
        "predictor_velocity": BETA + GAMMA,
        **covariance_entries.predicted(model.process_noise),
        **covariance_entries.updated(model.process_noise, rational(spectrum.a1)),
    }


def _shortened(
    k: Constants, spectrum: Spectrum, elements: Mapping[str, sp.Expr]
) -> dict[str, sp.Expr]:
    """The elements that are quotients in xi in lowest terms, where these show the sign.

    The predicted covariance is kept over one denominator, for short cofactors.
    """
    numbers = Tower("numbers", (Parameter("p"),), k.generators, {})
    excess, known = (k.least, scale_of_parameter(spectrum)), quotients(spectrum, elements)
    below = common_denominator(known.of(real(name)) for name in PREDICTED)
    found: dict[str, sp.Expr] = {}
    for name in elements:
        if name not in ("xi", "tracking_index", "innovation_deviation"):
            over = below if name in PREDICTED else None
            with suppress(ArithmeticError):
                found[name] = over_parameter(numbers, excess, known.of(real(name)), over)
    return found


def kernel_tower(tower: Tower) -> Tower:
    """The main tower with y, whose quotient by the index's denominator is the index's fourth root.

    The kernels' square roots are taken from it.
    """
    index = tower.elements["tracking_index"]
    if any(entry.symbol == "r" for entry in tower.generators):
        # the root stands below, where its radicand is the shorter one
        radicand = _whole(tower, tower.reduce(index.den * index.num**3))
        fourth_root = _whole(tower, index.num) / real("y")
    else:
        radicand = _whole(tower, tower.reduce(index.num * index.den**3))
        fourth_root = real("y") / _whole(tower, index.den)
    root = Generator("y", radicand, 4)
    elements = {**tower.expressions, "fourth_root": fourth_root}
    return Tower("kernels", tower.parameters, (*tower.generators, root), elements)


def _whole(tower: Tower, poly: algebra.Poly) -> sp.Expr:
    return tower.expression(algebra.Fraction(poly, tower.ring.one))


def _coefficients(k: Constants, wide: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """xi, eta^2 - a2 and delta over the parameter, no negative coefficient in them."""
    excess = 4 / wide
    rise = k.least * excess + excess**2 / 2
    xi = k.least + excess
    above = 2 * k.c * k.least + 2 * (k.b + k.c) * rise + rise**2
    return xi, above, above / (2 * xi)


def _radicand(k: Constants, wide: sp.Expr, xi: sp.Expr, above: sp.Expr) -> sp.Expr:
    """The polynomial (2 xi)^2 (delta^2 - c^2) wide^8."""
    numbers = Tower("numbers", (Parameter("p"),), k.generators, {})
    value = numbers.fraction(
        sp.expand((above - 2 * k.c * xi) * wide**4) * sp.expand((above + 2 * k.c * xi) * wide**4)
    )
    return numbers.expression(value)
