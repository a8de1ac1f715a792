"""Gains with `accurate=True` against a ball round the Riccati solution of the model's matrices."""

from __future__ import annotations

import math
import re
from importlib import import_module
from typing import Any

import flint
import numpy as np
import pytest
from kernel_truth import STEADY_STATES, THREE_STATES, truth_at
from samples import samples

from gainproof.generated import _double_word

LEAST = {"float64": 1e-290, "float32": 1.2e-38}


def gains_of(family: str) -> Any:
    return import_module(f"gainproof.generated.{family}").gains


def worst(family: str, dtype: str, low: float, high: float, count: int) -> float:
    """Largest error of the gains, in units in the last place of what comes."""
    rng = np.random.default_rng(9)
    indices = (10 ** rng.uniform(low, high, count)).astype(dtype)
    found = gains_of(family)(indices, accurate=True)
    most = 0.0
    for place, index in enumerate(indices.tolist()):
        truth = truth_at(family, "tracking_index", index)
        for name, values in found._asdict().items():
            value = float(values[place])
            if value < LEAST[dtype]:
                continue
            unit = math.ulp(value) if dtype == "float64" else float(np.spacing(np.float32(value)))
            with flint.ctx.workprec(500):
                error = abs(truth[name].value - flint.arb(value)) / flint.arb(unit)
            most = max(most, float(error.upper()))
    return most


@pytest.mark.sampled
@pytest.mark.parametrize("family", STEADY_STATES)
def test_half_a_unit_in_the_last_place(family: str) -> None:
    assert worst(family, "float64", -3, 3, samples(60)) <= 0.501
    assert worst(family, "float64", -120, 120, samples(30)) <= 0.501
    assert worst(family, "float32", -37, 38, samples(30)) <= 0.501


@pytest.mark.sampled
@pytest.mark.parametrize("family", THREE_STATES)
def test_half_a_unit_with_a_root_that_is_refined(family: str) -> None:
    assert worst(family, "float64", -3, 3, samples(10)) <= 0.501
    assert worst(family, "float64", -120, 120, samples(6)) <= 0.501
    assert worst(family, "float32", -37, 38, samples(4)) <= 0.501


def test_a_root_that_is_not_refined_is_farther_off(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(_double_word, "refined", lambda _near, image, _slope: image)
    assert worst("random_jerk", "float64", -3, 3, 20) > 0.501


def test_a_refined_root_without_its_slope_is_farther_off(monkeypatch: pytest.MonkeyPatch) -> None:
    true = _double_word.refined

    def refined(near: Any, image: Any, slope: Any) -> Any:
        return true(near, image, (slope[0] / 2, slope[1]))

    monkeypatch.setattr(_double_word, "refined", refined)
    assert worst("random_jerk", "float64", -3, 3, 60) > 0.5005


def test_plain_gains_are_farther_off(monkeypatch: pytest.MonkeyPatch) -> None:
    """The measure sees what a quotient without its second word costs."""

    def short(a: Any, b: Any) -> Any:
        return a[0] / b[0], 0.0

    monkeypatch.setattr(_double_word, "divide", short)
    assert worst("random_velocity", "float64", -3, 3, 40) > 0.501


@pytest.mark.parametrize("family", [*STEADY_STATES, "random_jerk"])
def test_numbers_arrays_types_and_places(family: str) -> None:
    gains = gains_of(family)
    indices = np.array([[1e-3, 0.5, 2.0], [7.0, 2.0**400, 2.0**-400]])
    whole = gains(indices, accurate=True)
    for place in np.ndindex(2, 3):
        assert [x[place] for x in whole] == list(gains(indices[place], accurate=True))
    assert gains(np.float32(2.0), accurate=True).alpha.dtype == np.float32
    assert gains(2, accurate=True) == gains(2.0, accurate=True)
    own, *others = indices.copy(), *(np.empty((2, 3)) for _ in whole[1:])
    gains(own, accurate=True, out=(own, *others))
    for values, wanted in zip((own, *others), whole, strict=True):
        assert (values == wanted).all()
    long = np.full(200_000, 0.3)
    assert (gains(long, accurate=True, workers=2).beta == gains(0.3, accurate=True).beta).all()
    for plain, exact in zip(gains(indices), whole, strict=True):
        assert np.allclose(plain, exact, rtol=7 * 2.0**-52, atol=0)


def test_in_float32_the_float64_gains_are_rounded() -> None:
    """Both are proved: what is rounded again is off by half a unit and its own error, which is the
    stated 2^-26 or less."""
    indices = np.float32(10) ** np.arange(-40, 39, dtype=np.float32)
    for family in (*STEADY_STATES, *THREE_STATES):
        found = gains_of(family)(indices, accurate=True)
        double = gains_of(family)(indices.astype(np.float64))
        text = " ".join(str(gains_of(family).__doc__).split())
        stated = 2.0 ** int(re.findall(r"0\.5 \+ 2\^(-\d+) \(float32\)", text)[0])
        bounds = [float(each) for each in re.findall(r"at most (\S+) \* 2\^-52", text)]
        assert max(bounds) * 2.0**-28 <= stated <= 2.0**-25
        for single, value in zip(found, double, strict=True):
            assert single.dtype == np.float32
            assert (single == value.astype(np.float32)).all()


@pytest.mark.parametrize("index", [0.0, -1.0, 2.0**-401, 2.0**401, math.inf, math.nan])
def test_what_double_words_do_not_hold_is_refused(index: float) -> None:
    with pytest.raises(
        ValueError, match=r"tracking_index must be a number at least 2\^-400 and at"
    ):
        gains_of("random_acceleration")([1.0, index], accurate=True)
