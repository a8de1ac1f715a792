"""Derivatives of the steady state with respect to Lambda; see `first_derivatives`."""

from __future__ import annotations

from typing import Any

from gainproof.derive.vector_measurement.first_derivatives import Rates
from gainproof.derive.vector_measurement.process_noise import times, total

Parts = tuple[Any, Any]
"""A positive term and another that is taken from it, where the difference may have either sign."""


def _with_second(r: Rates, first: Any, one: Any, minus_one: Any) -> Any:
    """`first` and d times the wave of the noise's second direction, where there is one."""
    d = r.x.noise.determinant
    return first + times(d, r.wave(one, minus_one)) if d else first


def _by_index(r: Rates, value: Any) -> Any:
    return (r.x.index / r.x.delta) * value


def _updated_11_by_index(r: Rates) -> Any:
    first = r.squares(r.share / r.sigma, r.turned / r.sigma)
    one, other = r.velocity / r.sigma, (r.velocity + 2) / r.sigma
    return _by_index(r, _with_second(r, first, one * one, other * other))


def _updated_22_by_index(r: Rates) -> Any:
    square = r.x.cross * r.x.cross
    first = r.squares(r.lead / r.sigma, r.lead_and_two / r.sigma)
    return _by_index(r, _with_second(r, first, square, square))


def updated_12_parts(r: Rates) -> Parts:
    """The growing and the falling part of the updated cross term as a function of Lambda."""
    grows = (r.share / r.sigma) * (r.lead / r.sigma) / r.x.one_end
    falls = (r.turned / r.sigma) * (r.lead_and_two / r.sigma) / r.x.eta
    one = r.x.cross * (r.velocity / r.sigma)
    other = r.x.cross * ((r.velocity + 2) / r.sigma)
    return _by_index(r, grows), _by_index(r, _with_second(r, falls, one, other))


def _predicted_11_by_index(r: Rates) -> Any:
    turned = r.turned if r.x.noise.interval else r.share
    first = r.squares(r.sigma * r.share, r.sigma * turned)
    one, other = r.rate, r.sigma * r.doubled
    return _by_index(r, _with_second(r, first, one * one, other * other))


def _predicted_12_by_index(r: Rates) -> Any:
    x = r.x
    if not x.noise.interval:
        both = total(r.predicted["predicted_11"], r.updated["updated_11"], r.updated["updated_12"])
        return (x.cross / x.index) * (r.sigma * 2 * both) / (x.eta * x.delta)
    own = x.one_end
    one = (x.cross / x.index) * ((own + r.updated["updated_22"] / own) / x.index)
    weight = (x.ratio * x.ratio) * x.width + x.index * x.sigma_scaled
    both = one + r.turned * (weight / r.both_scaled)
    if x.noise.determinant:
        both = both + times(x.noise.determinant, x.cross * r.doubled / x.eta)
    return (x.index / x.delta) * (r.sigma * both)


def updated_by_index(r: Rates) -> dict[str, Any]:
    """Derivatives of the updated variances with respect to Lambda."""
    return {"updated_11": _updated_11_by_index(r), "updated_22": _updated_22_by_index(r)}


def predicted_by_index(r: Rates) -> dict[str, Any]:
    """Derivatives of the predicted covariance with respect to Lambda."""
    return {
        "predicted_11": _predicted_11_by_index(r),
        "predicted_12": _predicted_12_by_index(r),
        "predicted_22": _updated_22_by_index(r) + r.x.index * 2,
    }


def gains_by_index(r: Rates) -> dict[str, Any]:
    """Derivatives of the gains that grow with Lambda."""
    velocity = (_updated_22_by_index(r) / r.x.ratio) / r.x.ratio
    return {"gain_11": _updated_11_by_index(r), "gain_22": velocity}


def gain_12_parts(r: Rates) -> Parts:
    """The growing and the falling part of K12 as a function of Lambda."""
    grows, falls = updated_12_parts(r)
    return (grows / r.x.ratio) / r.x.ratio, (falls / r.x.ratio) / r.x.ratio
