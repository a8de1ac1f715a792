"""First derivatives by the index of a kernel's basis, in positive terms.

phi = (Lambda/sigma) d sigma/d Lambda = (eta + m1 + e xi/delta)/tau carries the gains:
alpha' = 2 phi/(Lambda sigma^2). Polynomials in eta come times Lambda/64: `curve` is
3 eta^2 + 2 a1 eta + a2 = 2 xi tau, `wide` eta^2 + a1 eta + a2 = xi (tau - delta), the others are
those of `forms`.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gainproof.derive.three_state.kernel_basis import KernelBasis
from gainproof.derive.three_state.kernel_forms import (
    HALF,
    QUARTER,
    Forms,
    Noise,
    curve,
    total,
    weighted,
)


@dataclass(frozen=True)
class Rates:
    """Curve, wide, phi, the share e/(delta tau), (tau - delta)/tau and 1 more than that."""

    curve: Any
    wide: Any
    phi: Any
    share: Any
    ahead: Any
    grown: Any


def rates(k: KernelBasis) -> Rates:
    """What the derivatives have in common."""
    s = k.spectrum
    below = curve(k)
    wide = total((k.e * k.e) * QUARTER, (k.p * k.e) * (s.a1 / 16), weighted(k.index, s.a2 / 64))
    step = k.x * k.r
    by_e = None if s.e == 0 else ((step / k.c) * k.p) * (s.e / 16)
    rise = total(k.e, weighted(k.p, s.m1 * QUARTER), by_e)
    share = None if s.e == 0 else ((k.index / below) * (step / k.c)) * (s.e / 128)
    ahead = (wide / below) * 2
    return Rates(below, wide, (rise / below) * (step * QUARTER), share, ahead, ahead + 1)


def _times_variance(k: KernelBasis) -> Forms:
    """The derivatives of the gains times sigma^2."""
    s, found = k.spectrum, rates(k)
    slope = k.x / (k.p * k.r)
    rise = total(k.e, weighted(k.p, s.m1 * QUARTER))
    second = total(found.wide, (k.x * k.r) * (rise * Fraction(1, 8)))
    third = ((k.x * k.r) / found.curve) * ((k.x * QUARTER) * (k.x + k.r * HALF)) + 1
    return {
        "alpha": (found.phi / k.index) * 2,
        "beta": ((second / found.curve) * (slope / k.c)) * 2,
        "gamma": third if s.e == 0 else third / (k.c * k.p),
    }


def _over_variance(k: KernelBasis, forms: Forms) -> Forms:
    sigma = k.deviation
    return {name: (value / sigma) / sigma for name, value in forms.items()}


def gain_derivatives(k: KernelBasis, _: Noise) -> Forms:
    """Of the filter gain."""
    return _over_variance(k, _times_variance(k))


def predictor_gain_derivatives(k: KernelBasis, _: Noise) -> Forms:
    """Of the predictor gain."""
    found = _times_variance(k)
    alpha, beta, gamma = found["alpha"], found["beta"], found["gamma"]
    sums = {
        "position": alpha + (beta + gamma * HALF),
        "velocity": beta + gamma,
        "acceleration": gamma,
    }
    return _over_variance(k, sums)


def _deviation_rate(k: KernelBasis, found: Rates) -> Any:
    return (found.phi / k.p) * k.total


def predicted_covariance_derivatives(k: KernelBasis, noise: Noise) -> Forms:
    """Of the predicted covariance."""
    s, found, sigma = k.spectrum, rates(k), k.deviation
    step = (k.p * k.r) * k.x
    xi = (k.x / k.r) * 2
    grown = total(found.grown, found.share)
    eta, below = k.e * k.p, found.curve
    linear = total(
        (k.e * k.e) * QUARTER, (k.p * k.e) * (s.a1 * 3 / 64), weighted(k.index, s.a2 / 64)
    )
    cubic = total(
        eta * ((linear / below) * 4),
        None if s.a2 == 0 else ((k.index / below) * k.index) * (s.a1 * s.a2 / 256),
    )
    return {
        "predicted_11": _deviation_rate(k, found) * (sigma * 2),
        "predicted_12": ((k.x / k.r) * total(found.ahead, found.phi, found.share)) * sigma,
        "predicted_13": sigma * (found.phi + 1),
        "predicted_22": total(
            _quartic(k, found),
            (step * HALF) * (found.grown * HALF),
            cubic,
            _shared(k, found, step, xi),
            weighted(k.index, HALF + 2 * noise.rate),
        ),
        "predicted_23": total(
            (step * HALF) * total(found.grown, weighted_share(found.share, xi)),
            cubic,
            weighted(k.index, HALF + noise.q23 - 2 * noise.q13),
        ),
        "predicted_33": total(step * grown, weighted(k.index, 2 * (1 - noise.q23))),
    }


def weighted_share(share: Any, xi: Any) -> Any:
    """share (1 + xi), or None."""
    return None if share is None else share * (xi + 1)


def _quartic(k: KernelBasis, found: Rates) -> Any:
    """Lambda (2 tau^2 - delta^2 - delta xi^3)/(8 tau)."""
    a1, a2 = k.spectrum.a1, k.spectrum.a2
    square = total(
        (k.e * k.e) * Fraction(9, 16),
        (k.p * k.e) * (a1 / 4),
        weighted(k.index, (6 * a1 * a1 + 22 * a2) / 256),
    )
    rest = total(
        weighted(k.e * k.p, a1 * a2 / 4), weighted(k.index, (a2 * a2 + 2 * a1 * a1 * a2) / 256)
    )
    below = found.curve
    first = ((k.e * (square / below)) * (k.e / k.x)) * (k.r * 2)
    return first + ((rest / below) * (k.index / k.x)) * (k.r * Fraction(1, 8))


def _shared(k: KernelBasis, found: Rates, step: Any, xi: Any) -> Any:
    """Lambda (e/delta)(delta + xi + 2 xi^2 + xi^3)/(8 tau), or None."""
    if found.share is None:
        return None
    inner = total((k.c * k.p) * 8, (step * 2) * (xi * (xi + 2) + 1))
    return found.share * (inner / 8)
