"""Steady states by the filter's own recursion in long floats, sample after sample, and models to
try them on: nothing of the finder under test, and no doubling.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import flint

from gainproof.verify.check_enclosure import Box
from gainproof.verify.enclosure.structure import Model

BITS = 600
Grid = list[list[Fraction]]


def boxed(rows: Sequence[Sequence[Any]]) -> Box:
    return Box([[Fraction(x) for x in row] for row in rows])


def model(f: Any, h: Any, q: Any, r: Any, s: Any = None) -> Model:
    """The model of these matrices, numbers as texts or exact."""
    n, m = len(f), len(h)
    none = [[0] * m for _ in range(n)]
    names = (
        tuple(f"state {i + 1}" for i in range(n)),
        tuple(f"measurement {j + 1}" for j in range(m)),
    )
    return Model(boxed(f), boxed(h), boxed(q), boxed(r), boxed(none if s is None else s), names)


def limit(of: Model, steps: int = 3000) -> dict[str, Grid]:
    """What the recursion from a definite start has come to: `predicted`, `updated`, `filter`,
    `predictor`; good to 80 digits, which two starts confirm.
    """
    with flint.ctx.workprec(BITS):
        first, second = (_run(of, start, steps) for start in (1, 1000))
        for name, grid in first.items():
            for row, other in zip(grid, second[name], strict=True):
                for x, y in zip(row, other, strict=True):
                    assert abs(x - y) <= Fraction(1, 10**80) * (1 + abs(x)), name
    return first


def _run(of: Model, start: int, steps: int) -> dict[str, Grid]:
    f, h, q, r, s = (_mat(box) for box in (of.f, of.h, of.q, of.r, of.s))
    n = f.nrows()
    p = flint.arb_mat([[start * int(i == j) for j in range(n)] for i in range(n)])
    for _ in range(steps):
        sigma = (h * p * h.transpose() + r).inv().mid()
        gain = ((f * p * h.transpose() + s) * sigma).mid()
        moved = f * p * f.transpose() + q - gain * (f * p * h.transpose() + s).transpose()
        moved = ((moved + moved.transpose()) * flint.arb(0.5)).mid()
        small = max(abs(x) for x in (moved - p).entries())
        p = moved
        if small < flint.arb(2) ** -(BITS - 120):
            break
    filter_gain = p * h.transpose() * sigma
    updated = p - filter_gain * h * p
    found = {"predicted": p, "updated": updated, "filter": filter_gain, "predictor": gain}
    return {name: [[_fraction(x) for x in row] for row in x.tolist()] for name, x in found.items()}


def _mat(box: Box) -> Any:
    return flint.arb_mat(
        [[flint.arb(flint.fmpq(x.numerator, x.denominator)) for x in row] for row in box.c]
    ).mid()


def _fraction(x: Any) -> Fraction:
    man, exp = x.mid().man_exp()
    return Fraction(int(man)) * Fraction(2) ** int(exp)


def covariance(draw: random.Random, size: int, rank: int) -> Grid:
    """A random covariance of this rank at most."""
    roots = [[Fraction(draw.randint(-9, 9), 8) for _ in range(rank)] for _ in range(size)]
    return [
        [sum((a * b for a, b in zip(x, y, strict=True)), Fraction(0)) for y in roots] for x in roots
    ]


def drawn(draw: random.Random, n: int, m: int, kind: str) -> Model:
    """A random model: `plain`, with `singular` noises, `correlated` ones, an `unstable` motion, or
    in `units` twelve orders apart.
    """
    f = [
        [Fraction(draw.randint(-99, 99), 100 if kind != "unstable" else 40) for _ in range(n)]
        for _ in range(n)
    ]
    h = [[Fraction(draw.randint(-9, 9), 4) for _ in range(n)] for _ in range(m)]
    both = covariance(draw, n + m, n + m)
    q, s, r = (
        [row[:n] for row in both[:n]],
        [row[n:] for row in both[:n]],
        [row[n:] for row in both[n:]],
    )
    if kind != "correlated":
        thin = kind == "singular"
        q = covariance(draw, n, draw.randint(1, n) if thin else n)
        r = covariance(draw, m, draw.randint(0, m) if thin else m)
        s = [[Fraction(0)] * m for _ in range(n)]
    if kind == "units":
        a = [Fraction(10) ** draw.randint(-6, 6) for _ in range(n)]
        b = [Fraction(10) ** draw.randint(-6, 6) for _ in range(m)]
        f = [[x * a[i] / a[j] for j, x in enumerate(row)] for i, row in enumerate(f)]
        h = [[x * b[i] / a[j] for j, x in enumerate(row)] for i, row in enumerate(h)]
        q = [[x * a[i] * a[j] for j, x in enumerate(row)] for i, row in enumerate(q)]
        r = [[x * b[i] * b[j] for j, x in enumerate(row)] for i, row in enumerate(r)]
    return model(f, h, q, r, s)
