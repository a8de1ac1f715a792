"""The quantities of a model that a claim file may name, with their units.

Indices count from 1: `filter_gain.2` is the gain of the velocity. Gains are the dimensionless ones:
the gain that multiplies the innovation in component i is `filter_gain.i` / T^(i-1). `gain.i` and
`covariance.i.j` are what the source calls its gain and its covariance; the conventions of the
setting say which they are, and scale gains if it has to be. States are
those of the filter of the setting: at sample k `predicted_state` uses samples 0 to k-1 and
`updated_state` samples 0 to k; `previous_state` is the updated state of sample k-1. The index k of
the first sample is 0.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from types import MappingProxyType

from gainproof.verify.judge.claim.record import Unit

_MOST_STATES = 4
_ORDERS = range(5)
_ONE = Unit()
_METRE = Unit(metre=Fraction(1))
_COVARIANCES = {
    "covariance": "covariance, by the conventions of the setting",
    "predicted_covariance": "predicted covariance",
    "updated_covariance": "updated covariance",
}


@dataclass(frozen=True)
class QuantityName:
    """Name, unit and meaning of a quantity of a model."""

    name: str
    unit: Unit
    meaning: str


def _motion(order: int) -> Unit:
    return Unit(metre=Fraction(1), second=Fraction(-order))


def _covariance(i: int, j: int) -> Unit:
    return Unit(metre=Fraction(2), second=Fraction(-(i + j - 2)))


def quantity_names() -> Mapping[str, QuantityName]:
    """All names that `quantity = "..."` accepts."""
    found = [
        QuantityName("sample_number", _ONE, "number k of the newest sample, the first being 0"),
        QuantityName(
            "forgetting_factor", _ONE, "weight of a sample over that of the next newer one"
        ),
        QuantityName("sampling_interval", Unit(second=Fraction(1)), "time T between samples"),
        QuantityName("tracking_index", _ONE, "square root of the dimensionless noise ratio"),
        QuantityName(
            "measurement_noise_variance", Unit(metre=Fraction(2)), "variance of a measured position"
        ),
        QuantityName(
            "measurement_noise_deviation", _METRE, "standard deviation of a measured position"
        ),
        QuantityName(
            "velocity_deviation_ratio",
            _ONE,
            "deviation of a measured velocity, in units of that of a measured position over T",
        ),
        QuantityName(
            "exact_velocity_covariance.1.1",
            Unit(metre=Fraction(2)),
            "predicted variance of the position in the limit of exactly measured velocities",
        ),
        QuantityName(
            "no_velocity_covariance.1.1",
            Unit(metre=Fraction(2)),
            "predicted variance of the position in the limit of velocities that say nothing",
        ),
        QuantityName("innovation_variance", Unit(metre=Fraction(2)), "variance of the innovation"),
        QuantityName("measurement", _METRE, "position measured at sample k"),
        QuantityName("first_measurement", _METRE, "position measured at sample 0"),
        QuantityName("first_updated_state.1", _METRE, "updated position at sample 0"),
    ]
    found += [
        QuantityName(
            f"gain_matrix.{i}.{j}",
            Unit(second=Fraction(j - i)),
            f"entry of K: component {i} for the measurement of component {j}",
        )
        for i in (1, 2)
        for j in (1, 2)
    ]
    found += [
        QuantityName(f"target_motion.{m}", _motion(m), f"constant derivative {m} of the target")
        for m in _ORDERS
    ]
    found += [
        QuantityName(
            f"closed_loop_coefficient.{j}", _ONE, f"of z^{j} in det(zI - F (I - K H)), T = 1"
        )
        for j in range(_MOST_STATES + 1)
    ]
    for i in range(1, _MOST_STATES + 1):
        found += [
            QuantityName(
                f"{which}_lag.{i}.{m}",
                _motion(i - 1),
                f"steady error of component {i} of the {which} state, derivative {m} constant",
            )
            for which in ("predicted", "updated")
            for m in _ORDERS
        ]
        found += [
            QuantityName(
                f"continuous_gain.{i}",
                Unit(second=Fraction(-i)),
                f"component {i} of the gain of a Kalman-Bucy filter",
            ),
            QuantityName(f"gain.{i}", _ONE, f"gain {i}, by the conventions of the setting"),
            QuantityName(f"filter_gain.{i}", _ONE, f"component {i} of K, times T^{i - 1}"),
            QuantityName(f"predictor_gain.{i}", _ONE, f"component {i} of F K, times T^{i - 1}"),
            QuantityName(
                f"predicted_state.{i}", _motion(i - 1), f"component {i} of the predicted state"
            ),
            QuantityName(
                f"updated_state.{i}", _motion(i - 1), f"component {i} of the updated state"
            ),
            QuantityName(
                f"previous_state.{i}", _motion(i - 1), f"component {i} updated at sample k-1"
            ),
        ]
        found += [
            QuantityName(f"{which}.{i}.{j}", _covariance(i, j), f"entry of the {meaning}")
            for which, meaning in _COVARIANCES.items()
            for j in range(1, _MOST_STATES + 1)
        ]
    return MappingProxyType({quantity.name: quantity for quantity in found})
