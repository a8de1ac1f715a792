"""The updated covariance and its derivatives where all is rational in the root of 1 - alpha.

There m1 = 1 and m2 = 0, eta = xi^2/2 - 1, delta = xi (xi - 2) (xi + 2)/8, and with
h = (xi - 2)/xi = 64/(Lambda xi^2 (xi + 2)) and v = 1/xi no difference is left:
X22 = Lambda (2 + h) xi/(xi + 2), X23 = 8 Lambda/(xi + 2), and X33 = Lambda^2 xi/2, or with Q23 = 1
X33 = 32 Lambda/(xi (xi + 2)). So X22 + X23 = 3 Lambda. Every derivative is the entry times
a quotient of sums.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from gainproof.derive.three_state.kernel_basis import KernelBasis
from gainproof.derive.three_state.kernel_forms import HALF, Forms, Noise


@dataclass(frozen=True)
class Rational:
    """The numbers of one basis, each of moderate size."""

    k: KernelBasis
    noise: Noise

    @cached_property
    def v(self) -> Any:
        """1/xi."""
        return (self.k.r / self.k.x) * HALF

    @cached_property
    def h(self) -> Any:
        """(xi - 2)/xi."""
        k = self.k
        return ((8 / (k.x + k.r)) / k.x) / (k.x * k.r)

    @cached_property
    def step(self) -> Any:
        """h (1 + 2 v) = 1 - 4/xi^2."""
        return self.h * (self.v * 2 + 1)

    @cached_property
    def wide(self) -> Any:
        """(3 xi^2 - 4)/xi^2."""
        return self.step + 2

    @cached_property
    def first(self) -> Any:
        """xi/(xi + 2)."""
        return self.k.x / (self.k.x + self.k.r)

    @cached_property
    def cross(self) -> Any:
        """8/(xi + 2)."""
        return (self.k.r / (self.k.x + self.k.r)) * 4

    @cached_property
    def narrow(self) -> Any:
        """32/(xi (xi + 2))."""
        return self.cross * ((self.k.r / self.k.x) * 2)

    @property
    def independent(self) -> bool:
        """Whether Q23 = 0: the other of the two noises has Q23 = 1."""
        return self.noise.q23 == 0

    @cached_property
    def bent(self) -> Any:
        """h^2 (3 xi^2 + 3 xi - 2)/xi^2 over the cube of `wide`."""
        inner = ((self.h + 2) * self.v + 3) / self.wide
        share = self.h / self.wide
        return (share * share) * inner


def entries(x: Rational) -> Forms:
    """Entries 22, 23 and 33."""
    k = x.k
    third = k.index * ((k.x / k.r) * k.index) if x.independent else k.index * x.narrow
    return {
        "updated_22": k.index * ((x.h + 2) * x.first),
        "updated_23": k.index * x.cross,
        "updated_33": third,
    }


def derivatives(x: Rational) -> Forms:
    """Their derivatives by the index."""
    k = x.k
    inner = (x.v * x.v) * (x.v * 8 + 4) + (x.h * 7 + 2)
    if x.independent:
        third = ((k.x / k.r) * k.index) * ((x.step + 4) / x.wide)
    else:
        third = x.narrow * ((x.h * (x.v * 4 + 3) + 2) / x.wide)
    return {
        "updated_22": (inner / x.wide) * x.first,
        "updated_23": (((x.h * (x.v + 1) + 1) / x.wide) * 2) * x.cross,
        "updated_33": third,
    }


def second_derivatives(x: Rational) -> Forms:
    """Their second derivatives by the index: that of entry 22 is less that of entry 23."""
    k, square, cube = x.k, x.v * x.v, x.wide * x.wide * x.wide
    if x.independent:
        third = ((k.x / k.r) * 2) * ((x.step * (square * 4 + 7) + 8) / cube)
    else:
        rest = x.h * x.v * ((x.v * 4 + 2) * x.v + 1) * 2
        inner = ((x.h * square) * 12 + rest) + (x.v * 34 + 15)
        share = x.h / x.wide
        third = ((share * share) * (inner / x.wide)) * (x.narrow * 2) / k.index
    cross = (x.bent * (x.cross * 4)) / k.index
    return {
        "updated_22": -cross,
        "updated_23": cross,
        "updated_33": third,
    }
