"""An estimate, or why there is none, as plain data for JSON."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Any

import numpy as np

from gainproof.location.errors import (
    DivergedError,
    LocationError,
    OnStationError,
    TooFewError,
    UnobservableError,
)
from gainproof.location.result import Bias, Convergence, Location, Place


def plain(found: Location) -> dict[str, Any]:
    """Metres and metres a second; null for what the method does not estimate or is not finite."""
    d = len(found.position)
    deviations = np.sqrt(np.diag(found.covariance))
    moving = found.velocity is not None
    told: dict[str, Any] = {
        "found": True,
        "method": found.method,
        "position_m": found.position.tolist(),
        "position_deviation_m": deviations[:d].tolist(),
        "velocity_m_s": found.velocity.tolist() if found.velocity is not None else None,
        "velocity_deviation_m_s": deviations[d : 2 * d].tolist() if moving else None,
        "covariance": found.covariance.tolist(),
        "covariance_of": [
            *(f"{axis}_m" for axis in "xyz"[:d]),
            *(f"v{axis}_m_s" for axis in "xyz"[:d] if moving),
            *(f"bias_{each.station}_m" for each in found.biases),
        ],
        "biases": [_bias(each) for each in found.biases],
        "convergence": _convergence(found.convergence),
        "rank": found.rank,
        "others": [_place(each) for each in found.others],
        "warnings": list(found.warnings),
    }
    if found.selection is not None:
        told["selection"] = {
            "false_alarm": found.selection.false_alarm,
            "threshold": found.selection.threshold,
            "ranges": [asdict(each) for each in found.selection.decisions],
        }
    if found.first is not None:
        told["bias_detection"] = plain(found.first)
    return told


def plain_failure(error: LocationError) -> dict[str, Any]:
    """Why there is none, with what the error knows."""
    told: dict[str, Any] = {"found": False, "reason": str(error)}
    if isinstance(error, TooFewError):
        told |= {"error": "too few observations", "need": error.need, "have": error.have}
    elif isinstance(error, UnobservableError):
        told |= {
            "error": "not observable",
            "directions": [asdict(each) for each in error.directions],
        }
    elif isinstance(error, OnStationError):
        told |= {"error": "target on a station", "station": error.station}
    elif isinstance(error, DivergedError):
        told |= {"error": "not converged", "convergence": _convergence(error.report)}
    return told


def _bias(each: Bias) -> dict[str, Any]:
    return {"station": each.station, "bias_m": each.value, "deviation_m": each.deviation}


def _place(each: Place) -> dict[str, Any]:
    velocity = None if each.velocity is None else each.velocity.tolist()
    return {"position_m": each.position.tolist(), "velocity_m_s": velocity, "cost": each.cost}


def _convergence(each: Convergence) -> dict[str, Any]:
    """JSON has no infinity, as of the last step where there was none."""
    return {
        name: None if isinstance(value, float) and not math.isfinite(value) else value
        for name, value in asdict(each).items()
    }
