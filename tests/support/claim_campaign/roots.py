"""Where the roots of a polynomial lie at a point, by multiprecision."""

from __future__ import annotations

from functools import cache
from typing import Any

import mpmath
from mutation.arithmetic import NoValue
from mutation.tree import Tree

from claim_campaign.point import DIGITS, NotCovered, Point

MOST_DEGREE = 12
NOTHING = mpmath.mpf(10) ** -50
"""Size below which a coefficient is zero, relative to the largest."""
SAME = mpmath.mpf(10) ** -15
"""A double root comes out of rounded coefficients to half their digits."""


def lie(polynomial: Tree, variable: str, where: str, point: Point) -> bool:
    """Whether all roots lie `where` says, roots on a border being outside of what is open. Raises
    NotCovered for what is no polynomial of positive degree.
    """
    with mpmath.workdps(DIGITS):
        found = _roots(_coefficients(polynomial, variable, point))
        match where:
            case "inside the unit circle":
                return all(abs(root) < 1 for root in found)
            case "left half plane":
                return all(mpmath.re(root) < 0 for root in found)
            case "real":
                return all(abs(mpmath.im(root)) < SAME for root in found)
            case "complex":
                return all(abs(mpmath.im(root)) > SAME for root in found)
            case "equal":
                return all(abs(root - found[0]) < SAME for root in found)
    raise NotCovered(where)


def _coefficients(polynomial: Tree, variable: str, point: Point) -> list[Any]:
    """From the highest power down: interpolated, and seen to fit at one more place."""
    assert point.moved is not None
    nodes = _nodes()
    values = [point.moved(variable, node).value(polynomial) for node in nodes]
    size = MOST_DEGREE + 1
    found = list(_interpolating() * mpmath.matrix(values[:size]))
    largest = max(map(abs, found))
    again = sum(c * nodes[size] ** k for k, c in enumerate(found))
    if abs(again - values[size]) > NOTHING * max(1, abs(values[size])):
        raise NotCovered("no polynomial")
    while found and abs(found[-1]) <= NOTHING * largest:
        found.pop()
    if len(found) < 2:
        raise NoValue("a constant")
    return found[::-1]


def _nodes() -> list[Any]:
    return [mpmath.mpf(node) / 4 + 2 for node in range(MOST_DEGREE + 2)]


@cache
def _interpolating() -> Any:
    """Takes values at the nodes but the last to coefficients; with digits to spare, since entries
    are large.
    """
    with mpmath.workdps(2 * DIGITS):
        nodes = _nodes()[:-1]
        return mpmath.matrix([[node**k for k in range(len(nodes))] for node in nodes]) ** -1


def _roots(coefficients: list[Any]) -> list[Any]:
    try:
        found: list[Any] = mpmath.polyroots(coefficients, maxsteps=500, extraprec=1000)
    except mpmath.libmp.libhyper.NoConvergence:
        raise NoValue("roots") from None
    return found
