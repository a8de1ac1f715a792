"""What the kernels of range and Doppler should return, by the oracle; and their terms."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import flint

from gainproof.verify.oracles import range_and_rate

Values = dict[str, flint.arb]
PLANE = "_in_plane"
Motions = tuple[Sequence[Any], Sequence[Any], Sequence[Any], Sequence[Any]]


def truth(kernel: str) -> Callable[..., Mapping[str, flint.arb]]:
    """Every output that a kernel may have, from its arguments."""
    axes = axes_of(kernel)
    if is_shift(kernel):
        return _shifted(truth(f"range_doppler{kernel.removeprefix('doppler_shift')}"))

    def found(*given: float) -> Values:
        target, velocity, station, moving = motions(kernel, given)
        with flint.ctx.workprec(range_and_rate.BITS):
            size = range_and_rate.distance(target, station)
            by = _slopes(lambda place: range_and_rate.distance(place, station), target, size)
            values = {"slant_range": size} | _named("range_D_", axes, by)
            if "hessian" in kernel:
                function = partial(_rate, velocity, station, moving)
                if not moves(kernel):
                    function = partial(_range, station)
                return _square(kernel, axes, range_and_rate.curvatures(function, target, size))
            if not moves(kernel):
                return values
            values["range_rate"] = range_and_rate.rate(target, velocity, station, moving)
            by = _slopes(
                lambda place: range_and_rate.rate(place, velocity, station, moving), target, size
            )
            values |= _named("range_rate_D_", axes, by)
            by = _slopes(
                lambda fast: range_and_rate.rate(target, fast, station, moving), velocity, 1
            )
            return values | _named("range_rate_D_velocity_", axes, by)

    return found


def terms(kernel: str) -> Callable[..., Mapping[str, flint.arb]]:
    """The terms of those outputs that cancel, taken positive, from the oracle's derivatives."""
    axes = axes_of(kernel)
    if is_shift(kernel):
        return _shifted(terms(f"range_doppler{kernel.removeprefix('doppler_shift')}"))

    def found(*given: float) -> Values:
        target, velocity, station, moving = motions(kernel, given)
        with flint.ctx.workprec(range_and_rate.BITS):
            size = range_and_rate.distance(target, station)
            unit = _slopes(lambda place: range_and_rate.distance(place, station), target, size)
            fast = [abs(flint.arb(a) - flint.arb(b)) for a, b in zip(velocity, moving, strict=True)]
            along = sum((abs(u) * w for u, w in zip(unit, fast, strict=True)), flint.arb(0))
            by = [(w + abs(u) * along) / size for u, w in zip(unit, fast, strict=True)]
            if "hessian" in kernel:
                flat = [[abs(u * v) for v in unit] for u in unit]
                for i in range(len(axes)):
                    flat[i][i] = sum((u * u for j, u in enumerate(unit) if j != i), flint.arb(0))
                bent = [
                    [
                        (abs(unit[i]) * by[j] + abs(unit[j]) * by[i] + along / size * p) / size
                        for j, p in enumerate(row)
                    ]
                    for i, row in enumerate(flat)
                ]
                return _square(kernel, axes, bent)
            return {"range_rate": along} | _named("range_rate_D_", axes, by)

    return found if moves(kernel) else lambda *_: {}


def is_shift(kernel: str) -> bool:
    """Whether a kernel gives hertz."""
    return kernel.startswith("doppler_shift")


def _shifted(rates: Callable[..., Mapping[str, flint.arb]]) -> Callable[..., Values]:
    """Range rates as shifts of the carrier, which is the last argument."""

    def found(*given: float) -> Values:
        *motion, carrier = given
        with flint.ctx.workprec(range_and_rate.BITS):
            waves = -flint.arb(carrier) / 299792458
            return {
                name.replace("range_rate", "doppler_shift"): value * waves
                for name, value in rates(*motion).items()
                if name.startswith("range_rate")
            }

    return found


def moves(kernel: str) -> bool:
    """Whether a kernel takes velocities."""
    return kernel.removesuffix(PLANE) not in ("slant_range", "range_jacobian", "range_hessian")


def axes_of(kernel: str) -> str:
    """The coordinates of a kernel."""
    return "xy" if kernel.endswith(PLANE) else "xyz"


def motions(kernel: str, given: Sequence[float]) -> Motions:
    """Target, its velocity, station, its velocity."""
    count = len(axes_of(kernel))
    parts = [given[start : start + count] for start in range(0, len(given), count)]
    if len(parts) == 2:
        return parts[0], (0.0,) * count, parts[1], (0.0,) * count
    return parts[0], parts[1], parts[2], parts[3]


def _range(station: Sequence[Any], place: Sequence[Any]) -> flint.arb:
    return range_and_rate.distance(place, station)


def _rate(
    velocity: Sequence[Any], station: Sequence[Any], moving: Sequence[Any], place: Sequence[Any]
) -> flint.arb:
    return range_and_rate.rate(place, velocity, station, moving)


def _square(kernel: str, axes: str, rows: Sequence[Sequence[flint.arb]]) -> Values:
    """The upper half of a symmetric matrix by its names."""
    what = "range_rate" if moves(kernel) else "range"
    return {
        f"{what}_D_{a}{axes[j]}": row[j]
        for i, (a, row) in enumerate(zip(axes, rows, strict=True))
        for j in range(i, len(axes))
    }


def _slopes(function: Callable[[Any], flint.arb], at: Sequence[Any], size: Any) -> list[flint.arb]:
    return range_and_rate.slopes(function, at, size)


def _named(start: str, axes: str, values: Sequence[flint.arb]) -> Values:
    return {f"{start}{axis}": value for axis, value in zip(axes, values, strict=True)}
