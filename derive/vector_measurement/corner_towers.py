"""Towers for the corners of the domain, in which both parameters tend together.

With t = Lambda/S held, Lambda -> 0 and Lambda -> infinity; with x = S/sqrt(Lambda) held,
Lambda -> 0. These are the three ways in which the steady state changes its shape.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.expression import real
from gainproof.derive.vector_measurement import radicands
from gainproof.derive.vector_measurement.limit_towers import root_of_e
from gainproof.derive.vector_measurement.names import RATIO, ROOT
from gainproof.derive.vector_measurement.process_noise import Noise
from gainproof.derive.vector_measurement.towers import rational, steady_elements, symbolic_noise

T, X = real("t"), real("x")
W, GAMMA, HIGH, GAP = real("w"), real("gamma"), real("high"), real("gap")


def fixed_index_tower(noise: Noise) -> Tower:
    """p and t = Lambda/S: w and gamma = sqrt(4 + t^2) depend on t alone."""
    numbers = symbolic_noise(noise)
    area, e, d = ROOT**4, rational(noise.e), rational(noise.determinant)
    generators = [Generator(name, sp.Integer(n)) for name, n in root_of_e(noise)[1].items()]
    level: sp.Expr = sp.Integer(1)
    if d:
        generators.append(Generator("w", 1 + d * T**2))
        level = W
    generators.append(Generator("gamma", 4 + T**2))
    if noise.interval:
        eta = GAMMA * HIGH / 2 if e else 2 * GAMMA
        if e:
            generators.append(Generator("high", 16 + e * area))
    else:
        generators.append(Generator("high", 16 + area + 4 * T**2))
        eta = HIGH
    square = radicands.delta_squared(
        numbers, ROOT**2, ROOT**2 / T, ROOT**2 / T * level, ROOT**2 / T * eta
    )
    generators.append(Generator("gap", sp.expand(sp.expand(square) * T**2 / area)))
    return _tower("fixed_velocity_index", "t", ROOT**2 / T, generators, (level, eta, GAP), noise)


def narrow_tower(noise: Noise) -> Tower:
    """p and x = S/sqrt(Lambda): x w, x eta and x delta/p."""
    numbers = symbolic_noise(noise)
    ratio, area = X * ROOT, ROOT**4
    generators = []
    width: sp.Expr = ratio
    if noise.determinant:
        square = radicands.level_squared(numbers, ROOT**2, ratio)
        generators.append(Generator("w", sp.expand(square / ROOT**2)))
        width = W * ROOT
    square = radicands.eta_squared(numbers, ROOT**2, ratio)
    generators.append(Generator("high", sp.expand(square / ROOT**2)))
    square = radicands.delta_squared(numbers, ROOT**2, ratio, width, HIGH * ROOT)
    generators.append(Generator("gap", sp.expand(square / area)))
    roots = (W / X if noise.determinant else sp.Integer(1), HIGH / X, ROOT * GAP / X)
    return _tower("narrow", "x", ratio, generators, roots, noise)


def outer_tower() -> Tower:
    """x and sqrt(1 + 2 x^2): the shape of P11 where a small index forgets the velocity."""
    return Tower("outer", (Parameter("x"),), (Generator("outer", 1 + 2 * X**2),), {})


def _tower(
    name: str,
    held: str,
    ratio: sp.Expr,
    generators: list[Generator],
    roots: tuple[sp.Expr, sp.Expr, sp.Expr],
    noise: Noise,
) -> Tower:
    level, eta, delta = roots
    elements = dict(steady_elements(noise))
    known = {"level": level} if noise.determinant else {}
    known |= {"eta": eta, "delta": delta}
    ordered = {"tracking_index": elements.pop("tracking_index"), str(RATIO): ratio}
    elements |= known
    if GAMMA in eta.free_symbols and noise.e:
        elements["b"] = root_of_e(noise)[0] * GAMMA / 2
    return Tower(
        name,
        (Parameter("p"), Parameter(held)),
        tuple(generators),
        {**ordered, **elements},
    )


def fixed_index_ends(noise: Noise) -> Mapping[str, End]:
    """Lambda -> 0 and Lambda -> infinity with t held."""
    root, names = root_of_e(noise)
    constants: dict[str, int | sp.Expr] = {f"{name}_held": n for name, n in names.items()}
    held: dict[str, sp.Expr] = {name: real(f"{name}_held") for name in names}
    if noise.determinant:
        constants["w_held"] = 1 + rational(noise.determinant) * T**2
        held["w"] = real("w_held")
    constants["gamma_held"] = 4 + T**2
    held["gamma"] = gamma = real("gamma_held")
    swap = {real(name): symbol for name, symbol in held.items()}
    root = root.subs(swap)
    near, far, weights = dict(held), dict(held), {"gap": 2}
    level = held.get("w", sp.Integer(1))
    if noise.interval:
        if noise.e:
            near["high"], far["high"], weights["high"] = sp.Integer(4), root, 2
        near["gap"], far["gap"] = T, (level + root * gamma / 2) / 2
    else:
        near["high"], far["high"], weights["high"] = 2 * gamma, sp.Integer(1), 2
        near["gap"], far["gap"] = T, sp.Integer(1)
    return {
        "0": End(constants=constants, boundary=near),
        "infinity": End(weights=weights, constants=constants, boundary=far),
    }


def narrow_ends(noise: Noise) -> Mapping[str, End]:
    """Lambda -> 0 with x held."""
    boundary = {"w": X} if noise.determinant else {}
    boundary |= {"high": 4 * X, "gap": real("outer_held")}
    return {"0": End(constants={"outer_held": 1 + 2 * X**2}, boundary=boundary)}
