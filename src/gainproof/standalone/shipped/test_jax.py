"""The kernels for JAX: values as proved, derivatives by kernels, and what is refused."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from gainproof.standalone.shipped._package import CASES, KERNELS, VALUES, function, imported
from gainproof.standalone.shipped.test_values import broken

jax = pytest.importorskip("jax")
ORDINARY = {"float64": (1e-100, 1e100), "float32": (1e-9, 1e9)}
"""Sizes of inputs. XLA takes subnormal numbers for 0: where one comes on the way, next to the ends
of a domain, nothing is promised.
"""


@pytest.fixture(autouse=True)
def _double() -> Iterator[None]:
    before = jax.config.jax_enable_x64
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", before)


def kernel_of(module: str, kernel: str) -> Any:
    return getattr(imported(f"..jax.{module}"), kernel)


def ordinary(module: str, kernel: str, form: str) -> list[dict[str, Any]]:
    """Points of inputs of ordinary sizes, without outputs whose values are next to subnormal."""
    low, high = ORDINARY[form]
    least = float(np.finfo(form).tiny / np.finfo(form).eps)
    points = []
    for point in VALUES[module][kernel]["points"][form]:
        if all(x == 0 or low <= abs(x) <= high for x in point["at"]):
            sizes = {**point["values"], **point.get("scales", {})}
            kept = {n: v for n, v in point["values"].items() if abs(float(sizes[n])) >= least}
            points.append({**point, "values": kept})
    return points


@pytest.mark.parametrize(("module", "kernel", "form"), CASES)
def test_values_are_as_proved(module: str, kernel: str, form: str) -> None:
    described, points = VALUES[module][kernel], ordinary(module, kernel, form)
    columns = [np.array(column, form) for column in zip(*(p["at"] for p in points), strict=True)]
    if not points:
        pytest.skip("its domain has no numbers of ordinary size")
    found = [np.asarray(y) for y in jax.jit(kernel_of(module, kernel))(*columns)]
    assert all(y.dtype == form for y in found)
    for place, point in enumerate(points):
        assert not broken(described, form, point, [y[place] for y in found]), point["at"]
    together = kernel_of(module, kernel)(*map(jax.numpy.asarray, columns))
    apart = jax.vmap(kernel_of(module, kernel))(*columns)
    for y, one, other in zip(found, together, apart, strict=True):
        np.testing.assert_array_equal(y, one)
        np.testing.assert_array_equal(y, other)


@pytest.mark.parametrize(("module", "kernel"), KERNELS)
def test_derivatives_that_kernels_have_are_theirs(module: str, kernel: str) -> None:
    made = getattr(imported(f"..jax.{module}"), f"_{kernel.upper()}")
    slopes, names = made.slopes(), [domain.name for domain in made.inputs]
    form = next(iter(VALUES[module][kernel]["points"]))
    points = ordinary(module, kernel, form)
    if not slopes or not points:
        pytest.skip("no kernel has its derivatives")
    given = [np.array(column, form) for column in zip(*(p["at"] for p in points), strict=True)]
    for each in slopes:
        moved = tuple(np.full_like(x, n == each.given) for n, x in zip(names, given, strict=True))
        _, rates = jax.jvp(kernel_of(module, kernel), tuple(given), moved)
        wanted = each.sign * getattr(kernel_of(module, each.kernel.name)(*given), each.slope)
        np.testing.assert_array_equal(getattr(rates, each.output), wanted)


@pytest.mark.parametrize(("module", "kernel"), KERNELS)
def test_what_is_outside_of_a_domain_is_refused_or_nan(module: str, kernel: str) -> None:
    (form, points), *_ = VALUES[module][kernel]["points"].items()
    ours = kernel_of(module, kernel)
    # smaller numbers are outside of the domains of this target
    least = np.finfo(form).tiny
    normal = [each["at"] for each in points if all(not x or abs(x) >= least for x in each["at"])]
    given = [np.full((2, 2), x, form) for x in normal[-1]]
    given[-1][1, 0] = np.nan
    with pytest.raises(ValueError, match="at index") as refused:
        function(module, kernel)(*given)
    with pytest.raises(ValueError, match="at index") as ours_refused:
        ours(*given)
    assert str(ours_refused.value) == str(refused.value)
    wanted = np.array([[False, False], [True, False]])
    for y in jax.jit(ours)(*given):
        np.testing.assert_array_equal(np.isnan(y), wanted)
    ones = tuple(np.ones_like(x) for x in given)
    for y in jax.jvp(ours, tuple(given), ones)[1]:
        assert np.isnan(y[1, 0])
    for bad in ([1.0], None, "1", True, np.ones(2, complex), np.ma.array([1.0], mask=True)):
        with pytest.raises(TypeError, match=f"^{kernel}: "):
            ours(*[bad] * len(given))
