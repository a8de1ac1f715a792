"""The kernels of converted measurements against sums over the nodes of their noises."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import product
from typing import Any

import flint
import numpy as np
import pytest
from converted_truth import CORRELATED, KERNELS, arguments, correlated, graph_of, terms, truth
from one_of_each import cases
from polar_points import EPSILON, misses, points, promises
from signed_graphs import with_terms

from gainproof.generated import converted_measurements

FUNCTIONS = [getattr(converted_measurements, name) for name in KERNELS]
EACH = pytest.mark.parametrize("kernel", FUNCTIONS, ids=lambda kernel: kernel.__name__)
DTYPES = pytest.mark.parametrize("dtype", list(EPSILON))
EACH_FORMAT = pytest.mark.parametrize(
    ("kernel", "dtype"),
    cases(
        product(FUNCTIONS, EPSILON), lambda case: case[1] == "float64" or case[0] in FUNCTIONS[::3]
    ),
    ids=lambda given_: getattr(given_, "__name__", given_),
)


@pytest.mark.alike
@EACH_FORMAT
@pytest.mark.parametrize("count", [12, pytest.param(400, marks=pytest.mark.thorough)])
def test_errors_are_as_promised(kernel: Callable[..., Any], dtype: str, count: int) -> None:
    given = points(kernel, dtype, count, seed=5)
    name = kernel.__name__
    assert misses(kernel, given, truth(name), terms(name)) == []


@pytest.mark.parametrize("kernel", FUNCTIONS[-2:], ids=lambda kernel: kernel.__name__)
def test_a_promise_that_is_too_good_would_be_noticed(
    kernel: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same measurement with bounds of a hundredth: the errors are there."""
    import polar_points

    better = {
        name: type(each)({k: v / 100 for k, v in each.bound.items()}, each.beside, each.by_terms)
        for name, each in promises(kernel).items()
    }
    monkeypatch.setattr(polar_points, "promises", lambda _: better)
    given = points(kernel, "float64", 20, seed=3)
    assert misses(kernel, given, truth(kernel.__name__), terms(kernel.__name__))


@EACH
def test_thirty_digits(kernel: Callable[..., Any]) -> None:
    """The formulas that are printed, in balls, and the sums: with deviations of up to half a radian
    both agree to 30 digits.
    """
    name = kernel.__name__
    generator = np.random.default_rng(8)
    for _ in range(2):
        usual = {
            "slant_range": generator.uniform(100, 1e5),
            "elevation": generator.uniform(-1.5, 1.5),
            "azimuth": generator.uniform(-3, 3),
            "range_deviation": generator.uniform(1, 100),
            "elevation_deviation": generator.uniform(0.001, 0.5),
            "azimuth_deviation": generator.uniform(0.001, 0.5),
        }
        point = {entry: float(usual[entry]) for entry in arguments(name)}
        found = with_terms(graph_of(name), point)
        true = truth(name)(*point.values())
        with flint.ctx.workprec(400):
            for entry, (value, scale) in found.items():
                assert abs(value - true[entry]) < abs(scale) * flint.arb(10) ** -30, entry


@pytest.mark.parametrize("name", CORRELATED)
@pytest.mark.parametrize("correlation", [0.6, pytest.param(-0.9, marks=pytest.mark.thorough)])
def test_correlated_noises(name: str, correlation: float) -> None:
    """To 30 digits, and the kernel within what it promises."""
    kernel = getattr(converted_measurements, name)
    given = {
        "slant_range": 1e4,
        "azimuth": 2.5,
        "range_deviation": 300.0,
        "azimuth_deviation": 0.25,
    }
    point = given | {"correlation": correlation}
    assert arguments(name) == list(point)
    true = correlated(name)(*point.values())
    found = with_terms(graph_of(name), point)
    with flint.ctx.workprec(400):
        for entry, (value, scale) in found.items():
            assert abs(value - true[entry]) < abs(scale) * flint.arb(10) ** -30, entry
    for dtype in EPSILON:
        numbers = np.array(list(point.values()), dtype)[:, None]
        exact = true if dtype == "float64" else correlated(name)(*map(float, numbers[:, 0]))
        assert misses(kernel, numbers, lambda *_, exact=exact: exact, terms(name)) == []


@pytest.mark.parametrize(("name", "plain"), list(zip(CORRELATED, KERNELS[5::2], strict=True)))
def test_without_correlation_as_without_it(name: str, plain: str) -> None:
    given = (1e4, 2.5, 300.0, 0.25)
    one = getattr(converted_measurements, name)(*given, 0.0)
    two = getattr(converted_measurements, plain)(*given)
    assert np.allclose(one, two[:5], rtol=1e-13)


@EACH_FORMAT
def test_covariances_are_positive_definite(kernel: Callable[..., Any], dtype: str) -> None:
    """Where ranges are not so far that the axes of the ellipse differ by more than the format has
    digits; along and across the line of sight always.
    """
    generator = np.random.default_rng(2)
    usual = {
        "slant_range": generator.uniform(1e3, 1e5, 5_000),
        "elevation": generator.uniform(-1.5, 1.5, 5_000),
        "azimuth": generator.uniform(-3.1, 3.1, 5_000),
        "range_deviation": generator.uniform(10, 100, 5_000),
        "elevation_deviation": generator.uniform(1e-3, 0.1, 5_000),
        "azimuth_deviation": generator.uniform(1e-3, 0.1, 5_000),
    }
    found = kernel(*(usual[name].astype(dtype) for name in arguments(kernel.__name__)))
    size = 2 if hasattr(found, "radial_variance") else 3
    matrices = np.empty((5_000, size, size))
    for i, a in enumerate("xyz"[:size]):
        for j, b in enumerate("xyz"[:size]):
            matrices[:, i, j] = getattr(found, f"covariance_{min(a, b)}{max(a, b)}")
    assert (np.linalg.eigvalsh(matrices) > 0).all()
    if size == 2:
        wide = points(kernel, dtype, 5_000, seed=1)
        least = np.minimum(*kernel(*wide)[-2:])
        assert (least > 0).all() or dtype == "float32"
        assert (least >= 0).all()


def test_as_the_patent_prints_them() -> None:
    """(12) to (14) in plain floats, at the noise of its experiment."""
    r, theta, sr, st = 100e3, 0.7, 50.0, math.radians(1)
    k = math.exp(-(st**2) / 2)
    found = converted_measurements.modified_unbiased_conversion_in_plane(r, theta, sr, st)
    x = (r**2 + sr**2) * (1 + k**4 * math.cos(2 * theta)) / 2 - (k * r * math.cos(theta)) ** 2
    y = (r**2 + sr**2) * (1 - k**4 * math.cos(2 * theta)) / 2 - (k * r * math.sin(theta)) ** 2
    both = (r**2 + sr**2) * k**4 * math.sin(2 * theta) / 2 - (k * r) ** 2 * math.sin(
        theta
    ) * math.cos(theta)
    assert found.covariance_xx == pytest.approx(x, rel=1e-10)
    assert found.covariance_yy == pytest.approx(y, rel=1e-10)
    assert found.covariance_xy == pytest.approx(both, rel=1e-10)


def test_numbers_of_the_derivation() -> None:
    """The limits that its sentences give in numbers."""
    sr, st = 50.0, math.radians(1)
    limit = sr / math.sqrt(1 - 1 / math.cosh(st**2))
    assert limit == pytest.approx(232.13e3, rel=1e-4)
    assert math.sqrt(math.log(2)) == pytest.approx(0.833, abs=5e-4)
    golden = math.sqrt(math.log((1 + math.sqrt(5)) / 2))
    assert golden == pytest.approx(0.694, abs=5e-4)
    modified = converted_measurements.modified_unbiased_conversion_in_plane
    crossing = sr / math.sqrt(math.expm1(st**2))
    near, far = (modified(crossing * share, 0.3, sr, st) for share in (0.999, 1.001))
    assert near.radial_variance > near.cross_variance
    assert far.radial_variance < far.cross_variance
    unbiased = converted_measurements.unbiased_conversion_in_plane
    wide = unbiased([1e3, 1e6, 1e12], 0.3, sr, golden + 1e-3)
    assert np.all(wide.radial_variance > wide.cross_variance)
    narrow = unbiased([1e3, 1e6, 1e12], 0.3, sr, golden - 1e-2)
    assert np.all(narrow.radial_variance < narrow.cross_variance)


@pytest.mark.parametrize("name", [*KERNELS, *CORRELATED])
@DTYPES
def test_never_nan(name: str, dtype: str) -> None:
    kernel = getattr(converted_measurements, name)
    with np.errstate(all="raise"):
        given = points(kernel, dtype, 5_000, seed=11)
        found = kernel(*given)
        assert all(np.isfinite(each).all() for each in found)
        assert (found.covariance_xx >= 0).all() or name in CORRELATED
        assert all(each.dtype == dtype for each in found)


@pytest.mark.parametrize("bad", [0.0, -1.0, math.nan, math.inf])
@pytest.mark.parametrize("argument", ["slant_range", "range_deviation", "azimuth_deviation"])
@EACH
def test_no_deviation_is_zero(kernel: Callable[..., Any], argument: str, bad: float) -> None:
    given = dict.fromkeys(arguments(kernel.__name__), 0.5)
    given[argument] = bad
    with pytest.raises(
        ValueError, match=f"{kernel.__name__}: {argument} must be a number at least"
    ):
        kernel(*given.values())


@EACH
def test_noise_of_more_than_two_radians_is_refused(kernel: Callable[..., Any]) -> None:
    given = dict.fromkeys(arguments(kernel.__name__), 0.5)
    given["azimuth_deviation"] = 2.0000001
    with pytest.raises(ValueError, match="at least 1e-15 and at most 2, in float32 at least 1e-6"):
        kernel(*given.values())
