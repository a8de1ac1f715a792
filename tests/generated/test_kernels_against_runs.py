"""The printed kernels against numerical runs that know no formula.

Doubling reaches every index with forty digits, so the kernel's own bound is the tolerance there.
The Kalman recursion and SciPy's solver round in float64 themselves: the tolerance adds what such
a run may be off.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from float_rounding import EPS, allowance
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_truth import STEADY_STATES, truth_of
from one_of_each import cases
from printed_kernels import PrintedKernel, printed_kernels
from samples import samples

from gainproof.verify.oracles import ball, doubling, quantities, recursion, solver
from gainproof.verify.oracles.matrices import Matrix, product
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.state_space import state_space
from gainproof.verify.oracles.true_values import SteadyStateTruth

NAMES = ("gains", "predictor_gains", "predicted_covariance", "updated_covariance")
FAMILIES = cases(sorted(STEADY_STATES), lambda family: family == "continuous_white_acceleration")
# sizes of index at which a run in float64 settles within a few thousand samples
SETTLED = st.floats(math.log2(1e-3), math.log2(300)).map(lambda e: 2.0**e)
ANY = st.floats(-60, 60).map(lambda e: 10.0**e)


def values(family: str, index: float) -> dict[str, tuple[float, PrintedKernel]]:
    """What the kernels give, with the kernel that promised it."""
    found = {}
    for kernel in printed_kernels():
        if kernel.family == family and kernel.name in NAMES:
            for output, value in zip(kernel.outputs, kernel.function(index), strict=True):
                found[output] = float(value), kernel
    return found


def by_name(run: Any, transition: Matrix) -> Mapping[str, Any]:
    """A run's entries under the names of the field."""
    predictor = product(transition, run.gain)
    found = {name: row[0] for name, row in zip(quantities.FILTER, run.gain, strict=False)}
    found |= {name: row[0] for name, row in zip(quantities.PREDICTOR, predictor, strict=False)}
    for kind, rows in (("predicted", run.predicted), ("updated", run.updated)):
        for i, row in enumerate(rows):
            found |= {f"{kind}_{i + 1}{j + 1}": row[j] for j in range(i, len(row))}
    return found


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(3), deadline=None)
@given(index=ANY)
def test_doubling(family: str, index: float) -> None:
    model = state_space(STEADY_STATES[family], index)
    run = by_name(doubling.steady_state(model).state, model.transition)
    for output, (value, kernel) in values(family, index).items():
        true = fraction(run[output])
        # 1e-39 is what the doubling itself may be off
        allowed = kernel.promises["float64"][output].error("float64") + Fraction(1, 10**39)
        assert abs(Fraction(value) - true) <= allowed * abs(true), output


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(3), deadline=None)
@given(index=SETTLED)
def test_kalman_recursion_run_to_convergence(family: str, index: float) -> None:
    model = state_space(STEADY_STATES[family], index)
    compare(family, index, recursion.run_float(model).state)


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(3), deadline=None)
@given(index=st.floats(-4, 3).map(lambda e: 2.0**e))
def test_kalman_recursion_in_multiprecision(family: str, index: float) -> None:
    model = state_space(STEADY_STATES[family], index)
    run = by_name(recursion.run_multiprecision(model, 25).state, model.transition)
    for output, (value, kernel) in values(family, index).items():
        true = fraction(run[output])
        allowed = kernel.promises["float64"][output].error("float64") + Fraction(1, 10**23)
        assert abs(Fraction(value) - true) <= allowed * abs(true), output


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=samples(3), deadline=None)
@given(index=SETTLED)
def test_polished_riccati_solver(family: str, index: float) -> None:
    model = state_space(STEADY_STATES[family], index)
    compare(family, index, solver.steady_state(model).state)


def compare(family: str, index: float, run: Any) -> None:
    truth = truth_of(family)
    assert isinstance(truth, SteadyStateTruth)
    model = state_space(STEADY_STATES[family], index)
    allowed = allowance(model, ball.enclose(truth.spectrum, index))
    reference = by_name(run, model.transition)
    for output, (value, kernel) in values(family, index).items():
        kind = output.split("_")[0]
        # the predictor gain sums two filter gains
        room = allowed[kind] if kind in allowed else 2 * allowed["gain"]
        own = float(kernel.promises["float64"][output].bound) * EPS * abs(value)
        assert abs(value - float(reference[output])) <= room + own, output


def test_another_familys_kernel_is_refuted_by_every_run() -> None:
    model = state_space(STEADY_STATES["random_acceleration"], 1.0)
    wrong = values("continuous_white_acceleration", 1.0)
    runs = (
        doubling.steady_state(model).state,
        recursion.run_float(model).state,
        recursion.run_multiprecision(model, 20).state,
        solver.steady_state(model).state,
    )
    for run in runs:
        for output, reference in by_name(run, model.transition).items():
            assert not np.isclose(wrong[output][0], float(reference), rtol=1e-6), output
