"""An estimate, or why there is none: as a page for people, as plain data for JSON."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
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
from gainproof.location.geometry_words import listed
from gainproof.location.methods import method_of
from gainproof.location.result import Bias, Convergence, Location, Place
from gainproof.location.selection import Decision, Selection
from gainproof.terminal_text import width as columns

AXES = "xyz"


def page(found: Location) -> str:
    """The whole page."""
    title = f"{found.method}: {method_of(found.method).title}"
    lines = [*textwrap.wrap(title, columns(), subsequent_indent="  "), "", *_place(found)]
    if found.selection is not None:
        lines += ["", *_selection(found.selection)]
    if found.biases:
        lines += ["", *_biases(found)]
    lines += ["", *_convergence(found)]
    for warning in found.warnings:
        lines += textwrap.wrap(f"warning: {warning}", columns(), subsequent_indent="  ")
    return "\n".join(lines)


def _place(found: Location) -> list[str]:
    deviations = np.sqrt(np.diag(found.covariance)).tolist()
    rows = [(AXES[i], value, "m") for i, value in enumerate(found.position.tolist())]
    if found.velocity is not None:
        rows += [(f"v{AXES[i]}", value, "m/s") for i, value in enumerate(found.velocity.tolist())]
    cells = [("", "estimate", "", "1-sigma")]
    for (name, value, unit), deviation in zip(rows, deviations, strict=False):
        cells.append((name, rounded(value, deviation), unit, rounded(deviation, deviation)))
    return _aligned(cells, "<><>")


def _selection(selection: Selection) -> list[str]:
    cells = [("range of", "bias, m", "1-sigma, m", "bias^2/variance", "taken as")]
    cells += [
        (
            each.station,
            rounded(each.bias, each.deviation),
            rounded(each.deviation, each.deviation),
            _statistic(each),
            "clean" if each.clean else "biased",
        )
        for each in selection.decisions
    ]
    words = (
        f"By bias detection. Clean is what does not exceed {selection.threshold:.4g}; a range "
        f"without multipath exceeds it in {_percent(selection.false_alarm)} of all cases."
    )
    return [*_aligned(cells, "<>>>>"), *textwrap.wrap(words, columns(), subsequent_indent="  ")]


def _statistic(each: Decision) -> str:
    return f"{each.statistic:.2f}" if each.statistic < 1e4 else f"{each.statistic:.3g}"


def _biases(found: Location) -> list[str]:
    cells = [("bias of", "estimate, m", "1-sigma, m")]
    cells += [
        (
            "all stations" if each.station == "all" else each.station,
            rounded(each.value, each.deviation),
            rounded(each.deviation, each.deviation),
        )
        for each in found.biases
    ]
    return _aligned(cells, "<>>")


def _convergence(found: Location) -> list[str]:
    told = [f"{_ended(found.convergence)}."]
    if found.selection is not None and found.first is not None:
        told.insert(0, f"Bias detection {_ended(found.first.convergence)}.")
        clean = found.selection.clean
        fixed = f"with {listed(clean)} clean" if clean else "with no range clean"
        told[1] = f"Then, {fixed}, {told[1]}"
    else:
        told[0] = told[0][0].upper() + told[0][1:]
    ratio = found.convergence.ratio
    told.append(f"Scaled rank {found.rank} of {found.rank}, singular values down to {ratio:.2g}.")
    return textwrap.wrap(" ".join(told), columns())


def _ended(told: Convergence) -> str:
    halved = f" ({_counted(told.halvings, 'halving')})" if told.halvings else ""
    freedom = told.degrees_of_freedom
    return (
        f"{told.ended} in {_counted(told.iterations, 'iteration')}{halved} to cost "
        f"{_cost(told.cost)} at {_counted(freedom, 'degree')} of freedom"
    )


def _counted(number: int, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"


def _cost(cost: float) -> str:
    return "0" if cost < 1e-12 else f"{cost:.4g}"


def rounded(value: float, deviation: float) -> str:
    """To two digits of the deviation."""
    if not (deviation > 0 and math.isfinite(deviation)):
        return f"{value:.6g}"
    places = min(max(1 - math.floor(math.log10(deviation)), 0), 12)
    return f"{round(value, places) + 0.0:.{places}f}"


def _percent(share: float) -> str:
    return f"{100 * share:.4g} %"


def _aligned(cells: Sequence[tuple[str, ...]], sides: str) -> list[str]:
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    return [
        "  ".join(
            f"{cell:{side}{width}}" for cell, side, width in zip(row, sides, widths, strict=True)
        ).rstrip()
        for row in cells
    ]


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
        "biases": [_plain_bias(each) for each in found.biases],
        "convergence": _plain_convergence(found.convergence),
        "rank": found.rank,
        "others": [_plain_place(each) for each in found.others],
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
        told |= {"error": "not converged", "convergence": _plain_convergence(error.report)}
    return told


def _plain_bias(each: Bias) -> dict[str, Any]:
    return {"station": each.station, "bias_m": each.value, "deviation_m": each.deviation}


def _plain_place(each: Place) -> dict[str, Any]:
    velocity = None if each.velocity is None else each.velocity.tolist()
    return {"position_m": each.position.tolist(), "velocity_m_s": velocity, "cost": each.cost}


def _plain_convergence(each: Convergence) -> dict[str, Any]:
    """JSON has no infinity, as of the last step where there was none."""
    return {
        name: None if isinstance(value, float) and not math.isfinite(value) else value
        for name, value in asdict(each).items()
    }
