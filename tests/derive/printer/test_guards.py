"""The quick looks of the guards admit nothing that a look at each number would refuse."""

from __future__ import annotations

import math
import warnings
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from gainproof.derive.printer.shipped._blocks import BLOCK, Parts, cut
from gainproof.derive.printer.shipped._guards import ROW, admit, doubted
from gainproof.derive.printer.shipped._runtime import LONG
from gainproof.derive.printer.shipped._signature import Domain, Signature
from gainproof.generated import filter_step, range_doppler
from gainproof.generated.position_velocity_random_velocity import closed_loop_poles

HIGHS = (5e-324, 1e-200, 0.5, 1.0, 3.0, 1e4, 1e30, 1e40, 1e153, 1e160, 1.7e308)
SINGLE_HIGHS = (1e-45, 1e-30, 0.5, 1.0, 3.0, 1e4, 1e8, 1e18, 1e20, 3e38)
SIZES = (1, 2, ROW - 1, ROW, ROW + 1, BLOCK + 3)


def admitted(domain: Domain, x: NDArray[Any]) -> bool:
    kernel = Signature("kernel", (domain,), (), 0, lambda *_: None)
    blocks = cut([x], x.shape, x.size)
    try:
        with np.errstate(all="ignore"):
            doubtful = doubted(kernel, blocks)
            admit(kernel, Parts(blocks), blocks.spans, doubtful, [x], x.shape)
    except ValueError:
        return False
    return True


def inside(domain: Domain, x: Any) -> bool:
    """One number, in words: nothing of arrays."""
    low, high = domain.single if type(x) is np.float32 else domain.double
    size = abs(float(x)) if domain.signed else float(x)
    fits = low <= size <= high or (domain.zero and size == 0)
    return fits and (not domain.whole or size == int(size))


def candidates(low: float, high: float, kind: type[Any]) -> list[Any]:
    ends = [kind(0), kind(low), kind(high), kind(1), kind(np.finfo(kind).max)]
    up, down = kind(np.inf), -kind(np.inf)
    beside = [np.nextafter(x, way) for x in ends for way in (up, down)]
    numbers = [*ends, *beside, up, kind(np.nan), kind(2.5)]
    return [*numbers, *(-x for x in numbers)]


@pytest.mark.parametrize("form", ["plain", "signed", "far", "zero", "whole"])
@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_one_number_among_others(form: str, kind: type[Any]) -> None:
    highs = HIGHS if kind is np.float64 else SINGLE_HIGHS
    told: dict[str, Any] = {
        "plain": {},
        "signed": {"signed": True, "zero": True},
        "far": {"signed": True},
        "zero": {"zero": True},
        "whole": {"whole": True},
    }[form]
    for high in map(float, map(kind, highs)):
        lows = [0.0] if form == "signed" else [high / 4, high]
        for low in map(float, map(kind, lows)):
            domain = Domain("x", "", (low, high), (low, high), **told)
            with np.errstate(all="ignore"), warnings.catch_warnings():
                warnings.simplefilter("ignore")  # numbers beyond the ends
                numbers = candidates(low, high, kind)
            for size in SIZES[: 6 if high in (1.0, 1e40, 1e8) else 3]:
                x = np.full(size, high, kind)
                usual = inside(domain, kind(high))
                assert admitted(domain, x) == usual
                for number in numbers:
                    x[size // 2] = number
                    assert admitted(domain, x) == (
                        inside(domain, number) and (usual or size == 1)
                    ), (domain, number, size)


def test_the_first_wrong_element_is_told_wherever_blocks_begin() -> None:
    """Where the first result begins in a line of the cache moves the borders of blocks."""
    x, z = np.ones(2 * BLOCK), np.ones(2 * BLOCK)
    pool = np.empty(2 * BLOCK + 16)
    others = [np.empty_like(x) for _ in closed_loop_poles(1.0, 1.0)[1:]]
    wrong = (BLOCK - 4, BLOCK - 5)
    for first, second in (wrong, wrong[::-1], (BLOCK - 4, BLOCK - 4)):
        for given, place in ((x, first), (z, second)):
            given[:] = 1
            given[place] = np.nan
        name = "tracking_index" if first <= second else "velocity_ratio"
        for shift in range(16):
            out = (pool[shift : shift + x.size], *others)
            for workers in (1, 2):
                with pytest.raises(ValueError, match=rf" {name} must be .* {min(first, second)}$"):
                    closed_loop_poles(x, z, out=out, workers=workers)  # type: ignore[arg-type]


def test_the_first_block_with_a_bad_number_is_told_of() -> None:
    """Whether all is looked at first, in long parts, or block by block."""
    count = (LONG + 2) * BLOCK + 5
    given = {name: np.ones(count) for name in ("position", "observed")}
    given["position"][BLOCK + 7] = np.nan
    given["observed"][BLOCK - 20] = 1e41
    out = tuple(np.full(count, -7.0) for _ in range(2))

    def step(**options: Any) -> None:
        x, z = given["position"], given["observed"]
        filter_step.step_two_states(x, 1.0, 1.0, z, 0.5, 0.1, **options)

    for options in ({}, {"out": out}):
        told = rf"observed must be .* got 1e\+41 at index {BLOCK - 20}$"
        with pytest.raises(ValueError, match=told):
            step(**options)
        given["observed"][BLOCK - 20] = 1.0
        with pytest.raises(ValueError, match=rf"position must be .* got nan at index {BLOCK + 7}$"):
            step(**options)
        given["observed"][BLOCK - 20] = 1e41
    given["position"][BLOCK + 7] = given["observed"][BLOCK - 20] = 1.0
    given["observed"][(LONG + 1) * BLOCK] = -np.inf
    with pytest.raises(
        ValueError, match=rf"observed must be .* got -inf at index {(LONG + 1) * BLOCK}$"
    ):
        step(out=out)
    assert all((y == -7).all() for y in out)


@pytest.mark.parametrize("one", ["station", "target"])
def test_points_that_meet_are_found_among_many(one: str) -> None:
    """Where a first difference is 0 the distance itself is asked for, block by block; one of the
    points is a number and not an array.
    """
    far = LONG * BLOCK + 5 - LONG * BLOCK % 5
    count = (LONG + 1) * BLOCK + 5
    place = np.full((2, count), 5.0)
    place[0, ::5] = 1.0  # along x where the station is, and 4 from it
    out: Any = tuple(np.full(count, -7.0) for _ in range(6))

    def seen() -> Any:
        many, single = (*place, 1.0, 2.0), (1.0, 1.0, 0.0, 0.0)
        points = many + single if one == "station" else single + many
        return range_doppler.range_doppler_in_plane(*points, out=out)

    assert seen().slant_range[[0, far]].tolist() == [4, 4]
    for y in out:
        y[:] = -7
    where = (LONG + 1) * BLOCK
    place[:, where] = 1.0
    with pytest.raises(ValueError, match=rf"distance .* got 0.0 at index {where}$"):
        seen()
    assert all((y == -7).all() for y in out)


def told_place(x: NDArray[Any], station: Any) -> int | None:
    """Of targets along x the place of that which is called too near to a station."""
    zeros = [x.dtype.type(0)] * 5
    points: list[Any] = [x, *zeros, station, *zeros]
    try:
        range_doppler.range_doppler(*points)
    except ValueError as error:
        return int(str(error).rpartition(" at index ")[2])
    return None


@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_the_neighbours_of_a_number_are_refused_where_they_are_too_near(kind: type[Any]) -> None:
    """Of one station its neighbours are told by comparing where these are far enough from it."""
    least = 1e-20 if kind is np.float64 else float(np.float32(1e-6))
    limit = least / float(np.finfo(kind).epsneg)
    exponent = round(math.log2(limit))
    factors = (0, 0.25, 0.5, 0.75, 0.999, 1, 1.0011, 1.5, 2, 3, 4, 1e6)
    stations = [limit * factor for factor in factors]
    stations += [2.0 ** (exponent + step) for step in range(-3, 4)]
    refused = 0
    for station in [kind(sign * each) for each in stations for sign in (1, -1)]:
        for way in (-np.inf, np.inf, float(station)):
            x = np.full(5, 1e12, kind)
            x[3] = np.nextafter(station, kind(way))
            near = abs(Fraction(float(x[3])) - Fraction(float(station))) < Fraction(least)
            assert told_place(x, station) == (3 if near else None), (station, way)
            refused += near
    assert refused > len(stations) * 2, "those at a station, and neighbours"
