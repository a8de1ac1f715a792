"""The weights that Gappa sums, against roundings made one by one in high precision."""

from __future__ import annotations

from fractions import Fraction
from time import perf_counter
from typing import Any

import mpmath
import pytest

from gainproof.certify import external, gappa, roundings, singly
from gainproof.certify.branches import branches
from gainproof.certify.operations import operations
from gainproof.certify.rounding_bound import weighed_at
from gainproof.certify.subjects import chosen
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.printed_program import plain
from gainproof.derive.printer.program import Program, program
from gainproof.generated import random_acceleration

SECONDS = 120.0


@pytest.fixture(autouse=True)
def _gappa() -> None:
    if not external.found(gappa.PROGRAM):
        pytest.skip("gappa is not installed")


def _program(subject: str, kernel: str, low: Fraction, high: Fraction) -> tuple[Any, Program]:
    """The graph, and the steps that are carried out between the ends."""
    (found,) = chosen([subject])
    graph = found.certificate["programs"][kernel]["graph"]
    ((_, steps),) = branches(plain(program(graph)), (low, high))
    return graph, steps


def _output(steps: Program, output: str, x: Fraction, moved: int | None) -> Any:
    """The output with the result of one operation multiplied by 1 + 1e-30.

    No use is made of shares or derivatives: the steps are carried out twice. A cube root that the
    kernel takes from bits is taken one hundredth too large.
    """
    values: dict[int, Any] = {}
    for number, step in enumerate(steps.steps):
        parts = [values[part] for part in step.operands]
        match step.operation:
            case "input":
                value = mpmath.mpf(x.numerator) / x.denominator
            case "constant":
                assert step.constant is not None
                exact = Fraction(step.constant.nearest(FLOAT64))
                value = mpmath.mpf(exact.numerator) / exact.denominator
            case "mul":
                value = parts[0] * (parts[1] if step.scale is None else step.scale)
            case "div":
                value = parts[0] / parts[1]
            case "add":
                value = parts[0] + parts[1]
            case "sub":
                value = parts[0] - parts[1]
            case "sqrt":
                value = mpmath.sqrt(parts[0])
            case "near_cbrt":
                value = mpmath.cbrt(parts[0]) * mpmath.mpf("1.01")
            case _:
                value = parts[0]
        rounded = step.operation in ("mul", "div", "add", "sub", "sqrt") and step.scale is None
        off = mpmath.mpf(10) ** -30 if moved == number and rounded else mpmath.mpf(0)
        if step.constant is not None and moved == number:  # off by less than a rounding may be
            exact = Fraction(step.constant.nearest(FLOAT64))
            below, _ = step.constant.between()
            off = mpmath.mpf(10) ** -30 * float(abs(exact / below - 1) * 2**53)
        values[number] = value * (1 + off)
    return values[steps.outputs[output]]


@pytest.mark.parametrize(
    ("subject", "kernel", "output", "x"),
    [
        ("random-velocity", "gains", "alpha", "13/10"),
        ("random-velocity", "gains", "beta", "1/1000000"),
        pytest.param(
            "continuous-white-acceleration",
            "gain_derivatives",
            "alpha",
            "7/3",
            marks=pytest.mark.thorough,
        ),
        pytest.param(
            "alpha-beta",
            "random_acceleration_by_gain",
            "random_acceleration_predicted_11",
            "99/100",
            marks=pytest.mark.thorough,
        ),
        ("wiener-acceleration", "gains", "alpha", "13/10"),
        pytest.param(
            "wiener-acceleration",
            "gains",
            "beta",
            "1/100000000000000000000000000000000000000",
            marks=pytest.mark.thorough,
        ),
        pytest.param(
            "random-jerk", "predictor_gains", "velocity", "300", marks=pytest.mark.thorough
        ),
    ],
)
def test_the_sum_of_weights(subject: str, kernel: str, output: str, x: str) -> None:
    at = Fraction(x)
    end = at * (1 + Fraction(1, 10**6))
    graph, steps = _program(subject, kernel, at, end)
    with mpmath.workdps(80):
        usual = _output(steps, output, at, None)
        total = sum(
            abs(_output(steps, output, at, number) / usual - 1) * mpmath.mpf(10) ** 30
            for number in range(len(steps.steps))
        )
    found = weighed_at(graph, output, at, end, SECONDS)
    assert found is not None
    low, high = (float(end) for end in found)
    assert low * (1 - 1e-4) <= float(total) <= high * (1 + 1e-4)
    assert high <= low * (1 + 1e-2)


def test_what_is_assumed_of_roundings_is_proved_and_a_little_less_is_not() -> None:
    stop = perf_counter() + SECONDS
    assert gappa.proves(roundings.MODEL, stop)
    for kept, made in (("1b-53", "4503599627370495b-105"), ("1b-1075", "1b-1076")):
        assert kept in roundings.MODEL
        assert not gappa.proves(roundings.MODEL.replace(kept, made), stop)


def test_a_single_number_where_a_result_is_just_subnormal() -> None:
    """Beta of random acceleration at the least normal index, against its own rational parameter."""
    for place in range(5):
        x = 2.0**-1022 + place * 2.0**-1074
        with mpmath.workdps(1000):
            r = (4 + mpmath.mpf(x) - mpmath.sqrt((4 + mpmath.mpf(x)) ** 2 - 16)) / 4
            exact = 2 * (1 - r) ** 2
            error = abs(mpmath.mpf(float(random_acceleration.gains(x).beta)) / exact - 1) * 2**53
        at = Fraction(x)
        graph, steps = _program("random-acceleration", "gains", at, at)
        found = singly.errors(
            operations(steps.steps, steps.outputs["beta"]), at, at, perf_counter() + SECONDS
        )
        assert found == weighed_at(graph, "beta", at, at, SECONDS)
        assert found is not None
        assert float(found[1]) == pytest.approx(float(error), abs=1e-6)
