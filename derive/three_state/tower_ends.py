"""How the tower of a three-state steady state behaves at both ends of its parameter."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.expression import real
from gainproof.derive.three_state.spectrum import Spectrum
from gainproof.derive.three_state.towers import Constants, constants


def start(spectrum: Spectrum) -> End:
    """p -> 0, where xi grows without bound and the index falls to zero."""
    numbers, boundary, _ = number_limits(spectrum)
    if spectrum.m2:
        boundary["r"] = sp.Integer(64)
    return End(constants=numbers, boundary=boundary)


def end(spectrum: Spectrum) -> End:
    """p -> infinity, where xi falls to 1 + b and the index grows without bound."""
    numbers, boundary, k = number_limits(spectrum)
    if not spectrum.m2:
        return End(constants=numbers, boundary=boundary)
    radicand = sp.expand(32 * k.b * k.c * k.least * (k.least + k.c))
    return End(
        weights={"r": 7},
        constants={**numbers, "root_of_end": radicand},
        boundary={**boundary, "r": real("root_of_end")},
    )


def number_limits(
    spectrum: Spectrum,
) -> tuple[dict[str, sp.Expr | int], dict[str, sp.Expr], Constants]:
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
