"""The updated covariance and its first derivatives, as sums of positive terms.

Its entries beyond the first row are q times a polynomial in xi (entry 22: over xi) without a
negative coefficient in xi - xi0. With q f for one of them the derivative is
Lambda (2 f - omega xi df/dxi), where omega = 2 (g^2/4 - e xi^2)/(g h) with the polynomials
g = eta^2 - a2 = 2 xi delta and h = (3 eta^2 + 2 a1 eta + a2)/2 = xi tau.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from gainproof.derive.algebra.derivative import by
from gainproof.derive.steady_state.towers import rational
from gainproof.derive.three_state import kernel_rational
from gainproof.derive.three_state.excess import node_of, positive_terms
from gainproof.derive.three_state.kernel_basis import KernelBasis
from gainproof.derive.three_state.kernel_curvature import Bend, horner
from gainproof.derive.three_state.kernel_derivatives import gain_derivatives
from gainproof.derive.three_state.kernel_forms import HALF, Forms, Noise, excess, gains
from gainproof.derive.three_state.names import XI

DEGREES = {"updated_22": 3, "updated_23": 2, "updated_33": 1}
"""An entry over q grows like this power of xi."""


@dataclass(frozen=True)
class Updated:
    """A basis with the entries over q, each times xi, as polynomials in xi."""

    k: KernelBasis
    noise: Noise

    @cached_property
    def h(self) -> Any:
        """(xi - xi0)/xi."""
        return (excess(self.k) / self.k.index) * self.b.v

    @cached_property
    def b(self) -> Bend:
        """What all derivatives share."""
        return Bend(self.k)

    @cached_property
    def eta(self) -> sp.Expr:
        """eta as a polynomial in xi."""
        return (XI**2 - rational(self.k.spectrum.a1)) / 2

    @cached_property
    def entries(self) -> dict[str, sp.Expr]:
        """The polynomials."""
        s, eta = self.k.spectrum, self.eta
        a1, a2 = rational(s.a1), rational(s.a2)
        q13, q23, rate = (
            rational(entry) for entry in (self.noise.q13, self.noise.q23, self.noise.rate)
        )
        second = 3 * eta**2 + 2 * a1 * eta + a2 + 2 * XI**2 - 4 * XI * eta
        second += (4 - 4 * a1 + 16 * rate) * XI
        return {
            "updated_22": sp.expand(second / 16),
            "updated_23": sp.expand(XI * ((eta + 1 - XI) / 4 + q23 / 2 - q13)),
            "updated_33": sp.expand(XI * (XI / 2 - q23)),
        }

    def derivative(self, entry: sp.Expr) -> sp.Expr:
        """2 f - omega xi df/dxi of f = entry/xi, times 2 xi^3 delta tau."""
        s, eta = self.k.spectrum, self.eta
        a1, a2, e = rational(s.a1), rational(s.a2), rational(s.e)
        g, h = eta**2 - a2, (3 * eta**2 + 2 * a1 * eta + a2) / 2
        slope = XI * by(entry, XI) - entry
        return sp.expand(2 * entry * g * h - 2 * (g**2 / 4 - e * XI**2) * slope)

    def value(self, polynomial: sp.Expr) -> Any:
        """A polynomial in xi over its highest power.

        Raises ArithmeticError where it has no form without subtraction.
        """
        terms = positive_terms(self.k.spectrum, polynomial)
        degree = max(i + j for i, j in terms)
        rows = []
        for i in range(max(i for i, _ in terms) + 1):
            row: list[Any] = [0] * (degree - i + 1)
            for (power, j), factor in terms.items():
                if power == i:
                    row[degree - i - j] = node_of(factor, self.k.b, self.k.root_e)
            rows.append(horner(self.b.v, row))
        return horner(self.h, rows)


def updated_covariance(k: KernelBasis, noise: Noise) -> Forms:
    """Entries of the updated covariance in units of sigma_v^2 and T."""
    found = gains(k, noise)
    first = {f"updated_1{n}": found[name] for n, name in _numbered(found)}
    if k.spectrum.rational_in_root:
        return {**first, **kernel_rational.entries(kernel_rational.Rational(k, noise))}
    x = Updated(k, noise)
    return {
        **first,
        **{
            name: k.index * _power(x, k.index, DEGREES[name], x.value(entry))
            for name, entry in x.entries.items()
        },
    }


def _power(x: Updated, small: Any, degree: int, value: Any) -> Any:
    """small xi^degree value."""
    xi = x.b.xi
    found = small * xi
    for _ in range(degree - 1):
        found = found * xi
    return found * value


def _numbered(found: Forms) -> list[tuple[int, str]]:
    return list(enumerate(found, start=1))


def updated_covariance_derivatives(k: KernelBasis, noise: Noise) -> Forms:
    """Of the updated covariance."""
    found = gain_derivatives(k, noise)
    first = {f"updated_1{n}": found[name] for n, name in _numbered(found)}
    if k.spectrum.rational_in_root:
        return {**first, **kernel_rational.derivatives(kernel_rational.Rational(k, noise))}
    x = Updated(k, noise)
    cubes = (x.b.cube * HALF) * (((k.x * k.x) * (k.x / k.r)) / k.c)
    return {
        **first,
        **{
            name: _power(x, k.index, DEGREES[name], x.value(x.derivative(entry)) * cubes)
            for name, entry in x.entries.items()
        },
    }
