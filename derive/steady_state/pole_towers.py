"""Towers for the two sides of the index at which the poles turn real.

Below L1 = 8/(1 - e): Lambda = L1 x^2/(1 + x^2) with x > 0. From L1 on: Lambda = L1 + g^2, g >= 0.
Differences L1 - Lambda and Lambda - L1 are then positive by their looks.
"""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.expression import real
from gainproof.derive.steady_state.kernels import symbolic_forms
from gainproof.derive.steady_state.names import DEVIATION, INDEX, KAPPA
from gainproof.derive.steady_state.towers import (
    rational,
    root_of_16,
    steady_elements,
    surd,
)

X, G = real("x"), real("g")
BELOW, ABOVE = real("below"), real("above")
SIDE = 1 + X**2


def turning_root(e: Fraction) -> sp.Expr:
    """sqrt(1 - e) over a generator of the tower."""
    return surd(1 - e)[0]


def _turning_generators(e: Fraction) -> list[Generator]:
    return [Generator(name, sp.Integer(number)) for name, number in surd(1 - e)[1].items()]


def complex_tower(e: Fraction, n: Fraction) -> Tower:
    """The steady state where 0 < Lambda < L1."""
    ratio, limit = rational(e), rational(8 / (1 - e))
    generators = [*_turning_generators(e), Generator("y", limit * SIDE)]
    scaled_high: sp.Expr = 4 * SIDE
    if e:
        generators.append(Generator("G", 16 * SIDE**2 + ratio * limit**2 * X**4))
        scaled_high = real("G")
    generators += [
        Generator("u", sp.expand(SIDE * ((1 + ratio) * limit * X**2 + 2 * scaled_high))),
        Generator("w", sp.expand(limit * SIDE * (1 + 2 * X**2))),
    ]
    elements: dict[str, sp.Expr] = {"p": real("y") * X / SIDE}
    if e:
        elements["H"] = scaled_high / SIDE
    elements |= {"s": real("u") / (2 * SIDE)}
    elements |= {"below": real("y") / (2 * SIDE), "above": real("w") / (2 * SIDE)}
    elements |= steady_elements(e, n, limit * X**2 / SIDE)
    elements["pole_real"] = 1 - (real("alpha") + real("beta")) / 2
    elements["pole_imaginary"] = half_width(e, n)
    return Tower("complex_poles", (Parameter("x"),), tuple(generators), elements)


def complex_ends(e: Fraction) -> dict[str, End]:
    """Behaviour of the tower below L1 as x -> 0 and x -> infinity."""
    limit = 8 / (1 - e)
    high = rational(4 * (1 + e) / (1 - e))
    parts = {
        "y": (surd(limit), surd(limit)),
        "u": (surd(Fraction(8)), surd(16 * (1 + e) / (1 - e))),
        "w": (surd(limit), surd(2 * limit)),
    }
    weights = {"y": 1, "u": 2, "w": 2}
    ends = {}
    for number, point in enumerate(("0", "infinity")):
        chosen = {name: pair[number] for name, pair in parts.items()}
        boundary = {name: value for name, (value, _) in chosen.items()}
        if e:
            boundary["G"] = high if number else sp.Integer(4)
        ends[point] = _end(
            e,
            boundary,
            [entry for _, entry in chosen.values()],
            {**weights, "G": 2} if number else {},
        )
    return ends


def _end(
    e: Fraction,
    boundary: dict[str, sp.Expr],
    constants: list[dict[str, int]],
    weights: dict[str, int],
) -> End:
    names = surd(1 - e)[1]
    merged: dict[str, int] = dict(names)
    for entry in constants:
        merged |= entry
    if names:
        name = next(iter(names))
        boundary = {name: real(name), **boundary}
        weights = {name: 0, **weights} if weights else {}
    ordered = dict(sorted(merged.items(), key=lambda item: item[1]))
    return End(weights=weights, constants=ordered, boundary=boundary)


def real_tower(e: Fraction, n: Fraction) -> Tower:
    """The steady state where Lambda > L1."""
    ratio, limit = rational(e), rational(8 / (1 - e))
    index = limit + G**2
    high = root_of_16(e)
    generators = [*_turning_generators(e), Generator("p", index)]
    if e:
        generators.append(Generator("H", sp.expand(16 + ratio * index**2)))
    generators += [
        Generator("s", sp.expand(((1 + ratio) * index + 2 * high) / 4)),
        Generator("w", limit + index),
    ]
    elements = {"below": G / 2, "above": real("w") / 2, **steady_elements(e, n, index)}
    first = middle_size(e) + half_width(e, n)
    elements["first_pole"] = -first
    elements["second_pole"] = real("rest") / real("first_pole")
    parameter = Parameter("g", above=None, start="0")
    return Tower("real_poles", (parameter,), tuple(generators), elements)


def half_width(e: Fraction, n: Fraction) -> sp.Expr:
    """Half the distance of the poles."""
    return symbolic_forms(e, n, ("half_width",), {"below": BELOW, "above": ABOVE})["half_width"]


def middle_size(e: Fraction) -> sp.Expr:
    """(1 - 2 kappa) Lambda/(4 sigma) where Lambda > L1, positive by its looks."""
    ratio, limit = rational(e), rational(8 / (1 - e))
    top = sp.expand((1 - ratio) * (limit + G**2) ** 2 - 16)
    return top / (4 * INDEX * DEVIATION * (2 * KAPPA + 1))


def real_ends(e: Fraction) -> dict[str, End]:
    """Behaviour of the tower above L1 as g -> 0 and g -> infinity."""
    limit = 8 / (1 - e)
    parts = {
        "p": surd(limit),
        "s": surd(4 * (1 + e) / (1 - e)),
        "w": surd(2 * limit),
    }
    near = {name: value for name, (value, _) in parts.items()}
    root, names = surd(e) if e else (sp.Integer(0), {})
    far = {"p": sp.Integer(1), "s": (1 + root) / 2, "w": sp.Integer(1)}
    weights = {"p": 1, "s": 1, "w": 1}
    if e:
        near["H"], far["H"], weights["H"] = rational(4 * (1 + e) / (1 - e)), root, 2
    return {
        "0": _end(e, near, [entry for _, entry in parts.values()], {}),
        "infinity": _end(e, far, [names], weights),
    }
