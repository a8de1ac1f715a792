"""The kernels of polar coordinates against turns and differences at many digits."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from itertools import product
from typing import Any

import flint
import numpy as np
import pytest
from one_of_each import cases
from polar_points import EPSILON, misses, points, promises, signature
from polar_truth import terms, truth

from gainproof.generated import polar_coordinates
from gainproof.verify.oracles import polar_enclosure

KERNELS = [getattr(polar_coordinates, n) for n in polar_coordinates.__all__ if n[0].islower()]
EACH = pytest.mark.parametrize("kernel", KERNELS, ids=lambda kernel: kernel.__name__)
DTYPES = pytest.mark.parametrize("dtype", list(EPSILON))
EACH_FORMAT = pytest.mark.parametrize(
    ("kernel", "dtype"),
    cases(product(KERNELS, EPSILON), lambda case: case[1] == "float64" or case[0] in KERNELS[::3]),
    ids=lambda given_: getattr(given_, "__name__", given_),
)


@pytest.mark.alike
@EACH_FORMAT
@pytest.mark.parametrize("count", [80, pytest.param(1_000, marks=pytest.mark.thorough)])
def test_errors_are_as_promised(kernel: Callable[..., Any], dtype: str, count: int) -> None:
    given = points(kernel, dtype, count, seed=7)
    if kernel.__name__.startswith("to_polar"):
        given = given[:, (given[0] != 0) | (given[1] != 0)]  # off the axis
    assert given.shape[1] > count / 3
    name = kernel.__name__
    assert misses(kernel, given, truth(name), terms(name)) == []


@pytest.mark.alike
@EACH
def test_a_promise_that_is_too_good_would_be_noticed(
    kernel: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same measurement with bounds of a hundredth: the errors are there."""
    import polar_points

    said = promises(kernel)
    better = {
        name: type(each)({k: v / 100 for k, v in each.bound.items()}, each.beside, each.by_terms)
        for name, each in said.items()
    }
    monkeypatch.setattr(polar_points, "promises", lambda _: better)
    given = points(kernel, "float64", 60, seed=3)
    if kernel.__name__.startswith("to_polar"):
        given = given[:, (given[0] != 0) | (given[1] != 0)]
    assert misses(kernel, given, truth(kernel.__name__), terms(kernel.__name__))


@pytest.mark.parametrize(
    ("place", "distance", "level"),
    [((3, 4, 12), 13, 5), ((-8, 9, 12), 17, None), ((20, -21, 0), 29, 29), ((-3, -4, -12), 13, 5)],
)
def test_whole_distances_are_exact(
    place: tuple[int, int, int], distance: int, level: int | None
) -> None:
    found = polar_coordinates.to_polar(*place)
    assert found.slant_range == distance
    back = polar_coordinates.to_cartesian(*found)
    assert list(back) == pytest.approx(place, rel=0, abs=distance * 1e-14)
    slopes = polar_coordinates.polar_derivatives(*place)
    assert slopes.slant_range_D_x == pytest.approx(float(Fraction(place[0], distance)), rel=1e-15)
    if level is not None:
        x, y, z = map(Fraction, place)
        exact = -x * z / (level * distance**2), y / level**2
        assert slopes.elevation_D_x == pytest.approx(float(exact[0]), rel=1e-15)
        assert slopes.bearing_D_x == pytest.approx(float(exact[1]), rel=1e-15)


@DTYPES
def test_from_polar_coordinates_and_back(dtype: str) -> None:
    generator = np.random.default_rng(1)
    r = generator.uniform(1, 1e5, 1000).astype(dtype)
    e = generator.uniform(-1.5, 1.5, 1000).astype(dtype)
    b = generator.uniform(-3.1, 3.1, 1000).astype(dtype)
    found = polar_coordinates.to_polar(*polar_coordinates.to_cartesian(r, e, b))
    assert all(np.asarray(each).dtype == dtype for each in found)
    room = 40 * EPSILON[dtype]
    assert np.all(np.abs(found.slant_range - r) <= room * r)
    assert np.all(np.abs(found.elevation - e) <= room)
    assert np.all(np.abs(found.bearing - b) <= room / np.cos(e))


def to_polar(*place: float) -> list[float]:
    return [float(value) for value in polar_coordinates.to_polar(*place)]


def test_directions() -> None:
    """East is a quarter turn to the right of north; the zenith is up."""
    quarter = math.pi / 2
    assert to_polar(5, 0, 0) == [5, 0, quarter]
    assert to_polar(0, 5, 0) == [5, 0, 0]
    assert to_polar(-5, 0, 0) == [5, 0, -quarter]
    assert to_polar(0, -5, 0) == [5, 0, math.pi]
    assert to_polar(0, 0, 5) == [5, quarter, 0]
    assert to_polar(0, 0, -5) == [5, -quarter, 0]
    assert to_polar(0, 0, 0) == [0, 0, 0]
    assert polar_coordinates.to_polar(0.0, -0.0, 3.0).bearing == math.pi


def test_far_and_near_nothing_overflows() -> None:
    for size in (1e-150, 1e150):
        found = polar_coordinates.to_polar(size, size, size)
        assert found.slant_range == pytest.approx(size * math.sqrt(3), rel=1e-15)
    for size in (1e-18, 1e18):
        single = polar_coordinates.to_polar(*[np.float32(size)] * 3)
        assert single.slant_range == pytest.approx(size * math.sqrt(3), rel=1e-6)


def test_a_radial_course_has_a_constant_range_rate() -> None:
    found = polar_coordinates.straight_course_rates(3, 4, 12, 30, 40, 120)
    assert found.range_rate == pytest.approx(130, rel=1e-15)
    assert float(found.range_acceleration) < 1e-25
    passing = polar_coordinates.straight_course_rates(100, 0, 0, 0, 7, 0)
    assert passing.range_acceleration == pytest.approx(0.49, rel=1e-15)
    assert np.all(polar_coordinates.straight_course_rates(3, 4, 12, 0, 0, 0) == np.zeros(6))


def test_no_noise_no_bias() -> None:
    found = polar_coordinates.mean_of_converted(1000, 0.3, 2.0, 0, 0)
    there = polar_coordinates.to_cartesian(1000, 0.3, 2.0)
    assert np.array_equal(np.array(found[:3]), np.array(there))
    assert np.array_equal(np.array(found[3:]), np.zeros(3))


def test_the_oracle_is_what_it_says() -> None:
    """Its quadrature integrates powers of a normal variable; its turns keep lengths."""
    with flint.ctx.workprec(polar_enclosure.BITS):
        for power, exact in ((0, 1), (2, 1), (4, 3), (6, 15), (8, 105), (10, 945)):
            found = sum((w * x**power for x, w in polar_enclosure.nodes(40)), flint.arb(0))
            assert abs(found - exact) < 1e-100
        x, y, z = polar_enclosure.place(2.0, 0.7, -2.5)
        assert abs(x * x + y * y + z * z - 4) < 1e-100
    assert x < 0
    assert y < 0
    assert z > 0


def test_outside_the_domain() -> None:
    for bad in (math.nan, math.inf, 0.0, -1.0, 1e-21, 1e61):
        with pytest.raises(ValueError, match="slant_range must be a number at least 1e-20 and"):
            polar_coordinates.to_cartesian(bad, 0, 0)
    for bad in (math.nan, math.inf, 1.6, -1.6, 1e-21, -1e-300):
        message = r"elevation must be 0 or of magnitude 1e-20 to 1\.5707963267948966, in float32"
        with pytest.raises(ValueError, match=message) as error:
            polar_coordinates.to_cartesian(1.0, bad, 0)
        assert str(bad) in str(error.value), "the message says what came, with its sign"
    with pytest.raises(ValueError, match=r"got -7\.0 at index 2$"):
        polar_coordinates.to_cartesian(1.0, 0.1, [0.0, -6.0, -7.0])
    with pytest.raises(ValueError, match=r"got 1\.570796\d* at index 1$"):
        polar_coordinates.to_cartesian(*np.array([[1, 1], [0, np.pi / 2], [0, 0]], np.float32))


@pytest.mark.parametrize(
    "kernel", [polar_coordinates.polar_derivatives, polar_coordinates.straight_course_rates]
)
def test_on_the_vertical_axis_nothing_is_said(kernel: Callable[..., Any]) -> None:
    count = len(signature(kernel).inputs)
    given = np.ones((count, 2, 3))
    given[:2, 1, 2] = 0, 1e-21 * 0
    out = tuple(np.full((2, 3), -7.0) for _ in signature(kernel).outputs)
    message = (
        r"distance from the vertical axis must be at least 1e-20, in float32 1e-3, got 0\.0 at"
    )
    with pytest.raises(ValueError, match=message + r" index \(1, 2\)$"):
        kernel(*given, out=out)
    assert all((each == -7).all() for each in out), "nothing is touched before"
    with pytest.raises(ValueError, match=message + r" index \(1, 2\)$"):
        kernel(*given)
    with pytest.raises(ValueError, match=message.removesuffix(" at") + "$"):
        kernel(*given[:, 1, 2])
    near = np.ones(count, np.float32)
    near[:2] = 1e-4
    with pytest.raises(ValueError, match=r"in float32 1e-3, got 0\.00014"):
        kernel(*near)


def test_the_origin_of_the_plane() -> None:
    with pytest.raises(ValueError, match=r"distance from the origin .* got 0\.0"):
        polar_coordinates.polar_derivatives_in_plane(0, 0)


@EACH
def test_arrays_broadcast_and_fill_what_is_given(kernel: Callable[..., Any]) -> None:
    given = points(kernel, "float64", 60, seed=5)
    given = given[:, given[0] != 0]
    plain = kernel(*given)
    out = tuple(np.empty(given.shape[1]) for _ in plain)
    assert all(a is b for a, b in zip(kernel(*given, out=out), out, strict=True))
    assert all(np.array_equal(a, b) for a, b in zip(out, plain, strict=True))
    again = kernel(*given[:, :, None])
    assert again[0].shape == (given.shape[1], 1)
    assert np.array_equal(again[-1][:, 0], plain[-1])
    first = kernel(*given[:-1, :1], given[-1])
    assert all(each.shape == plain[0].shape for each in first)
    assert [each[0] for each in first] == [each[0] for each in plain]
    number = kernel(*(float(value) for value in given[:, 0]))
    assert number == tuple(each[0] for each in plain)
    same = given.copy()
    kernel(*same, out=(same[0], *out[1:]))  # an input is overwritten, and is read before
    assert np.array_equal(same[0], plain[0])


@EACH_FORMAT
def test_never_nan(kernel: Callable[..., Any], dtype: str) -> None:
    with np.errstate(all="raise"):
        given = points(kernel, dtype, 20_000, seed=11)
        assert all(np.isfinite(each).all() for each in kernel(*given))
