"""A point moved until equations hold there: Newton's method in as many symbols, drawn at random."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from random import Random
from typing import Any

import mpmath
from mutation.arithmetic import NoValue, plus, times

from claim_campaign.point import DIGITS, Point
from claim_campaign.subject import Rel

SMALL = mpmath.mpf(10) ** -70
STEP = mpmath.mpf(10) ** -30
ROUNDS = 40
CHOICES = 6


def solved(equations: Sequence[Rel], point: Point, free: Sequence[str], random: Random) -> Point:
    """The point with some of the `free` symbols changed so that the equations hold. Raises NoValue
    if none was found.
    """
    for _ in range(CHOICES if len(free) >= len(equations) else 0):
        names = random.sample(list(free), len(equations))
        with mpmath.workdps(DIGITS):
            try:
                found = _newton(equations, point, names)
            except (NoValue, ZeroDivisionError, TypeError):
                continue
        if found is not None:
            return found
    raise NoValue("no root")


def _newton(equations: Sequence[Rel], point: Point, names: Sequence[str]) -> Point | None:
    for _ in range(ROUNDS):
        here = _residuals(equations, point)
        columns = []
        for name in names:
            there = _residuals(equations, _with(point, name, point.values[name] + STEP))
            columns.append([(b - a) / STEP for a, b in zip(here, there, strict=True)])
        slopes = mpmath.matrix(columns).T
        move = mpmath.lu_solve(slopes, mpmath.matrix(here))
        for name, step in zip(names, move, strict=True):
            point = _with(point, name, point.values[name] - step)
        if max(abs(step) for step in move) < SMALL:
            return point
    return None


def _residuals(equations: Sequence[Rel], point: Point) -> list[Any]:
    return [plus(point.value(e.left), times(-1, point.value(e.right))) for e in equations]


def _with(point: Point, name: str, value: Any) -> Point:
    if point.moved is not None:
        return point.moved(name, value)
    return replace(point, values={**point.values, name: value})
