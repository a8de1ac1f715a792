"""Cardano's forms of the three-state families are the steady state, where they give a number."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from itertools import product

import flint
import numpy as np
import pytest
import sympy as sp
from catalogue_subjects import subject
from kernel_truth import THREE_STATES, truth_at
from one_of_each import cases

from gainproof.derive.three_state.names import INDEX

KEPT = {("acceleration_increments", 0.5), ("wiener_acceleration", 17.0)}
"""Of the others cubics have all coefficients, and a value of their roots takes seconds."""


@cache
def textbook(family: str) -> Mapping[str, Mapping[str, sp.Expr]]:
    return subject(family.replace("_", "-")).textbook()


@pytest.mark.parametrize(
    ("family", "index"),
    cases(
        product(sorted(THREE_STATES), [1e-3, 0.5, 3.0, 17.0]),
        KEPT.__contains__,
    ),
)
def test_forms_at_forty_digits(family: str, index: float) -> None:
    forms = textbook(family)
    truth = truth_at(family, "tracking_index", index)
    wanted = ("gains", "predictor_gains", "predicted_covariance", "updated_covariance")
    for kernel in (*wanted, "gain_derivatives", "innovation_deviation"):
        for output, form in forms[kernel].items():
            value = sp.N(form.subs(INDEX, sp.Rational(index)), 60)
            name = f"d_{output}" if kernel.endswith("derivatives") else output
            true = truth[name].value
            with flint.ctx.workprec(200):
                off = abs(flint.arb(str(value)) / true - 1)
            assert off < 1e-38, (kernel, output, off)


def test_the_literature_gives_no_number_beyond_18() -> None:
    """There the number under its cube root turns negative."""
    form = textbook("acceleration_increments")["gains"]["alpha"]
    value = sp.lambdify([INDEX], form, "numpy")
    with np.errstate(invalid="ignore"):
        assert np.isfinite(value(np.float64(17.9)))
        assert np.isnan(value(np.float64(18.1)))
