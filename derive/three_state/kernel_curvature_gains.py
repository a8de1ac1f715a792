"""Second derivatives of the gains by the index, in the numbers of `kernel_curvature`."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from gainproof.derive.three_state.kernel_basis import KernelBasis
from gainproof.derive.three_state.kernel_curvature import Bend, times
from gainproof.derive.three_state.kernel_forms import HALF, QUARTER, Forms, Noise, total


def falling(b: Bend) -> Forms:
    """The negatives of the second derivatives of the filter gain."""
    k, whole = b.k, b.k.total
    sigma, per = k.deviation, k.index
    first = b.xi * ((b.growth_over_xi * b.growth) * 2 + b.bent)
    step = (k.x * k.r) / whole
    second = ((step / per) * HALF) * ((b.fall * (k.e / whole)) * _second_gain(b))
    third = b.fall * (b.xi * (b.growth_over_xi * _ahead(b, step) + b.bulk))
    return {
        "alpha": ((((first * 2) / per) / sigma) / sigma) / per,
        "beta": second / per,
        "gamma": (third / sigma) / per,
    }


def _ahead(b: Bend, step: Any) -> Any:
    """(tau + xi + xi^2)/nu; `step` is beta."""
    over = (b.eta * (b.t * HALF)) / b.square
    return (step * QUARTER) * ((over + 1) + b.xi)


def _second_gain(b: Bend) -> Any:
    """-beta'' nu Lambda^2/(beta omega eta).

    Raises ArithmeticError where a1^2 < a2, for which there is no such form.
    """
    s, low = b.k.spectrum, b.low
    a1, a2 = s.a1, s.a2
    if a1 * a1 < a2:
        raise ArithmeticError("no form of the second derivative of beta without subtraction")
    quartic = b.polynomial(
        Fraction(3, 2),
        7 * a1 / 2,
        6 * a2 + 3 * a1 * a1 / 2,
        9 * a1 * a2 / 2,
        (a2 * a2 + a1 * a1 * a2) / 2,
    )
    square = (b.polynomial(3, 3 * a1, a1 * a1 - a2) / b.t) * 2
    mass = ((b.k.c / b.k.e) * 2) * square
    main = ((b.growth * low) * 2 + ((low / b.t) * (quartic / b.t)) * 4) + b.fall * (b.square + mass)
    if b.share is None:
        return main
    wide = (b.wide * b.t) * HALF
    rest = b.share * ((b.wide * b.t) * b.eta + low * square)
    return total(main, rest, times(b.ratio, (b.eta / b.xi) * wide + low))


def gain_second_derivatives(k: KernelBasis, _: Noise) -> Forms:
    """Of the filter gain, all negative."""
    return {name: -value for name, value in falling(Bend(k)).items()}


def predictor_gain_second_derivatives(k: KernelBasis, _: Noise) -> Forms:
    """Of the predictor gain, all negative."""
    found = falling(Bend(k))
    alpha, beta, gamma = found["alpha"], found["beta"], found["gamma"]
    return {
        "position": -(alpha + (beta + gamma * HALF)),
        "velocity": -(beta + gamma),
        "acceleration": -gamma,
    }
