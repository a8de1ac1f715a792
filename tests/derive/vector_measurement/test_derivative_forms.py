"""Forms of derivatives, evaluated with many digits, against differences of the doubling."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from one_of_each import cases
from position_velocity_slopes import DIGITS, slopes
from samples import samples

from gainproof.derive.vector_measurement import radicands
from gainproof.derive.vector_measurement.derivative_kernels import BY_INDEX, BY_RATIO, DERIVATIVES
from gainproof.derive.vector_measurement.first_derivatives import Rates
from gainproof.derive.vector_measurement.forms import Basis
from gainproof.derive.vector_measurement.process_noise import Noise

NOISES = {
    "random_velocity": Noise(Fraction(1), Fraction(0)),
    "random_acceleration": Noise(Fraction(0), Fraction(1, 2)),
    "continuous_white_acceleration": Noise(Fraction(1, 3), Fraction(1, 2)),
}
CHANGING = {
    ("gain_12", BY_INDEX),
    ("gain_21", BY_INDEX),
    ("updated_12", BY_INDEX),
    ("gain_12", BY_RATIO),
}
FALLING = {("gain_22", BY_RATIO)}


def evaluated(noise: Noise, index: Fraction, ratio: Fraction, kernel: str) -> dict[str, Any]:
    """The forms of one kernel as numbers, or pairs of them."""
    with mpmath.workdps(DIGITS + 40):
        own, other = (mpmath.mpf(x.numerator) / x.denominator for x in (index, ratio))
        square = radicands.level_squared(noise, own, other)
        level = None if square is None else mpmath.sqrt(square)
        eta = mpmath.sqrt(radicands.eta_squared(noise, own, other))
        width = other if level is None else level
        delta = mpmath.sqrt(radicands.delta_squared(noise, own, other, width, eta))
        return dict(DERIVATIVES[kernel](Rates(Basis(own, other, level, eta, delta, noise))))


def exactly(value: Any) -> Fraction:
    """A number of mpmath as a fraction."""
    sign, mantissa, exponent, _ = mpmath.mpf(value)._mpf_
    size = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return -size if sign else size


def wrong_at(name: str, noise: Noise, index: Fraction, ratio: Fraction, kernel: str) -> list[str]:
    """Entries whose form is not the derivative, and forms without the sign that they promise."""
    by = BY_INDEX if kernel.endswith(BY_INDEX) else BY_RATIO
    reference = slopes(name, index, ratio, by.removeprefix("_by_"))
    found = []
    for entry, form in evaluated(noise, index, ratio, kernel).items():
        terms = [exactly(term) for term in (form if isinstance(form, tuple) else (form,))]
        assert ((entry, by) in CHANGING) == (len(terms) == 2)
        sign = -1 if (entry, by) in FALLING else 1
        positive = all(term * sign > 0 for term in terms)
        value = terms[0] - sum(terms[1:])
        near = abs(value - reference[entry]) < sum(map(abs, terms)) / 10**15
        if not (positive and near):
            found.append(entry)
    return found


@pytest.mark.parametrize(
    "name", cases(NOISES, lambda name: name == "continuous_white_acceleration")
)
@settings(max_examples=samples(4), deadline=None)
@given(st.floats(-3, 3), st.floats(-3, 3))
def test_every_form_is_its_derivative(name: str, first: float, second: float) -> None:
    point = Fraction(10.0**first), Fraction(10.0**second)
    for kernel in DERIVATIVES:
        assert not wrong_at(name, NOISES[name], *point, kernel)


def test_another_noise_is_noticed() -> None:
    point = Fraction(2), Fraction(1, 3)
    names = list(NOISES)
    for name, other in zip(names, names[1:] + names[:1], strict=True):
        for kernel in DERIVATIVES:
            assert wrong_at(name, NOISES[other], *point, kernel)


@pytest.mark.parametrize("name", NOISES)
def test_three_entries_have_no_trend_and_all_others_have(name: str) -> None:
    """The forms of all others are positive, by their shape; these take both signs."""
    grid = [Fraction(10) ** k for k in (-3, -1, 0, 1, 3)]
    for kernel in DERIVATIVES:
        by = BY_INDEX if kernel.endswith(BY_INDEX) else BY_RATIO
        signs: dict[str, set[bool]] = {}
        for index in grid:
            for ratio in grid:
                for entry, form in evaluated(NOISES[name], index, ratio, kernel).items():
                    if isinstance(form, tuple):
                        signs.setdefault(entry, set()).add(bool(form[0] > form[1]))
        assert set(signs) == {entry for entry, each in CHANGING if each == by} & set(
            evaluated(NOISES[name], Fraction(1), Fraction(1), kernel)
        )
        assert all(each == {False, True} for each in signs.values())
