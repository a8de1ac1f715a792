"""The closed loop of a filter with free gains, the region where it is stable, and coordinates that
run through exactly this region.

Units are T = 1. With prediction x_p = F x_s and update x_s = x_p + K (z - H x_p), the error of the
prediction goes with A = F (I - K H). The coefficients of det(zI - A) are of first degree in the
gains, hence so are those d_0 .. d_n of (1 - w)^n c((1 + w) / (1 - w)), whose sum is 2^n. By Hurwitz
the filter is stable exactly where all d_i are positive and, for three states, d_1 d_2 > d_0 d_3.

That region is an octant in disguise: d / d_0 = (1, x, w + y, x y) with y = e / (1 + x), for three
states, and (1, x, e) for two, takes every admissible value once while x, w, e run through all
positive numbers. Then 2^n / d_0 = 1 + x + w + e.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.polynomial import Poly, Ring, constant, ring, terms
from gainproof.verify.judge.exact.simplification import expression_of
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.fixed_gain.rational_system import (
    lowest,
    numerator_and_denominator,
    primitive,
    quotient,
    solved,
)
from gainproof.verify.judge.setting.matrices import Exprs, Numbers
from gainproof.verify.judge.setting.stability_conditions import circle_moved, left_half_plane
from gainproof.verify.judge.setting.steady_state_conditions import characteristic

Polys = tuple[tuple[Poly, ...], ...]
STEPS = ("step.1", "step.2", "step.3")
"""x, w and e; x and e for two states."""
MOST_STATES = 3


@dataclass(frozen=True)
class Loop:
    """`gains` are the symbols of K, `ring` holds polynomials in them; `closed` is F (I - K H),
    `predictor` is F K. `coefficients` are those of det(zI - A) from power 0 up without the leading
    1. `moved` are d_0 .. d_n. `chart` gives each gain over `steps`, which are positive.
    """

    transition: Numbers
    measurement: tuple[Fraction, ...]
    gains: tuple[str, ...]
    ring: Ring
    closed: Polys
    predictor: tuple[Poly, ...]
    coefficients: tuple[Expr, ...]
    moved: tuple[Expr, ...]
    region: tuple[Rel, ...]
    steps: tuple[str, ...]
    chart: Mapping[str, Expr] = field(default_factory=dict)

    @property
    def size(self) -> int:
        """The number of states."""
        return len(self.transition)

    def polynomial(self, expr: Expr) -> Poly:
        """A polynomial expression of the gains. Raises Undecided."""
        top, bottom = numerator_and_denominator(expr, self.gains)
        if not bottom.is_constant():
            raise Undecided("a quotient where a polynomial is wanted")
        return top / bottom.leading_coefficient()

    def quotient(self, top: Poly, bottom: Poly) -> Expr:
        """A rational function of the gains as an expression."""
        return quotient(top, bottom, self.gains)


def gain_name(i: int) -> str:
    """The symbol of a gain, counted from 0."""
    return f"filter_gain.{i + 1}"


def closed_loop(transition: Numbers, measurement: tuple[Fraction, ...]) -> Loop:
    """The loop of these matrices in units T = 1. Raises Undecided, also where the gains do not
    place all poles: then no free gain moves one of them.
    """
    size = len(transition)
    if not 1 <= size <= MOST_STATES:
        raise Undecided(f"free gains of {size} states are not covered")
    names = tuple(gain_name(i) for i in range(size))
    over_gains = ring(names)
    gains = [over_gains.gen(i) for i in range(size)]
    predictor = tuple(
        sum((constant(over_gains, f) * k for f, k in zip(row, gains, strict=True)), 0 * gains[0])
        for row in transition
    )
    closed = tuple(
        tuple(
            constant(over_gains, transition[i][j])
            - predictor[i] * constant(over_gains, measurement[j])
            for j in range(size)
        )
        for i in range(size)
    )
    matrix: Exprs = tuple(tuple(expression_of(p, names) for p in row) for row in closed)
    plain = Loop(
        transition, measurement, names, over_gains, closed, predictor, (), (), (), STEPS[:0]
    )
    polys = [plain.polynomial(c) for c in characteristic(matrix)]
    coefficients = tuple(expression_of(p, names) for p in polys)
    turned = [plain.polynomial(d) for d in circle_moved([*coefficients, number(1)])]
    moved = tuple(expression_of(p, names) for p in turned)
    steps, chart = _chart(turned, names)
    region = tuple(
        Rel(rel.operator, expression_of(primitive(plain.polynomial(rel.left)), names), rel.right)
        for rel in left_half_plane(moved)
    )
    return Loop(
        transition,
        measurement,
        names,
        over_gains,
        closed,
        predictor,
        coefficients,
        moved,
        region,
        steps,
        chart,
    )


def _chart(
    moved: Sequence[Poly], names: tuple[str, ...]
) -> tuple[tuple[str, ...], dict[str, Expr]]:
    """The gains over positive steps: d_1 .. d_n in their ratios to d_0, solved for the gains."""
    size = len(names)
    steps = STEPS[:size]
    over_steps = ring(steps)
    gens = [over_steps.gen(i) for i in range(size)]
    one = constant(over_steps, 1)
    total = sum(gens, one)
    # d_i / d_0 times `below`
    below, ratios = one, [one, *gens]
    if size == 3:
        x, w, e = gens
        below, ratios = one + x, [one + x, x * (one + x), w * (one + x) + e, x * e]
    scale = constant(over_steps, 2**size)
    # d_i = sum of a_ij gain_j + b_i, to be 2^n ratio_i / (below * total); d_0 follows from the sum
    rows, right = [], []
    for i in range(1, size + 1):
        parts = dict(terms(moved[i]))
        rest = parts.pop((0,) * size, 0)
        unit = [tuple(int(j == k) for j in range(size)) for k in range(size)]
        if set(parts) - set(unit):
            raise Undecided("the closed loop is not of first degree in the gains")
        rows.append([constant(over_steps, 1) * parts.get(u, 0) for u in unit])
        right.append(scale * ratios[i] - below * total * rest)
    (found,) = solved(rows, [right])
    return steps, {
        name: quotient(top, found[-1] * below * total, steps)
        for name, top in zip(names, found, strict=False)
    }


def steps_of_gains(loop: Loop) -> dict[str, Expr]:
    """The steps over the gains: quotients of what is positive where the filter is stable."""
    moved = loop.moved
    ratios = [moved[i] / moved[0] for i in range(1, loop.size + 1)]
    if loop.size == MOST_STATES:
        # y = e / (1 + x) is that of d_3 = x y d_0
        y = moved[3] / moved[1]
        ratios = [ratios[0], ratios[1] - y, ratios[2] + y]
    found = dict(zip(loop.steps, ratios, strict=True))
    return {name: lowest(value, loop.gains) for name, value in found.items()}
