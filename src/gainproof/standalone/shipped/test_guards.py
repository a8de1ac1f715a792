"""What lies outside a kernel's domain is refused, with its place, and nothing is written."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from gainproof.standalone.shipped._package import CASES, FORMATS, KERNELS, VALUES, function


def outside(given: dict[str, Any], form: str) -> list[Any]:
    """Numbers of the format next to the domain of an input, and what is no number."""
    kind = np.dtype(form).type
    low, high = (kind(end) for end in given[form])
    found = [kind("nan"), kind("inf"), kind("-inf")]
    with np.errstate(all="ignore"):
        found.append(np.nextafter(high, kind("inf")))
        below = np.nextafter(low, kind("-inf"))
    if not (given["zero"] and below <= 0):
        found.append(below)
    if not given["signed"]:
        found.append(kind(-high))
    return [*found, *([kind(low + 0.5)] if given["whole"] else [])]


@pytest.mark.parametrize(("module", "kernel", "form"), CASES)
def test_what_is_outside_is_refused_with_its_name_and_place(
    module: str, kernel: str, form: str
) -> None:
    described = VALUES[module][kernel]
    base = [np.dtype(form).type(x) for x in described["points"][form][0]["at"]]
    for place, given in enumerate(described["inputs"]):
        for wrong in outside(given, form):
            at = [*base[:place], wrong, *base[place + 1 :]]
            with pytest.raises(ValueError, match=rf"^{kernel}: {given['name']} must be "):
                function(module, kernel)(*at)
            column = np.array([base[place], base[place], wrong], form)
            out = tuple(np.full(3, 7.0, form) for _ in described["outputs"])
            with pytest.raises(ValueError, match=r"at index 2$"):
                function(module, kernel)(*at[:place], column, *at[place + 1 :], out=out)
            assert all((each == 7.0).all() for each in out)


@pytest.mark.parametrize(("module", "kernel"), KERNELS)
def test_what_is_no_real_number_is_refused(module: str, kernel: str) -> None:
    base = VALUES[module][kernel]["points"][FORMATS[0]][0]["at"]
    for wrong in ("one", 1j, None, np.float16(1.0)):
        with pytest.raises(TypeError, match=rf"^{kernel}: .* must be real numbers"):
            function(module, kernel)(wrong, *base[1:])
    for form in {"float64", "float32"}.difference(FORMATS):
        with pytest.raises(TypeError, match=rf"^{kernel}: only {FORMATS[0]} is here"):
            function(module, kernel)(*map(np.dtype(form).type, base))


@pytest.mark.parametrize(("module", "kernel"), KERNELS)
def test_arrays_that_do_not_fit_are_refused(module: str, kernel: str) -> None:
    described = VALUES[module][kernel]
    form = np.dtype(FORMATS[0])
    other = "float32" if form == "float64" else "float64"
    base = [form.type(x) for x in described["points"][form.name][0]["at"]]
    for shape, kind in (((2,), form), ((), other)):
        out = tuple(np.empty(shape, kind) for _ in described["outputs"])
        with pytest.raises((TypeError, ValueError), match=rf"^{kernel}: out "):
            function(module, kernel)(*base, out=out)
    with pytest.raises(ValueError, match=rf"^{kernel}: out must be a tuple"):
        function(module, kernel)(*base, out=())
