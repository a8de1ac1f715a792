"""The forms of the steady state, evaluated with many digits, against the doubling; their reach."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath
import pytest
import sympy as sp

from gainproof.derive.model import ModelError
from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, SECOND, Quantity
from gainproof.derive.vector_measurement import forms, radicands
from gainproof.derive.vector_measurement.context import context
from gainproof.derive.vector_measurement.forms import Basis
from gainproof.derive.vector_measurement.model import measured_model
from gainproof.derive.vector_measurement.process_noise import Noise
from gainproof.verify.oracles import doubling, position_velocity
from gainproof.verify.oracles.multiprecision import fraction

DIGITS = 60
NOISES = {
    "random velocity": (Noise(Fraction(1), Fraction(0)), (("0", "0"), ("0", "1"))),
    "random acceleration": (
        Noise(Fraction(0), Fraction(1, 2)),
        (("1/4", "1/2"), ("1/2", "1")),
    ),
    "continuous white acceleration": (
        Noise(Fraction(1, 3), Fraction(1, 2)),
        (("1/3", "1/2"), ("1/2", "1")),
    ),
}
POINTS = ("1/1000000", "1/50", "1", "30", "4000000")


def evaluated(noise: Noise, index: Any, ratio: Any) -> dict[str, Any]:
    """All entries at numbers with many digits."""
    level_squared = radicands.level_squared(noise, index, ratio)
    level = None if level_squared is None else mpmath.sqrt(level_squared)
    eta = mpmath.sqrt(radicands.eta_squared(noise, index, ratio))
    width = ratio if level is None else level
    delta = mpmath.sqrt(radicands.delta_squared(noise, index, ratio, width, eta))
    x = Basis(index, ratio, level, eta, delta, noise)
    return {**forms.gains(x), **forms.predicted_covariance(x), **forms.updated_covariance(x)}


def real(text: str) -> Any:
    number = Fraction(text)
    return mpmath.mpf(number.numerator) / number.denominator


@pytest.mark.alike
@pytest.mark.parametrize("name", NOISES)
@pytest.mark.parametrize("index", POINTS)
def test_entries_are_those_of_the_doubling(name: str, index: str) -> None:
    noise, matrix = NOISES[name]
    with mpmath.workdps(DIGITS):
        for ratio in POINTS:
            model = position_velocity.model(matrix, Fraction(index), Fraction(ratio))
            wanted = position_velocity.named(doubling.steady_state(model, DIGITS).state)
            found = evaluated(noise, real(index), real(ratio))
            assert set(found) == set(wanted)
            for entry, value in found.items():
                exact = fraction(wanted[entry])
                known = mpmath.mpf(exact.numerator) / exact.denominator
                assert abs(value / known - 1) < mpmath.mpf(10) ** (8 - DIGITS), (entry, ratio)


def crossing(noise: Noise, index: Any, value: Any) -> Any:
    """S where P11 takes the value, by bisection of its logarithm; P11 grows with S."""
    low, high = mpmath.log(index) - 20, mpmath.log(index) + 40
    for _ in range(120):
        middle = (low + high) / 2
        grown = evaluated(noise, index, mpmath.exp(middle))["predicted_11"] > value
        low, high = (low, middle) if grown else (middle, high)
    return mpmath.exp(low)


@pytest.mark.parametrize(
    ("index", "start", "end"),
    [
        # what the derivation says of both ends of the step, for small and for large index
        ("1/100000000", ("index", "0.132287565553"), ("root", "2.701031")),
        ("100000000", ("index", "0.195674"), ("index", "1.125503")),
    ],
)
def test_step_lies_where_the_limits_say(
    index: str, start: tuple[str, str], end: tuple[str, str]
) -> None:
    with mpmath.workdps(50):
        noise, _ = NOISES["continuous white acceleration"]
        x = real(index)
        least = x * x / 3 + 2 * x / (x + mpmath.sqrt(x * x + 48))
        most = evaluated(noise, x, mpmath.mpf(10) ** 30)["predicted_11"]
        for value, (scale, wanted) in ((1.1 * least, start), (most / mpmath.mpf("1.1"), end)):
            found = crossing(noise, x, value) / (x if scale == "index" else mpmath.sqrt(x))
            assert abs(found / mpmath.mpf(wanted) - 1) < 1e-3


STRENGTH = Quantity("strength", "s", "deviation", METRE / SECOND**2)
STEP = SAMPLING_INTERVAL.symbol


@pytest.mark.parametrize(
    "shape",
    [
        ((STEP**2, STEP / 4), (STEP / 4, sp.Integer(1))),
        ((STEP**2, STEP / 2), (STEP / 2, sp.Integer(1))),
        ((STEP**2 / 9, sp.Integer(0)), (sp.Integer(0), sp.Integer(1))),
    ],
)
def test_other_process_noises_are_out_of_reach(shape: tuple[tuple[sp.Expr, ...], ...]) -> None:
    noise = STRENGTH.symbol**2 * STEP**2 * sp.ImmutableDenseMatrix(shape)
    with pytest.raises(ModelError, match="Q12/Q22"):
        context(measured_model("other", "Other", sp.ImmutableDenseMatrix(noise), STRENGTH))
