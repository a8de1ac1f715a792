"""Bearings and elevations from stations against 250 digits, in both formats.

Derivatives are those that mpmath finds by differences of its own angles, which agree in 120 digits
where one coordinate is that much larger than another.
"""

from __future__ import annotations

import json
import math
import random
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest

import gainproof.generated
from gainproof.generated import bearings_only

LEDGER = Path(gainproof.generated.__file__).parent / "bounds.json"
KERNELS = ("bearing", "bearing_jacobian", "angles", "angles_jacobian")
LEAST = {"float64": (1e-20, 1e60), "float32": (1e-6, 1e12)}


def angle(name: str, *place: Any) -> Any:
    """From the six or four coordinates of target and station."""
    half = len(place) // 2
    x, y, *z = (a - b for a, b in zip(place[:half], place[half:], strict=True))
    return mpmath.atan2(x, y) if name == "bearing" else mpmath.atan2(z[0], mpmath.hypot(x, y))


def true_value(output: str, names: list[str], place: list[Any]) -> Any:
    name, _, by = output.partition("_D_")
    if not by:
        return angle(name, *place)
    at = names.index(by)
    # the size of the step follows the distances, which are the scale of the angle
    half = len(place) // 2
    scale = mpmath.norm([a - b for a, b in zip(place[:half], place[half:], strict=True)])

    def moved(t: Any) -> Any:
        return angle(name, *place[:at], place[at] + scale * t, *place[at + 1 :])

    return mpmath.diff(moved, 0) / scale


def drawn(draw: random.Random, dtype: str, count: int) -> list[float]:
    """Coordinates of all sizes; half of the targets are next to their station."""
    low, high = LEAST[dtype]
    kind = np.dtype(dtype).type
    sizes = [
        math.exp(draw.uniform(math.log(low * 1e3), math.log(high / 2))) for _ in range(2 * count)
    ]
    found = [float(kind(draw.choice([-1, 1]) * size)) for size in sizes]
    if draw.random() < 0.5:
        near = draw.choice([1e-3, 1e-1, 1.0])
        found[:count] = [float(kind(t * (1 + near * draw.uniform(-1, 1)))) for t in found[count:]]
    return found


@pytest.mark.parametrize("dtype", LEAST)
@pytest.mark.parametrize("kernel", KERNELS)
def test_errors_are_within_the_printed_bounds(kernel: str, dtype: str) -> None:
    function = getattr(bearings_only, kernel)
    count = 2 if kernel.startswith("bearing") else 3
    names = [f"target_{axis}" for axis in "xyz"[:count]]
    entry = json.loads(LEDGER.read_text("utf-8"))["modules"]["bearings_only"][kernel]
    stated = entry[dtype]["outputs"]
    draw, kind, epsilon = random.Random(kernel), np.dtype(dtype).type, float(np.finfo(dtype).eps)
    seen = 0
    with mpmath.workdps(250):
        for _ in range(60):
            numbers = drawn(draw, dtype, count)
            try:
                found = function(*map(kind, numbers))
            except ValueError:
                continue
            seen += 1
            place = [mpmath.mpf(t) for t in numbers]
            for output, value in found._asdict().items():
                assert value.dtype == kind
                true = true_value(output, names, place)
                allowed = float(stated[output]["bound"]) * epsilon * abs(true)
                allowed += stated[output].get("beside", 0.0) + mpmath.mpf(10) ** -25 * abs(true)
                assert abs(mpmath.mpf(float(value)) - true) <= allowed, (output, numbers)
    assert seen > 30


def test_values_by_hand() -> None:
    """3 east, 4 north, 12 up: level distance 5, distance 13."""
    place = (103.0, -6.0, 12.0, 100.0, -10.0, 0.0)
    assert bearings_only.angles(*place).bearing == pytest.approx(math.atan2(3, 4), rel=1e-15)
    assert bearings_only.angles(*place).elevation == pytest.approx(math.atan2(12, 5), rel=1e-15)
    wanted = (4 / 25, -3 / 25, -36 / 845, -48 / 845, 5 / 169)
    assert bearings_only.angles_jacobian(*place) == pytest.approx(wanted, rel=1e-15)
    plane = bearings_only.bearing_jacobian(103.0, -6.0, 100.0, -10.0)
    assert plane == pytest.approx(wanted[:2], rel=1e-15)


def test_above_a_station_there_is_no_bearing() -> None:
    with pytest.raises(ValueError, match="level distance of target and station must be at least"):
        bearings_only.angles([1.0, 2.0], [5.0, 5.0], [9.0, 9.0], 2.0, 5.0, 0.0)
