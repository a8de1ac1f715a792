"""Kernels of the three-state families against a numerical run that knows no formula."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_truth import THREE_STATES
from one_of_each import cases
from printed_kernels import printed_kernels
from samples import samples

from gainproof.verify.oracles import doubling, quantities
from gainproof.verify.oracles.matrices import product
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.state_space import state_space

NAMES = ("gains", "predictor_gains", "predicted_covariance", "updated_covariance")


@pytest.mark.parametrize("family", cases(sorted(THREE_STATES), lambda name: "jerk" in name))
@settings(max_examples=samples(4), deadline=None)
@given(index=st.floats(-40, 40).map(lambda e: 10.0**e))
def test_doubling(family: str, index: float) -> None:
    model = state_space(THREE_STATES[family], index)
    run = doubling.steady_state(model).state
    predictor = product(model.transition, run.gain)
    true = {name: row[0] for name, row in zip(quantities.FILTER, run.gain, strict=True)}
    true |= {name: row[0] for name, row in zip(quantities.PREDICTOR, predictor, strict=True)}
    for kind, rows in (("predicted", run.predicted), ("updated", run.updated)):
        for i, row in enumerate(rows):
            true |= {f"{kind}_{i + 1}{j + 1}": row[j] for j in range(i, 3)}
    for kernel in printed_kernels():
        if kernel.family != family or kernel.name not in NAMES:
            continue
        for output, value in zip(kernel.outputs, kernel.function(index), strict=True):
            known = fraction(true[output])
            allowed = kernel.promises["float64"][output].error("float64") + Fraction(1, 10**30)
            assert abs(Fraction(float(value)) - known) <= allowed * abs(known), output


def test_pair_of_one_filter_has_the_same_gains() -> None:
    first, second = (
        next(k for k in printed_kernels() if (k.family, k.name) == (family, "gains"))
        for family in ("acceleration_increments", "wiener_acceleration")
    )
    for index in (1e-300, 1e-9, 0.3, 7.0, 1e12, 1e300):
        assert first.function(index) == second.function(index)
