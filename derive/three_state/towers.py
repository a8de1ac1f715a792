"""The tower of a three-state steady state: one parameter, few constants, at most one root.

xi, eta, delta are the coefficients of d(s) = 1 + xi s + eta s^2 + delta s^3 with roots in the left
half plane. xi is the rational parameter: it lies above 1 + b, its value without measurement noise,
with b = sqrt(m1 + 2 c) and c = sqrt(m2).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from gainproof.derive.algebra import tower as algebra
from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.expression import real
from gainproof.derive.model import ScaledModel
from gainproof.derive.steady_state.towers import rational, surd
from gainproof.derive.three_state import covariance_entries
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
    xi, above, delta = _coefficients(k, wide)
    generators = list(k.generators)
    index: sp.Expr = 8 / DELTA
    if spectrum.m2:
        radicand = _radicand(k, wide, xi, above)
        generators.append(Generator("r", radicand))
        index = 16 * XI * wide**4 / real("r")
    elements = {
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
    return Tower("main", (Parameter("p"),), tuple(generators), elements)


def kernel_tower(tower: Tower) -> Tower:
    """The main tower with y, whose quotient by the index's denominator is the index's fourth root.

    The kernels' square roots are taken from it.
    """
    index = tower.elements["tracking_index"]
    radicand = tower.expression(
        algebra.Fraction(tower.reduce(index.num * index.den**3), tower.ring.one)
    )
    root = Generator("y", radicand, 4)
    below = tower.expression(algebra.Fraction(index.den, tower.ring.one))
    elements = {**tower.expressions, "fourth_root": real("y") / below}
    return Tower("kernels", tower.parameters, (*tower.generators, root), elements)


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


def start(spectrum: Spectrum) -> End:
    """p -> 0, where xi grows without bound and the index falls to zero."""
    numbers, boundary, _ = _numbers(spectrum)
    if spectrum.m2:
        boundary["r"] = sp.Integer(64)
    return End(constants=numbers, boundary=boundary)


def end(spectrum: Spectrum) -> End:
    """p -> infinity, where xi falls to 1 + b and the index grows without bound."""
    numbers, boundary, k = _numbers(spectrum)
    if not spectrum.m2:
        return End(constants=numbers, boundary=boundary)
    radicand = sp.expand(32 * k.b * k.c * k.least * (k.least + k.c))
    return End(
        weights={"r": 7},
        constants={**numbers, "root_of_end": radicand},
        boundary={**boundary, "r": real("root_of_end")},
    )


def _numbers(spectrum: Spectrum) -> tuple[dict[str, sp.Expr | int], dict[str, sp.Expr], Constants]:
    """Constants of a limit, the generators of numbers over them, and b and c over them."""
    k = constants(spectrum)
    named = {entry.symbol: _constant(entry.symbol) for entry in k.generators}
    swap = {real(old): real(new) for old, new in named.items()}
    numbers: dict[str, sp.Expr | int] = {
        named[entry.symbol]: sp.sympify(entry.radicand).subs(swap) for entry in k.generators
    }
    boundary: dict[str, sp.Expr] = {old: real(new) for old, new in named.items()}
    return numbers, boundary, Constants(k.b.subs(swap), k.c.subs(swap), ())


def _constant(name: str) -> str:
    return name if name.startswith("root_") else f"root_of_{name}"
