"""The tower of second derivatives: the main one with the four powers of the index that they need.

A tower of its own: without these long fractions every other statement is decided faster.
"""

from __future__ import annotations

from contextlib import suppress

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.expression import real
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.curvature import numbers, powers

NAME = "bending"


def bending_tower(c: Context) -> Tower:
    """omega, mu, psi and chi beside the main tower's elements."""
    found = powers(numbers(c.model, c.spectrum))
    if c.spectrum.m2:
        for name in found:
            # where lowest terms show no sign the tower finds a form
            with suppress(ArithmeticError):
                found[name] = c.shown(c.quotients.of(real(name)))
    return Tower(NAME, c.tower.parameters, c.tower.generators, {**c.tower.expressions, **found})
