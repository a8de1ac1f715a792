"""The kernels of range and Doppler against differences of distances at many digits."""

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
from polar_points import EPSILON, allowed, misses, points, promises, signature
from sight_pair_truth import is_pair, pair_terms, pair_truth
from sight_truth import is_shift, motions, moves, terms, truth

from gainproof.generated import range_doppler
from gainproof.verify.oracles import range_and_rate

KERNELS = [getattr(range_doppler, n) for n in range_doppler.__all__ if n[0].islower()]
EACH = pytest.mark.parametrize("kernel", KERNELS, ids=lambda kernel: kernel.__name__)
DTYPES = pytest.mark.parametrize("dtype", list(EPSILON))
EACH_FORMAT = pytest.mark.parametrize(
    ("kernel", "dtype"),
    cases(product(KERNELS, EPSILON), lambda case: case[1] == "float64" or case[0] in KERNELS[::3]),
    ids=lambda given_: getattr(given_, "__name__", given_),
)
SIZES = (1e-3, 1.0, 1e3, 1e6, 1e9)


def true(kernel: Callable[..., Any]) -> Callable[..., Any]:
    name = kernel.__name__
    return pair_truth(name) if is_pair(name) else truth(name)


def sizes(kernel: Callable[..., Any]) -> Callable[..., Any]:
    name = kernel.__name__
    return pair_terms(name) if is_pair(name) else terms(name)


@pytest.mark.alike
@EACH_FORMAT
@pytest.mark.parametrize("count", [40, pytest.param(600, marks=pytest.mark.thorough)])
def test_errors_are_as_promised(kernel: Callable[..., Any], dtype: str, count: int) -> None:
    given = points(kernel, dtype, count, seed=7)
    assert given.shape[1] > count / 3
    assert misses(kernel, given, true(kernel), sizes(kernel)) == []


def sights(kernel: Callable[..., Any], dtype: str, each: int, seed: int) -> Any:
    """Ranges from 1e-3 to 1e9 m, a third of the courses nearly radial, one in four across."""
    generator = np.random.default_rng(seed)
    columns = []
    name = kernel.__name__
    axes = 2 if kernel.__name__.endswith("_in_plane") else 3
    for size in SIZES:
        for turn in range(each):
            place = generator.normal(0, 1, axes) * size
            fast = generator.normal(0, 300, axes)
            if turn % 3 == 0:
                fast = place / size * 300 + generator.normal(0, 1e-5, axes)
            elif turn % 4 == 1:
                fast = fast - place * (fast @ place) / (place @ place)
            base = generator.normal(0, 1, axes) * size * generator.choice([0, 1, 100])
            parts = [base + place, fast, base, generator.normal(0, 1, axes) * (turn % 2)]
            if is_pair(name):
                # two stations next to each other, and far apart
                aside = generator.normal(0, 1, axes) * size * generator.choice([1e-4, 0.1, 10])
                parts += [base + aside, generator.normal(0, 1, axes) * (turn % 2)]
            if is_shift(name):
                parts.append(np.array([9.4e9]))
            columns.append(np.concatenate(parts if moves(name) else parts[::2]))
    return np.array([c for c in columns if np.isfinite(c).all()], dtype).T


@pytest.mark.alike
@EACH_FORMAT
def test_from_a_millimetre_to_a_million_kilometres(kernel: Callable[..., Any], dtype: str) -> None:
    given = sights(kernel, dtype, 8, seed=2)
    if is_pair(kernel.__name__) and dtype == "float32":
        # places up to 1e10 m, and ranges from a metre on
        given = allowed(kernel, given[:, np.abs(given).max(0) < 1e10])
    assert misses(kernel, given, true(kernel), sizes(kernel)) == []


@pytest.mark.alike
@EACH
def test_a_promise_that_is_too_good_would_be_noticed(
    kernel: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same measurement with bounds of a fifteenth: the errors are there."""
    import polar_points

    said = promises(kernel)
    better = {
        name: type(each)({k: v / 15 for k, v in each.bound.items()}, each.beside, each.by_terms)
        for name, each in said.items()
    }
    monkeypatch.setattr(polar_points, "promises", lambda _: better)
    given = sights(kernel, "float64", 12, seed=3)
    assert misses(kernel, given, true(kernel), sizes(kernel))


def test_terms_of_the_rate_are_small() -> None:
    """What the docstring says of them: at most |w|, and twice |w|/f."""
    kernel = range_doppler.range_doppler
    given = sights(kernel, "float64", 10, seed=4)
    for at in range(given.shape[1]):
        point = [float(value) for value in given[:, at]]
        target, velocity, station, moving = motions("range_doppler", point)
        speed = math.dist(velocity, moving)
        found = terms("range_doppler")(*point)
        apart = math.dist(target, station)
        assert float(found["range_rate"].mid()) <= speed * (1 + 1e-12)
        for axis in "xyz":
            size = float(found[f"range_rate_D_{axis}"].mid())
            assert size <= 2 * speed / apart * (1 + 1e-12)


@pytest.mark.parametrize(
    ("place", "distance"), [((3, 4, 12), 13), ((-8, 9, 12), 17), ((20, -21, 0), 29)]
)
@DTYPES
def test_whole_distances_are_exact(place: tuple[int, ...], distance: int, dtype: str) -> None:
    """Pythagorean places, in exact fractions; from a station elsewhere that moves too."""
    velocity, station, moving = (30, -70, 11), (1000, -2000, 64), (-6, 5, 8)
    relative = [a - b for a, b in zip(velocity, moving, strict=True)]
    unit = [Fraction(x, distance) for x in place]
    rate = sum((u * w for u, w in zip(unit, relative, strict=True)), Fraction(0))
    turning = [(w - rate * u) / distance for u, w in zip(unit, relative, strict=True)]
    target = [a + b for a, b in zip(place, station, strict=True)]
    numbers = np.array([*target, *velocity, *station, *moving], dtype)
    found = range_doppler.range_doppler(*numbers)
    exact = [Fraction(distance), rate, *unit, *turning]
    assert found.slant_range == distance
    for value, true in zip(found, exact, strict=True):
        assert abs(Fraction(float(value)) - true) <= 20 * EPSILON[dtype] * 100 / distance * 13


def test_second_derivatives_of_a_circle_and_of_a_straight_line() -> None:
    """5 m away along x: across it the range bends as a circle, along it not at all."""
    flat = range_doppler.range_hessian(5, 0, 0, 0, 0, 0)
    assert list(flat) == [0, 0, 0, 0.2, 0, 0.2]
    bent = range_doppler.range_rate_hessian(5, 0, 0, 10, 25, 0, 0, 0, 0, 0, 0, 0)
    assert list(bent) == pytest.approx([0, -1, 0, -0.4, 0, -0.4], rel=1e-15, abs=0)


def test_signs() -> None:
    """A target that goes away has a positive range rate; the station's motion counts against it."""
    away = range_doppler.range_rate_in_plane(5, 0, 2, 0, 0, 0, 0, 0)
    assert away.range_rate == 2
    follows = range_doppler.range_rate_in_plane(5, 0, 2, 0, 0, 0, 3, 0)
    assert follows.range_rate == -1
    passing = range_doppler.range_rate_jacobian_in_plane(5, 0, 0, 2, 0, 0, 0, 0)
    assert passing[:2] == (0, 0.4)


@DTYPES
def test_the_fused_kernel_says_the_same(dtype: str) -> None:
    given = sights(range_doppler.range_doppler, dtype, 20, seed=5)
    places = np.concatenate([given[:3], given[6:9]])
    found = range_doppler.range_doppler(*given)
    apart = (
        *range_doppler.slant_range(*places),
        *range_doppler.range_rate(*given),
        *range_doppler.range_jacobian(*places),
        *range_doppler.range_rate_jacobian(*given)[:3],
    )
    assert all(np.array_equal(a, b) for a, b in zip(found, apart, strict=True))
    assert all(np.asarray(each).dtype == dtype for each in found)


def test_the_source_s_example() -> None:
    """Equations (139) to (143): A_l and A_ld to the last digit that 1/sqrt 2 leaves."""
    x, y = np.array([0.0, 10e3, 0.0, 20e3]), np.array([0.0, 0.0, 10e3, 20e3])
    found = range_doppler.range_doppler_in_plane(10e3, 10e3, 200.0, 0.0, x, y, 0.0, 0.0)
    half = math.sqrt(0.5)
    assert found.range_D_x == pytest.approx([half, 0, 1, -half], rel=1e-15, abs=0)
    assert found.range_D_y == pytest.approx([half, 1, 0, -half], rel=1e-15, abs=0)
    steep = 0.02 * half / 2
    assert found.range_rate_D_x == pytest.approx([steep, 0.02, 0, steep], rel=1e-15, abs=1e-17)
    assert found.range_rate_D_y == pytest.approx([-steep, 0, 0, -steep], rel=1e-15, abs=1e-17)


def test_far_and_near_nothing_overflows_in_single_precision() -> None:
    """The quotient rule forms the range to the fifth power, which ends at 5e7 m in float32."""
    for size in (1e-3, 1e9, 1e12):
        numbers = np.array([size, size, size, 300, -200, 100] + [0] * 6, np.float32)
        found = range_doppler.range_doppler(*numbers)
        assert found.slant_range == pytest.approx(size * math.sqrt(3), rel=1e-6)
        assert all(np.isfinite(each) for each in found)
        assert found.range_rate_D_x == pytest.approx(233.33333 / size / math.sqrt(3), rel=1e-5)


@EACH
def test_on_the_station_nothing_is_said(kernel: Callable[..., Any]) -> None:
    names = [domain.name for domain in signature(kernel).inputs]
    given = np.ones((len(names), 2, 3))
    for row, name in enumerate(names):
        given[row] += "target" in name
    given[:, 1, 2] = 5
    out = tuple(np.full((2, 3), -7.0) for _ in signature(kernel).outputs)
    (first, *_) = signature(kernel).required
    which = "first station" if is_pair(kernel.__name__) else "station"
    message = rf"distance of the target from the {which} must be {first.wanted}, "
    with pytest.raises(ValueError, match=message + r"got 0\.0 at index \(1, 2\)$"):
        kernel(*given, out=out)
    assert all((each == -7).all() for each in out), "nothing is touched before"
    with pytest.raises(ValueError, match=message + r"got 0\.0$"):
        kernel(*given[:, 1, 2])


def test_outside_the_domain() -> None:
    for bad in (math.nan, math.inf, -math.inf, 2e60):
        with pytest.raises(ValueError, match="target_y must be of magnitude at most 1e60, in fl"):
            range_doppler.slant_range(1, bad, 0, 0, 0, 0)
    with pytest.raises(ValueError, match=r"in float32 1e12, got 2e\+12 at index 1$"):
        range_doppler.slant_range_in_plane(*np.array([[1, 2e12], [0, 0], [0, 0], [0, 0]], "f4"))


def test_coordinates_next_to_zero_are_no_error() -> None:
    """Subnormal ones too: the distance alone has to be what it must."""
    for small in (5e-324, 1e-310, 1e-200, 1e-30):
        found = range_doppler.range_doppler(3, small, 4, 0, 5, small, 0, 0, -small, 0, 0, 0)
        assert found.slant_range == 5
        assert found[2:5] == (0.6, small / 5, 0.8)
        assert found.range_rate == pytest.approx(1.8 * small, rel=1e-15, abs=1e-323)
        assert found.range_rate_D_y == 1


@EACH_FORMAT
def test_never_nan(kernel: Callable[..., Any], dtype: str) -> None:
    given = points(kernel, dtype, 20_000, seed=11)
    with np.errstate(all="raise"):
        assert all(np.isfinite(each).all() for each in kernel(*given))


def test_the_oracle_is_what_it_says() -> None:
    """Of a circle of radius f: rates 0, second derivative of the distance across it 1/f."""
    with flint.ctx.workprec(range_and_rate.BITS):
        still = range_and_rate.rate((3, 4), (-4, 3), (0, 0), (0, 0))
        assert abs(still) < 1e-100
        passing = range_and_rate.rate((1, 5), (0, 2), (1, 0), (3, 0))  # a coordinate goes through 0
        assert abs(passing - 2) < 1e-100
        bend = range_and_rate.curvatures(
            lambda place: range_and_rate.distance(place, (0, 0)), (0, 5), 5
        )
        assert abs(bend[0][0] - flint.arb(1) / 5) < 1e-100
        assert abs(bend[1][1]) < 1e-100
