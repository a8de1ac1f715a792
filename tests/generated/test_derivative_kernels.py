"""Derivative kernels against high-precision differences of the doubling, which has no formula."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_truth import STEADY_STATES
from one_of_each import cases
from printed_kernels import PrintedKernel, printed_kernels
from samples import samples

from gainproof.verify.oracles import differences, doubling
from gainproof.verify.oracles.matrices import product
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.state_space import state_space

DIGITS = 60
ENTRIES = {
    "d_alpha": ("gain", 0, 0),
    "d_beta": ("gain", 1, 0),
    "d_position": ("predictor", 0, 0),
    "d_velocity": ("predictor", 1, 0),
    **{
        f"d_{kind}_{i + 1}{j + 1}": (kind, i, j)
        for kind in ("predicted", "updated")
        for i, j in ((0, 0), (0, 1), (1, 1))
    },
}


def slopes(family: str, index: Fraction) -> dict[str, tuple[Fraction, Fraction]]:
    """Each derivative by differences, with its estimated error."""

    def entries(at: Fraction) -> list[Any]:
        model = state_space(STEADY_STATES[family], at)
        state = doubling.steady_state(model, DIGITS).state
        parts = {
            "gain": state.gain,
            "predictor": product(model.transition, state.gain),
            "predicted": state.predicted,
            "updated": state.updated,
        }
        return [parts[kind][i][j] for kind, i, j in ENTRIES.values()]

    found = differences.derivatives(entries, index, levels=5, digits=DIGITS)
    return {
        name: (fraction(slope.value), fraction(slope.error))
        for name, slope in zip(ENTRIES, found, strict=True)
    }


def derivative_kernels(family: str) -> list[PrintedKernel]:
    """The kernels of first derivatives."""
    found = [k for k in printed_kernels() if k.family == family and "derivatives" in k.name]
    return [kernel for kernel in found if "second" not in kernel.name]


@pytest.mark.parametrize(
    "family", cases(sorted(STEADY_STATES), lambda family: family == "continuous_white_acceleration")
)
@settings(max_examples=samples(3), deadline=None)
@given(exponent=st.floats(-20, 20))
def test_derivatives_are_those_of_the_run(family: str, exponent: float) -> None:
    index = 10.0**exponent
    reference = slopes(family, Fraction(index))
    for kernel in derivative_kernels(family):
        for output, value in zip(kernel.outputs, kernel.function(index), strict=True):
            name = kernel.truth_name(output)
            if name not in reference:
                continue  # the gains themselves, in the kernel that gives both
            true, uncertain = reference[name]
            assert uncertain < abs(true) / 10**18, name
            allowed = kernel.promises["float64"][output].error("float64") * abs(true)
            assert abs(Fraction(float(value)) - true) <= allowed + uncertain, name


def test_every_derivative_is_covered_and_a_wrong_one_is_noticed() -> None:
    for family in sorted(STEADY_STATES):
        named = {k.truth_name(o) for k in derivative_kernels(family) for o in k.outputs}
        assert named - {"alpha", "beta"} == set(ENTRIES)
        reference = slopes(family, Fraction(2))
        for kernel in derivative_kernels(family):
            for output, value in zip(kernel.outputs, kernel.function(2.0), strict=True):
                name = kernel.truth_name(output)
                for other, (true, _) in reference.items():
                    equal = {"d_velocity": "d_beta", "d_updated_11": "d_alpha",
                             "d_updated_12": "d_beta"}  # fmt: skip
                    if name in reference and equal.get(other, other) != equal.get(name, name):
                        assert abs(Fraction(float(value)) - true) > abs(true) / 100
