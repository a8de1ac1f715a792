"""The tower of radicals in which the steady state of a two-state model lives.

Over the index (its root p where the steady state starts with half powers) and the parameters:
d0^2 = f0^2 + q n0, d2^2 = f2^2 + q n1, d1^2 = f1^2 - 2 f0 f2 + q (n0 + n1) + 2 d0 d2. Generators
are the products with a common denominator e; for d1 further times d0 d2 + f0 f2 where -2 f0 f2
would leave a minus sign in the radicand.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from gainproof.derive.algebra.leading_elements import Edge, edge, square_root
from gainproof.derive.algebra.tower import Generator, Parameter, Tower, is_manifestly_positive
from gainproof.derive.any_two_state.denominators import common_denominator, over_parameters
from gainproof.derive.any_two_state.model_numbers import Shape
from gainproof.derive.any_two_state.names import D0, D1, D2, DEVIATION, INDEX, ROOT
from gainproof.derive.expression import real

AREA = INDEX**2


@dataclass(frozen=True)
class Roots:
    """Generators, and d0, d1, d2 over them; `known` are roots of numbers that kernels take.

    `likely`: what the last generator grows like at infinity.
    """

    generators: tuple[Generator, ...]
    values: tuple[sp.Expr, sp.Expr, sp.Expr]
    known: dict[str, sp.Expr]
    likely: dict[str, sp.Expr]


def starts_with_half_powers(shape: Shape) -> bool:
    """Whether d1 falls like the root of the index: a double pole of the model at z = 1 or -1."""
    near, middle, far = (shape.sign(entry) for entry in shape.open_loop)
    return middle == 0 and (near == 0) != (far == 0)


def variable(shape: Shape) -> tuple[str, sp.Expr]:
    """The tower's parameter and the index over it."""
    half = starts_with_half_powers(shape)
    return (ROOT.name, ROOT**2) if half else (INDEX.name, INDEX)


def main_tower(shape: Shape) -> Tower:
    """The tower with all named quantities of the steady state."""
    name, index = variable(shape)
    roots = _roots(shape)
    elements: dict[str, sp.Expr] = dict(shape.numbers.elements)
    if name != INDEX.name:
        elements[INDEX.name] = index
    own = {generator.symbol for generator in roots.generators}
    for symbol, value in zip((D0, D1, D2), roots.values, strict=True):
        if symbol.name not in own:
            elements[symbol.name] = value
    parameters = (name, *shape.numbers.symbols)
    return Tower(
        "main",
        tuple(Parameter(entry) for entry in parameters),
        roots.generators,
        elements | steady_elements(shape),
    )


def edges(shape: Shape, tower: Tower) -> tuple[Edge, Edge]:
    """Both ends of the index. Raises NoLeadingTerm where a root has no leading term."""
    likely = _roots(shape).likely
    return (
        edge(tower, at_infinity=False),
        edge(tower, at_infinity=True, likely=likely),
    )


def known_roots(shape: Shape) -> dict[str, sp.Expr]:
    """Tower values of the roots in kernels."""
    return {**_roots(shape).known, "d0": D0, "d1": D1, "d2": D2}


def steady_elements(shape: Shape) -> dict[str, sp.Expr]:
    """The named quantities over the roots, short where they may be: differences are allowed here.

    1/sigma is (d0 - d1 + d2)/(4 det F), from det F = S c(0); the stable forms are proved equal to
    what stands here.
    """
    f11, f12, f21, f22 = (shape.entry(i, j) for i in (1, 2) for j in (1, 2))
    determinant = shape.determinant
    inverse = (D0 - D1 + D2) / (4 * determinant) if determinant != 0 else 4 / (D0 + D1 + D2)
    m11, m12 = real("predicted_11"), real("predicted_12")
    x11, x12, x22 = real("updated_11"), real("updated_12"), real("updated_22")
    square = DEVIATION**2
    return {
        DEVIATION.name: (D0 + D1 + D2) / 4,
        "inverse_deviation": inverse,
        "predicted_11": square - 1,
        "predicted_12": (f22 * square + (D0 - D2) * DEVIATION / 2 + f11) / f12,
        "updated_11": 1 - real("inverse_deviation") ** 2,
        "updated_12": m12 * real("inverse_deviation") ** 2,
        "updated_22": (m11 - f11**2 * x11 - 2 * f11 * f12 * x12 - AREA * shape.noise(1, 1))
        / f12**2,
        "predicted_22": f21**2 * x11
        + 2 * f21 * f22 * x12
        + f22**2 * x22
        + AREA * shape.noise(2, 2),
        "alpha": x11,
        "beta": x12,
    }


def _roots(shape: Shape) -> Roots:
    numbers = shape.numbers
    open_loop, (near, far) = shape.open_loop, shape.noise_ends
    name, index = variable(shape)
    below = common_denominator(numbers, open_loop, (near, far))
    f0, f1, f2 = (sp.cancel(entry * below) for entry in map(over_parameters(numbers), open_loop))
    n0, n1 = (sp.cancel(entry * below**2) for entry in map(over_parameters(numbers), (near, far)))
    generators: list[Generator] = []
    known: dict[str, sp.Expr] = {}

    def end(number: int, own: sp.Expr, noise: sp.Expr) -> sp.Expr:
        return end_root(shape, number, (own, noise, below, index), generators, known)

    first = end(0, f0, n0)
    same = f0 * f2 * n0 * n1 != 0 and sp.expand(f0**2 * n1 - f2**2 * n0) == 0
    last = first * shape.readable(_sized(shape, 2) / _sized(shape, 0)) if same else end(2, f2, n1)
    if shape.determinant == 0:  # d1^2 is (d0 + d2)^2 - 16 det F
        ends = (first + last) / below
        return Roots(tuple(generators), (first / below, ends, last / below), known, {})
    inner = sp.expand(f1**2 - 2 * f0 * f2 + index**2 * (n0 + n1)) + 2 * first * last
    parameters = tuple(Parameter(entry) for entry in (name, *numbers.symbols))
    trial = Tower("trial", parameters, tuple(generators), {"inner": inner})
    if is_manifestly_positive(trial.elements["inner"].num, parameters):
        symbol = "d1" if below == 1 else "d1_scaled"
        generators.append(Generator(symbol, sp.expand(inner)))
        middle: sp.Expr = real(symbol)
    else:
        both = first * last + f0 * f2
        rest = (f1**2 + index**2 * (n0 + n1)) * both + 2 * index**2 * (
            f0**2 * n1 + f2**2 * n0 + index**2 * n0 * n1
        )
        generators.append(Generator("product", sp.expand(both * rest)))
        middle = real("product") / both
    values = tuple(entry / below for entry in (first, middle, last))
    likely = {
        "d1": first + last,
        "d1_scaled": first + last,
        "product": (first + last) * first * last,
    }
    return Roots(tuple(generators), (values[0], values[1], values[2]), known, likely)


def end_root(
    shape: Shape,
    number: int,
    values: tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr],
    generators: list[Generator],
    known: dict[str, sp.Expr],
) -> sp.Expr:
    """d0 or d2 (`number`), times the denominator.

    values: f0 or f2 times the denominator, n0 or n1 times its square, the denominator, and the
    index. What it needs is added to `generators`, roots of numbers that kernels take to `known`.
    """
    own, noise, below, index = values
    if noise == 0:
        return own if shape.sign(shape.open_loop[number]) > 0 else -own
    if own == 0:
        outside, inside = square_root(noise)
        if inside != 1:
            root = f"root_n{number // 2}"
            generators.append(Generator(root, inside))
            outside = outside * real(root)
            known[root] = outside / below
        return index * outside
    symbol = f"d{number}" if below == 1 else f"d{number}_scaled"
    generators.append(Generator(symbol, sp.expand(own**2 + index**2 * noise)))
    return real(symbol)


def _sized(shape: Shape, number: int) -> sp.Expr:
    """The size of f0 or f2."""
    own = shape.open_loop[number]
    return own if shape.sign(own) > 0 else -own
