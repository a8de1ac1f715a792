"""Derivatives of the steady state with respect to S; see `first_derivatives`."""

from __future__ import annotations

from typing import Any

from gainproof.derive.vector_measurement.derivatives_by_index import Parts, updated_by_index
from gainproof.derive.vector_measurement.first_derivatives import Rates
from gainproof.derive.vector_measurement.process_noise import total


def _by_ratio(r: Rates, value: Any) -> Any:
    """value S/delta."""
    return (r.x.ratio / r.x.delta) * value


def _fast(r: Rates) -> Any:
    """sigma (2 K12 + K22); for n = 1/2 the sum is twice K12 + K22/2."""
    if r.x.noise.interval:
        return (r.sigma * r.turned) * 2
    return 2 * ((r.x.cross / r.x.ratio) / r.x.ratio) + r.rate


def predicted_by_ratio(r: Rates) -> dict[str, Any]:
    """Derivatives of the predicted covariance with respect to S."""
    rate, fast, slow, rest = r.rate, _fast(r), r.slow, r.x.rest
    return {
        "predicted_11": _by_ratio(r, r.squares(rate, fast)),
        "predicted_12": _by_ratio(r, r.wave(rate * rest, fast * slow)),
        "predicted_22": _by_ratio(r, r.squares(rest, slow)),
    }


def updated_by_ratio(r: Rates) -> dict[str, Any]:
    """Derivatives of the updated covariance with respect to S."""
    if not r.x.noise.interval:
        first, cross = _first_with_independent_noise(r), _cross_with_independent_noise(r)
    else:
        one, minus_one = r.velocity / r.sigma, (r.turned / r.sigma) * 2
        first = _by_ratio(r, r.squares(one, minus_one))
        cross = _by_ratio(r, r.wave(one * r.x.rest, minus_one * r.slow))
    rate = _by_ratio(r, r.squares(r.x.rest, r.slow))
    return {"updated_11": first, "updated_12": cross, "updated_22": rate}


def _first_with_independent_noise(r: Rates) -> Any:
    """For n = 0, where 2 U12 + U22 - Lambda^2 has no fixed sign but its square and that of P22 have
    a sum without a subtraction: 4 v^2 - 4 v + 2 = (8 v^4 + 2)/(2 v^2 + 2 v + 1).
    """
    x = r.x
    area = x.index * x.index
    v, y = r.updated["updated_12"] / area, r.updated["updated_22"] / area
    square = v * v
    both = (8 * (square * square) + 2) / (2 * square + 2 * v + 1) + (4 * v + 2 * y) * y
    t = x.velocity_index
    weight = ((8 + 2 * (t * t)) / x.mean) / x.index
    wave = (both + weight * ((y + 1) * (y + 1))) / x.eta
    scale = (area / x.ratio) / r.sigma
    return ((scale / x.ratio) * (scale / x.ratio)) * (x.ratio / x.delta) * wave


def _cross_with_independent_noise(r: Rates) -> Any:
    """For n = 0: the polynomial over sigma eta delta (S^2 + delta^2)^2, without a subtraction."""
    x = r.x
    t, index, eta, delta = x.velocity_index, x.index, x.eta, x.delta
    square, area = delta * delta, index * index
    inner = square + delta * eta * 3 / 2 + index * eta / 2 + area / 2
    top = total(
        (eta * square) * (delta + index) / 2,
        area,
        (t * t) * inner,
        4 * (t * t) * ((t / x.ratio) * delta),
    )
    below = x.ratio * x.ratio + square
    return ((index / r.sigma) * 2) * (x.ratio / below) * ((top / below) / (eta * delta))


def gain_22_by_ratio(r: Rates) -> Any:
    """How fast K22 falls as S grows: minus its derivative.

    A covariance is of degree one in the noise variances, so that U22 - S^2 dU22/dS^2 is what the
    position noise and the process noise give.
    """
    x = r.x
    noise = r.x.index * (updated_by_index(r)["updated_22"] / 2)
    both = (2 * x.cross) * (x.cross / (x.delta * x.eta)) + noise
    return ((2 / x.ratio) / x.ratio) * (both / x.ratio)


def gains_by_ratio(r: Rates) -> dict[str, Any]:
    """Derivatives of the gains with respect to S, but K12's, whose sign changes."""
    updated = updated_by_ratio(r)
    return {
        "gain_11": updated["updated_11"],
        "gain_21": updated["updated_12"],
        "gain_22": -gain_22_by_ratio(r),
    }


def gain_12_parts(r: Rates) -> Parts:
    """The growing and the falling part of K12 = U12/S^2 as a function of S."""
    grows = (updated_by_ratio(r)["updated_12"] / r.x.ratio) / r.x.ratio
    return grows, (r.gain["gain_12"] / r.x.ratio) * 2
