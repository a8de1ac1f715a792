"""The tower in which the steady state of a three-state model lives.

Over the index (its root p where the steady state starts with broken powers) and the parameters:
d0^2 = A0, d3^2 = A3 and the coupled pair d1^2 = A1 + 2 d0 d2, d2^2 = A2 + 2 d3 d1, where
A_i = f_i + q n_i are the coefficients of the spectrum in u. Generators are the products with a
common denominator e.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import lcm

import sympy as sp

from gainproof.derive.algebra.leading_elements import Edge, edge, square_root
from gainproof.derive.algebra.tower import Generator, Parameter, Tower, coupled
from gainproof.derive.any_three_state.covariances import hidden_entries
from gainproof.derive.any_three_state.model_numbers import Shape
from gainproof.derive.any_three_state.names import (
    AREA,
    DEVIATION,
    GAINS,
    INDEX,
    ROOT,
    ROOTS,
    TOTAL,
    symmetric,
)
from gainproof.derive.any_two_state.denominators import common_denominator, over_parameters
from gainproof.derive.expression import real
from gainproof.derive.model import ModelError


@dataclass(frozen=True)
class Roots:
    """Generators, and d0, ..., d3 over them; `known` are roots of numbers that kernels take."""

    generators: tuple[Generator, ...]
    values: tuple[sp.Expr, ...]
    known: dict[str, sp.Expr]


def powers_of_root(shape: Shape) -> int:
    """k, for p^k = Lambda: m poles of the model at z = 1 or -1 part like the m-th root of it where
    it is small, and m zeros of the noise there where it is large.
    """
    found = 1
    for numbers in (shape.open_loop, shape.shaken):
        signs = [shape.sign(entry) for entry in numbers]
        for ordered in (signs, signs[::-1]):
            found = lcm(found, max(1, next(n for n, sign in enumerate(ordered) if sign)))
    return found


def variable(shape: Shape) -> tuple[str, sp.Expr]:
    """The tower's parameter and the index over it."""
    power = powers_of_root(shape)
    return (INDEX.name, INDEX) if power == 1 else (ROOT.name, ROOT**power)


def roots_of(shape: Shape) -> Roots:
    """The roots. Raises ModelError where a coefficient of the spectrum may be negative."""
    numbers, index = shape.numbers, variable(shape)[1]
    below = common_denominator(numbers, shape.open_loop, (*shape.still, *shape.shaken))
    plain = over_parameters(numbers)
    still = [sp.expand(sp.cancel(plain(entry) * below**2)) for entry in shape.still]
    shaken = [sp.expand(sp.cancel(plain(entry) * below**2)) for entry in shape.shaken]
    for number in range(4):
        for part, what in ((shape.still[number], "f"), (shape.shaken[number], "n")):
            if shape.sign(part) < 0:
                raise ModelError(
                    f"model {shape.model.name}: of three states coefficients of the spectrum that "
                    f"are not negative are in reach, {what}{number} = {part}: "
                    + ("poles off the real axis" if what == "f" else "zeros of the noise off it")
                )
    generators: list[Generator] = []
    known: dict[str, sp.Expr] = {}

    def end(number: int) -> sp.Expr:
        """d0 or d3, times the denominator."""
        own, noise = shape.open_loop[number], shaken[number]
        if noise == 0:
            size = sp.cancel(plain(own) * below)
            return size if shape.sign(own) > 0 else -size
        if own == 0:
            outside, inside = square_root(noise)
            if inside != 1:
                root = f"root_n{number}"
                generators.append(Generator(root, inside))
                outside = outside * real(root)
                known[root] = outside / below
            return index * outside
        symbol = f"d{number}" if below == 1 else f"d{number}_scaled"
        generators.append(Generator(symbol, sp.expand(still[number] + index**2 * noise)))
        return real(symbol)

    first, last = end(0), end(3)
    one, two = (f"d{k}" if below == 1 else f"d{k}_scaled" for k in (1, 2))
    inner = [sp.expand(still[k] + index**2 * shaken[k]) for k in (1, 2)]
    generators += coupled((one, inner[0], 2 * first), (two, inner[1], 2 * last))
    values = tuple(entry / below for entry in (first, real(one), real(two), last))
    return Roots(tuple(generators), values, known)


def edges(shape: Shape, tower: Tower) -> tuple[Edge, Edge]:
    """Both ends of the index. Raises NoLeadingTerm where a root has no leading term."""
    open_loop = [over_parameters(shape.numbers)(entry) for entry in shape.open_loop]
    below = common_denominator(shape.numbers, shape.open_loop, (*shape.still, *shape.shaken))
    own = {g.symbol for g in tower.generators}
    names = [f"d{k}" if f"d{k}" in own else f"d{k}_scaled" for k in (1, 2)]
    likely: dict[str, sp.Expr] = {}
    if all(shape.sign(shape.open_loop[k]) > 0 for k in (1, 2)):  # zeros solve, and are no limit
        likely = {name: sp.cancel(open_loop[k] * below) for k, name in enumerate(names, 1)}
    return (
        edge(tower, at_infinity=False, likely=likely),
        edge(tower, at_infinity=True),
    )


def main_tower(shape: Shape) -> Tower:
    """The tower with all named quantities of the steady state."""
    name, index = variable(shape)
    roots = roots_of(shape)
    elements: dict[str, sp.Expr] = dict(shape.numbers.elements)
    if name != INDEX.name:
        elements[INDEX.name] = index
    own = {generator.symbol for generator in roots.generators}
    for number, value in enumerate(roots.values):
        if f"d{number}" not in own:
            elements[f"d{number}"] = value
    parameters = (name, *shape.numbers.symbols)
    return Tower(
        "main",
        tuple(Parameter(entry) for entry in parameters),
        roots.generators,
        elements | steady_elements(shape),
    )


def steady_elements(shape: Shape) -> dict[str, sp.Expr]:
    """The named quantities over the roots, short where they may be: differences are allowed here.

    8/N is (d1 + d3 - d0 - d2)/(8 det F), from det F = S (-c(0)): no root stands below a line.
    """
    d0, d1, d2, d3 = ROOTS
    weights, own = shape.closed_loop
    column = weights * sp.Matrix([d0, d1, d2, d3])
    inverse = real("inverse_deviation")
    found: dict[str, sp.Expr] = {
        DEVIATION.name: TOTAL / 8,
        inverse.name: (d1 + d3 - d0 - d2) / (8 * shape.determinant),
        "alpha": 1 - inverse**2,
        **{name: column[k] * inverse / 8 - own[k] for k, name in ((1, "beta"), (2, "gamma"))},
        "predicted_11": DEVIATION**2 - 1,
        **{f"predicted_1{k + 1}": (column[k] / 8 - own[k] * DEVIATION) * DEVIATION for k in (1, 2)},
        **{f"updated_1{k}": gain for k, gain in enumerate(GAINS, 1)},
    }
    for place, value in hidden_entries(shape).items():
        found[f"updated_{place}"] = value
    moved = _moved(shape)
    for i, j in ((2, 2), (2, 3), (3, 3)):
        found[f"predicted_{i}{j}"] = moved[i - 1, j - 1]
    return found


def _moved(shape: Shape) -> sp.MatrixBase:
    """F X F' + q Q0."""
    matrix = shape.model.transition
    return matrix * symmetric("updated") * matrix.T + AREA * shape.model.process_noise
