"""What is assumed of NumPy's functions, sampled: at most so many units in the last place."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import flint
import mpmath as mp
import numpy as np
import pytest
from numpy.typing import NDArray

from gainproof.derive.printer.library_functions import NUMPY, ULP, ball, functions_of
from gainproof.derive.printer.program import FUNCTIONS, Program, Step

COUNTS = [2_000, pytest.param(20_000, marks=pytest.mark.thorough)]
DIGITS = {"float64": 53, "float32": 24}
LEAST = {"float64": -1022, "float32": -126}
TRUE: Mapping[str, Callable[..., flint.arb]] = {
    "sin": flint.arb.sin,
    "cos": flint.arb.cos,
    "atan2": flint.arb.atan2,
    "hypot": lambda x, y: (x * x + y * y).sqrt(),
    "exp": flint.arb.exp,
    "expm1": flint.arb.expm1,
    "log1p": flint.arb.log1p,
}
"""Of python-flint, nothing of the module that is judged; a test holds that against mpmath."""


def arguments(name: str, dtype: str, count: int) -> list[NDArray[Any]]:
    """Of all sizes that kernels call them with, both signs, and next to multiples of a quarter."""
    generator = np.random.default_rng(17)
    small = 1e-30 if dtype == "float32" else 1e-150
    signs = generator.choice([-1.0, 1.0], count)
    wide = np.exp(generator.uniform(np.log(small), 0, count))
    if name in ("exp", "expm1"):
        usual = generator.uniform(0, 10, count)
        values = [signs * np.where(generator.random(count) < 0.5, wide, usual)]
    elif name == "log1p":
        values = [np.exp(generator.uniform(np.log(small), -np.log(small), count))]
    elif name in ("sin", "cos"):
        near = generator.integers(1, 5, count) * (np.pi / 2)
        near = near * (1 + generator.integers(-4, 5, count) * 2.0 ** -DIGITS[dtype])
        usual = generator.uniform(0, 6.28, count)
        chosen = generator.integers(0, 3, count)
        values = [np.minimum(np.choose(chosen, [wide, usual, near]), 6.2832) * signs]
    else:
        other = np.exp(generator.uniform(np.log(small), -np.log(small), count))
        usual = generator.uniform(-10, 10, count)
        values = [np.where(generator.random(count) < 0.5, other * signs, usual)]
        values.append(generator.permutation(values[0]))
    return [value.astype(dtype) for value in values]


@pytest.mark.parametrize("dtype", list(DIGITS))
@pytest.mark.parametrize("name", FUNCTIONS)
@pytest.mark.parametrize("count", COUNTS)
def test_functions_err_by_no_more(name: str, dtype: str, count: int) -> None:
    """Along arrays, where loops of vectors work, and of single numbers, where they do not."""
    given = arguments(name, dtype, count)
    function = getattr(np, NUMPY[name])
    found = function(*given)
    assert found.dtype == dtype
    worst = 0.0
    for at in range(count):
        place = [float(row[at]) for row in given]
        worst = max(worst, units(name, place, float(found[at]), dtype))
    for at in range(0, count, 20):
        place = [float(row[at]) for row in given]
        alone = float(function(*(row[at] for row in given)))
        worst = max(worst, units(name, place, alone, dtype))
    assert 0.3 < worst <= ULP, worst


def units(name: str, place: list[float], value: float, dtype: str) -> float:
    """The error in units in the last place of the true value, in a format's numbers."""
    with flint.ctx.workprec(1200 if name in ("hypot", "atan2") else 400):
        exact = TRUE[name](*map(flint.arb, place))
        if exact == 0:
            assert value == 0
            return 0.0
        exponent = max(int(np.floor(np.log2(abs(float(exact.mid()))))), LEAST[dtype])
        unit = flint.arb(2) ** (exponent + 1 - DIGITS[dtype])
        return float((abs(value - exact) / unit).upper())


@pytest.mark.parametrize("name", FUNCTIONS)
def test_both_truths_are_those_of_mpmath(name: str) -> None:
    """At 50 digits and in all quadrants: that of this test, and the printer's by which it bounds.

    mpmath shares no code with python-flint.
    """
    given = arguments(name, "float64", 200)
    for place in zip(*(row.tolist() for row in given), strict=True):
        with mp.workdps(50), flint.ctx.workprec(1200 if name in ("hypot", "atan2") else 400):
            true = getattr(mp, name)(*place)
            for found in (
                ball(name, [flint.arb(x) for x in place]),
                TRUE[name](*map(flint.arb, place)),
            ):
                error = mp.mpf(found.mid().str(60, radius=False)) - true
                assert abs(error) <= abs(true) * mp.mpf(10) ** -45, place


def test_names_are_those_of_numpy() -> None:
    assert set(NUMPY) == set(FUNCTIONS)
    assert all(isinstance(getattr(np, name), np.ufunc) for name in NUMPY.values())


def test_functions_that_a_step_does_not_need_are_not_named() -> None:
    steps = (
        Step("input", (), 0, "x"),
        Step("sin", (0,), 1, ""),
        Step("cos", (0,), 2, ""),
        Step("mul", (1, 1), 3, ""),
    )
    used = Program(steps, {"y": 3}, ("x",))
    assert functions_of(used, [3]) == ["sin"]
    assert functions_of(used, [2, 3]) == ["sin", "cos"]
    assert functions_of(used, [0]) == []
