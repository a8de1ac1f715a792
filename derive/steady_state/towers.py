"""Towers of radicals in which the two-state steady state and its limits live."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from gainproof.derive.algebra.leading_terms import prime_powers
from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.expression import real
from gainproof.derive.steady_state.kernels import scale_of, symbolic_forms, unit_root
from gainproof.derive.steady_state.names import ALPHA, BETA, DEVIATION, INDEX, RHO, ROOT

ROOT_16 = real("H")
ROOT_S = real("s")


def rational(value: Fraction) -> sp.Rational:
    """A fraction as a SymPy number."""
    return sp.Rational(value.numerator, value.denominator)


def root_of_16(e: Fraction) -> sp.Expr:
    """sqrt(16 + e Lambda^2): a generator, or 4 when e = 0."""
    return ROOT_16 if e else sp.Integer(4)


def main_tower(e: Fraction, n: Fraction) -> Tower:
    """p = sqrt(Lambda), H = sqrt(16 + e p^4), s = sqrt((1 + e) p^2 + 2 H)/2; the steady state.

    alpha, beta and the innovation's deviation are what factorisation gives; the covariances are
    those of `kernels.md`, as are psi and chi.
    """
    ratio = rational(e)
    generators = [Generator("H", 16 + ratio * ROOT**4)] if e else []
    generators.append(Generator("s", ((1 + ratio) * ROOT**2 + 2 * root_of_16(e)) / 4))
    elements = steady_elements(e, n, ROOT**2) | symbolic_forms(e, n, ("psi", "chi"))
    return Tower("main", (Parameter("p"),), tuple(generators), elements)


def steady_elements(e: Fraction, n: Fraction, index: sp.Expr) -> dict[str, sp.Expr]:
    """The named quantities over p, H and s; predicted entries polynomial, for short cofactors."""
    p, high, s = ROOT, root_of_16(e), ROOT_S
    rate = p**3 * (s - rational(n) * p)
    deviation = (p**2 + high + 2 * p * s) / 4
    return {
        "tracking_index": index,
        "kappa": high / (2 * INDEX),
        "rho": s / p,
        "innovation_deviation": deviation,
        "alpha": p * s / DEVIATION,
        "beta": INDEX / DEVIATION,
        "predicted_11": p * s * DEVIATION,
        "predicted_12": INDEX * DEVIATION,
        "predicted_22": rate + INDEX**2,
        "updated_11": ALPHA,
        "updated_12": BETA,
        **symbolic_forms(e, n, ("updated_22",)),
        "predictor_position": ALPHA + BETA,
        "rest": 1 / DEVIATION**2,
    }


def graph_roots(e: Fraction) -> dict[str, sp.Expr]:
    """Tower values of the roots that formulas of kernels are over."""
    root = rational(unit_root(e))
    return {
        "p": ROOT,
        "h_scaled": root**2 * root_of_16(e) / (2 * ROOT),
        "rho_scaled": root * RHO,
    }


def at_once_roots(e: Fraction) -> dict[str, sp.Expr]:
    """Tower values of the roots of gains with derivatives."""
    scale = rational(scale_of(e))
    return {
        "p": ROOT,
        "h_at_once": scale * root_of_16(e) / ROOT,
        "twice_ratio": scale * 2 * ROOT_S,
    }


def surd(value: Fraction) -> tuple[sp.Expr, dict[str, int]]:
    """sqrt(value) as a rational times at most one root of a squarefree integer, with its name."""
    number = value.numerator * value.denominator
    outside, inside = 1, 1
    for prime, power in prime_powers(number).items():
        outside *= prime ** (power // 2)
        inside *= prime ** (power % 2)
    factor = sp.Rational(outside, value.denominator)
    if inside == 1:
        return factor, {}
    return factor * real(f"root_{inside}"), {f"root_{inside}": inside}


def start(e: Fraction) -> End:
    """Lambda -> 0: H -> 4, s -> sqrt(2)."""
    boundary: dict[str, sp.Expr] = {"H": sp.Integer(4)} if e else {}
    boundary["s"] = real("root_2")
    return End(constants={"root_2": 2}, boundary=boundary)


def end(e: Fraction) -> End:
    """Lambda -> infinity: H/p^2 -> sqrt(e), s/p -> (1 + sqrt(e))/2."""
    root, constants = surd(e) if e else (sp.Integer(0), {})
    weights, boundary = {"s": 1}, {"s": (1 + root) / 2}
    if e:
        weights, boundary = {"H": 2, **weights}, {"H": root, **boundary}
    return End(weights=weights, constants=constants, boundary=boundary)
