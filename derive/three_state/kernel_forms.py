"""Gains and covariances of a kernel's basis: sums, products and quotients of positive terms.

x = xi - (1 + b) has no difference either: by xi^2 = a1 + 2 eta and eta^2 = a2 + 2 delta xi at both
ends x ((xi + xi0)(eta + eta0) - 4 c) = 4 xi (delta - c), where xi0 = 1 + b and eta0 = b + c, and
delta - c = 64/(Lambda^2 (delta + c)). The product with Lambda is `excess`.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gainproof.derive.three_state.kernel_basis import KernelBasis

Forms = dict[str, Any]
QUARTER, HALF = Fraction(1, 4), Fraction(1, 2)


@dataclass(frozen=True)
class Noise:
    """Entries of Q0, and `rate` = Q22 - Q12 - Q13/2 - Q23/4."""

    q13: Fraction
    q23: Fraction
    rate: Fraction


def weighted(value: Any, number: Any) -> Any:
    """value times a number, or None where that is zero."""
    if number == 0:
        return None
    return value if number == 1 else value * number


def total(*terms: Any) -> Any:
    """The sum of those terms that are not None, from the left."""
    first, *others = (term for term in terms if term is not None)
    for term in others:
        first = first + term
    return first


def gains(k: KernelBasis, _: Noise) -> Forms:
    """The filter gain."""
    below = k.total
    return {
        "alpha": (k.e + k.p * QUARTER) / below,
        "beta": (k.x * k.r) / below,
        "gamma": k.p / below,
    }


def predictor_gains(k: KernelBasis, _: Noise) -> Forms:
    """The predictor gain F K."""
    below, step = k.total, k.x * k.r
    return {
        "position": (k.e + (step + k.p * Fraction(3, 4))) / below,
        "velocity": (step + k.p) / below,
        "acceleration": k.p / below,
    }


def innovation(k: KernelBasis, _: Noise) -> Forms:
    """The standard deviation of an innovation."""
    return {"innovation_deviation": k.deviation}


def pole_product(k: KernelBasis, _: Noise) -> Forms:
    """The product of the three poles, 1 - alpha = 1/sigma^2."""
    root = 1 / k.deviation
    return {"pole_product": root * root}


def curve(k: KernelBasis) -> Any:
    """Lambda (3 eta^2 + 2 a1 eta + a2)/64, which is Lambda xi tau/32."""
    s = k.spectrum
    return total(
        (k.e * k.e) * Fraction(3, 4), (k.p * k.e) * (s.a1 / 8), weighted(k.index, s.a2 / 64)
    )


def predicted_covariance(k: KernelBasis, noise: Noise) -> Forms:
    """Entries of the predicted covariance in units of sigma_v^2 and T."""
    sigma = k.deviation
    step = (k.p * k.r) * k.x
    eta = k.p * k.e
    return {
        "predicted_11": ((k.e + k.p * QUARTER) * k.p) * sigma,
        "predicted_12": step * sigma,
        "predicted_13": k.index * sigma,
        "predicted_22": k.index
        * total(
            (curve(k) / k.x) * (k.r * 2),
            step * QUARTER,
            eta,
            weighted(k.index, QUARTER + noise.rate),
        ),
        "predicted_23": k.index
        * total(eta, step * HALF, weighted(k.index, QUARTER + noise.q23 / 2 - noise.q13)),
        "predicted_33": k.index * total(step, weighted(k.index, 1 - noise.q23)),
    }


def excess(k: KernelBasis) -> Any:
    """Lambda (xi - 1 - b)."""
    s, b, c = k.spectrum, k.b, k.root_e
    least = (s.m1 + b * c) + ((s.m1 - s.m2) + c * 2) / (b + c)
    below = total(
        k.e * k.x,
        (k.x * k.p) * ((b + c) * QUARTER),
        (k.e * k.r) * ((1 + b) * HALF),
        (k.p * k.r) * (least * Fraction(1, 8)),
    )
    both = k.c if c == 0 else k.c + k.p * (c * Fraction(1, 8))
    return ((k.x * 8) / both) / below
