"""Every kernel against exact values, within the error that its docstring states."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from gainproof.standalone.shipped._package import CASES, VALUES, function

WRITTEN = Fraction(1, 10**38)
"""What a value of 40 digits may be off, relative to itself."""


def broken(described: dict[str, Any], form: str, point: dict[str, Any], found: Any) -> list[str]:
    """The outputs of a kernel that are further from the exact values than was promised."""
    wrong = []
    for output, came in zip(described["outputs"], found, strict=True):
        name, stated = output["name"], output[form]
        if name not in point["values"]:
            # no error is promised there: a number or infinity, never NaN
            wrong += [f"{name}: {came}"] if math.isnan(came) else []
            continue
        exact = Fraction(point["values"][name])
        scale = abs(Fraction(point["scales"][name] if name in point.get("scales", ()) else exact))
        epsilon = Fraction(float(np.finfo(form).eps))
        allowed = (Fraction(stated["bound"]) * epsilon + WRITTEN) * scale + WRITTEN * abs(exact)
        allowed += Fraction(stated["beside"])
        if not math.isfinite(came) or abs(Fraction(float(came)) - exact) > allowed:
            wrong.append(f"{name}: {came!r} instead of {point['values'][name]}")
    return wrong


@pytest.mark.parametrize(("module", "kernel", "form"), CASES)
def test_values_are_within_the_proved_bound(module: str, kernel: str, form: str) -> None:
    described, kind = VALUES[module][kernel], np.dtype(form).type
    assert described["points"][form]
    for point in described["points"][form]:
        found = function(module, kernel)(*map(kind, point["at"]))
        assert all(came.dtype == kind for came in found)
        assert not broken(described, form, point, found), point["at"]


@pytest.mark.parametrize(("module", "kernel", "form"), CASES)
def test_an_error_of_three_bounds_is_noticed(module: str, kernel: str, form: str) -> None:
    described = VALUES[module][kernel]
    for output in described["outputs"]:
        name = output["name"]
        for point in described["points"][form]:
            exact = Fraction(point["values"].get(name, "0"))
            scale = abs(Fraction(point.get("scales", {}).get(name, exact)))
            off = 3 * Fraction(output[form]["bound"]) * Fraction(float(np.finfo(form).eps)) * scale
            off += 3 * Fraction(output[form]["beside"])
            if off == 0:
                continue
            found = [float("inf")] * len(described["outputs"])
            found[described["outputs"].index(output)] = float(exact + 2 * off)
            assert any(
                text.startswith(f"{name}: ") for text in broken(described, form, point, found)
            )


@pytest.mark.parametrize(("module", "kernel", "form"), CASES)
def test_arrays_hold_what_numbers_give(module: str, kernel: str, form: str) -> None:
    points = VALUES[module][kernel]["points"][form]
    columns = [np.array(column, form) for column in zip(*(p["at"] for p in points), strict=True)]
    together = function(module, kernel)(*columns)
    out = tuple(np.empty(len(points), form) for _ in together)
    filled = function(module, kernel)(*columns, out=out)
    for place, point in enumerate(points):
        alone = function(module, kernel)(*(np.dtype(form).type(x) for x in point["at"]))
        for one, column, given, written in zip(alone, together, filled, out, strict=True):
            # a library's function may round a number and an array differently
            np.testing.assert_allclose(column[place], one, rtol=16 * float(np.finfo(form).eps))
            assert given is written
            np.testing.assert_array_equal(written, column)
