"""Steps on the closed-loop poles: where a pair is complex and where all three are real."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Tower
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.model import ModelError
from gainproof.derive.relation import Relation, cited, equal, positive, same_sign
from gainproof.derive.source import ALGEBRA
from gainproof.derive.steady_state.spectrum import V
from gainproof.derive.steady_state.towers import surd
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.names import INDEX, NU, REST, TAU, XI, Z
from gainproof.derive.three_state.steps_spectrum import polynomial_text

W = real("w")


@dataclass(frozen=True)
class Turning:
    """The discriminant of v^3 + q noise(v), divided by q^2, as a polynomial in q = Lambda^2.

    `value`: its positive root, at which the poles turn real, over `tower`; None where it is
    negative for every q. `factor`: the polynomial over (q - value), positive.
    """

    quotient: sp.Expr
    value: sp.Expr | None
    factor: sp.Expr
    tower: Tower


def turning(c: Context) -> Turning:
    """Where the discriminant changes its sign."""
    q = sp.Symbol("q")
    polynomial = sp.Poly(sp.cancel(sp.discriminant(V**3 + q * c.spectrum.noise, V) / q**2), q)
    second, first, constant = (polynomial.coeff_monomial(q**n) for n in (2, 1, 0))
    quotient = polynomial.as_expr().subs(q, INDEX**2)
    if second <= 0 and first <= 0:
        return Turning(quotient, None, sp.Integer(1), c.tower)
    if second == 0:
        return Turning(quotient, -constant / first, first, c.tower)
    if second < 0:
        raise ModelError(
            f"model {c.model.name}: poles that turn real at one index at most are wanted, the "
            f"discriminant {polynomial.as_expr()} may change its sign twice"
        )
    outside, names = surd(Fraction(str(first**2 - 4 * second * constant)))
    generators = tuple(Generator(name, sp.Integer(number)) for name, number in names.items())
    kept = {entry.symbol for entry in c.tower.generators}
    generators = tuple(entry for entry in generators if entry.symbol not in kept)
    tower = c.tower
    if generators:
        tower = Tower(
            "turning",
            tower.parameters,
            (*generators, *tower.generators),
            tower.expressions,
        )
    value = sp.expand((-first + outside) / (2 * second))
    other = (first + outside) / (2 * second)
    return Turning(quotient, value, second * (INDEX**2 + other), tower)


def pole_steps(c: Context) -> list[Step]:
    """From the poles to the roots v of a cubic, and the sign of its discriminant."""
    found = turning(c)
    a0, a1, a2 = (c.spectrum.closed_loop.coeff(Z, n) for n in range(3))
    discriminant = a1**2 * a2**2 - 4 * a1**3 - 4 * a0 * a2**3 + 18 * a0 * a1 * a2 - 27 * a0**2
    apart = 1 - REST**2 - a1 - REST * a2
    noise = polynomial_text(c.spectrum.noise, V)
    return [
        Step(
            "products-of-poles",
            "To each pole `z` belongs one `v = 2 - z - 1/z`, and these are the roots of the cubic "
            f"`v^3 + Lambda^2 ({noise})`. No two poles have the product 1: with `c0`, `c1` and "
            "`c2`, the coefficients of `c(z)`, the product of the three numbers `1 - z1 z2` is the "
            "left side here.",
            equal(apart, 8 * TAU * _apart_factor(c, apart)),
            "At a pole the right side of step @factorisation vanishes. The product is "
            "`1 - c0^2 - c1 + c0 c2`, and `c0 = -(1 - alpha)`; insert the gains.",
            heading="The poles",
        ),
        Step(
            "discriminants",
            "The discriminant of `c(z)` has the sign of that of the cubic.",
            equal(discriminant * apart**2, INDEX**4 * found.quotient * REST**4),
            "`v1 - v2 = (z1 - z2)(1 - z1 z2)/(z1 z2)`; multiply the squares of the three "
            "differences.",
        ),
        *_turning_step(found, discriminant),
        *_in_root(c),
    ]


def _in_root(c: Context) -> list[Step]:
    """Where all is rational in w, so are the real pole and the quadratic of the others."""
    if not c.spectrum.rational_in_root:
        return []
    a2 = c.spectrum.closed_loop.coeff(Z, 2)
    half_sum = (XI**2 - 8) / (XI * (XI + 2))
    factors = ((Z - W), (Z**2 - 2 * half_sum * Z + W))
    c_of_z = sum(c.spectrum.closed_loop.coeff(Z, n) * Z**n for n in range(4))
    spread = 4 * (16 - 3 * XI**2) / (XI * (XI + 2)) ** 2
    return [
        Step(
            "poles-in-w",
            "Here the cubic has a factor for every index: one pole is the positive number `w`, "
            "`w^2 = 1 - alpha`; the product of the other two is `w` as well.",
            equal(c_of_z, sp.Mul(*factors, evaluate=False), free=("z",)),
            "`d(s) = (1 + xi s/2)(1 + xi s/2 + (xi^2/4 - 1) s^2)`: insert "
            "`eta = xi^2/2 - 1` and `delta = xi (xi^2 - 4)/8`, and `s = (z - 1)/(z + 1)`. "
            "`w = (xi - 2)/(xi + 2)`.",
        ),
        joined("half-sum-of-pair", equal(-a2 - W, 2 * half_sum)),
        Step(
            "spread-of-pair",
            "The square of half the distance of these two: they are a complex pair while "
            "`3 xi^2` is more than 16.",
            equal(half_sum**2 - W, spread),
            "Half their sum, squared, less their product.",
        ),
    ]


def _apart_factor(c: Context, apart: sp.Expr) -> sp.Expr:
    """apart/(8 tau) as a number over nu^2."""
    value = c.tower.expression(c.tower.fraction(apart * NU**2 / (8 * TAU)))
    return sp.sympify(value) / NU**2


def _turning_step(found: Turning, discriminant: sp.Expr) -> list[Step]:
    scale = INDEX**4 * REST**4 / (8 * TAU / NU**2) ** 2
    if found.value is None:
        return [
            Step(
                "discriminant",
                "One pole is real and two are a complex pair, for every index; real radicals, of "
                "Cardano's formula, give them everywhere.",
                positive(-discriminant),
                "The discriminant of the cubic is negative.",
                hint={"form": -found.quotient * scale},
            )
        ]
    return [
        Step(
            "discriminant",
            "Up to one index one pole is real and two are a complex pair; beyond it all three are "
            "real.",
            same_sign(discriminant, INDEX**2 - found.value),
            "The discriminant of the cubic is a positive multiple of the right side. A real `v` "
            "lies outside 0 to 4, since no pole lies on the circle; so its `z` is real.",
            tower=found.tower.name,
            hint={"form": found.factor * scale},
        ),
        Step(
            "real-radicals",
            "There, too, real radicals end: up to that index Cardano's formula gives `v` by real "
            "roots of real numbers; beyond it, with three real `v`, there is none unless the cubic "
            "has a rational factor.",
            _casus(),
            "The theorem on the casus irreducibilis is cited, not proved here. The equations of "
            "step @three-equations need no such formula.",
        ),
    ]


def _casus() -> Relation:
    return cited(
        "An irreducible cubic with three real roots has none that real radicals express.",
        ALGEBRA.text(),
    )
