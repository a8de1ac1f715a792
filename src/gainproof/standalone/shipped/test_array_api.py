"""The kernels for libraries of the array API standard: values as proved, NumPy's bits and words."""

from __future__ import annotations

import inspect
from typing import Any

import numpy as np
import pytest

from gainproof.standalone.shipped._package import CASES, KERNELS, VALUES, function, imported
from gainproof.standalone.shipped.test_values import broken


def library(name: str) -> Any:
    """NumPy is one of the standard; the other has nothing beyond it."""
    return np if name == "numpy" else pytest.importorskip("array_api_strict")


def kernel_of(module: str, kernel: str) -> Any:
    return getattr(imported(f"..array_api.{module}"), kernel)


@pytest.mark.parametrize("name", ["numpy", "array_api_strict"])
@pytest.mark.parametrize(("module", "kernel", "form"), CASES)
def test_values_are_as_proved(module: str, kernel: str, form: str, name: str) -> None:
    xp, described = library(name), VALUES[module][kernel]
    points = described["points"][form]
    columns = [np.array(column, form) for column in zip(*(p["at"] for p in points), strict=True)]
    found = kernel_of(module, kernel)(*map(xp.asarray, columns))
    assert all(type(y) is type(xp.asarray(columns[0])) for y in found)
    numbers = [np.asarray(y) for y in found]
    assert all(y.dtype == form for y in numbers)
    for place, point in enumerate(points):
        assert not broken(described, form, point, [y[place] for y in numbers]), point["at"]
    compute = getattr(imported(f"..array_api.{module}"), f"_{kernel}")
    if "near_cbrt" not in inspect.getsource(compute):  # NumPy starts from bits
        for y, wanted in zip(numbers, function(module, kernel)(*columns), strict=True):
            np.testing.assert_array_equal(y, wanted)


@pytest.mark.parametrize(("module", "kernel"), KERNELS)
def test_what_is_outside_of_a_domain_is_refused_in_the_same_words(module: str, kernel: str) -> None:
    (form, points), *_ = VALUES[module][kernel]["points"].items()
    first = points[-1]["at"]
    for place in range(len(first)):
        given = [np.full((2, 2), x, form) for x in first]
        given[place][1, 0] = np.nan
        with pytest.raises(ValueError, match="at index"):
            function(module, kernel)(*given)
        try:
            function(module, kernel)(*given)
        except ValueError as error:
            words = str(error)
        with pytest.raises(ValueError, match="at index") as refused:
            kernel_of(module, kernel)(*given)
        assert str(refused.value) == words


@pytest.mark.parametrize(("module", "kernel"), KERNELS)
def test_what_is_no_array_of_one_library_is_refused(module: str, kernel: str) -> None:
    count = len(VALUES[module][kernel]["inputs"])
    masked = np.ma.array([1.0], mask=True)
    for bad in (1.0, [1.0], None, "1", masked, np.ones(2, bool), np.ones(2, complex)):
        with pytest.raises(TypeError, match=f"^{kernel}: "):
            kernel_of(module, kernel)(*[bad] * count)
