"""Spectral factorisation against numbers from elsewhere: NumPy roots and the literature's noise."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from gainproof.derive.catalogue import CATALOGUE
from gainproof.derive.model import Model, ModelError, ScaledModel
from gainproof.derive.quantity import (
    MEASUREMENT_DEVIATION,
    METRE,
    SAMPLING_INTERVAL,
    SECOND,
    Quantity,
)
from gainproof.derive.steady_state.context import context
from gainproof.derive.steady_state.spectrum import V, factorise

# The numerators of the noise spectra as the field states them, normalised to 1 at v = 0.
NOISE = {
    "random-velocity": sp.Integer(1),
    "random-acceleration": (4 - V) / 4,
    "continuous-white-acceleration": 1 - V / 6,
}
RELATION_AT_ALPHA_ONE = {
    "random-velocity": 1.0,
    "random-acceleration": 2.0,
    "continuous-white-acceleration": 3 - 3**0.5,
}


def _scaled(name: str) -> ScaledModel:
    (entry,) = (entry for entry in CATALOGUE if entry.name == name)
    model = entry.build().model
    assert model is not None
    return model


@pytest.mark.parametrize("name", NOISE)
def test_noise_polynomial(name: str) -> None:
    assert sp.expand(factorise(_scaled(name)).noise - NOISE[name]) == 0


@pytest.mark.parametrize("name", NOISE)
def test_gain_relation_meets_the_line_alpha_one_where_the_index_is_infinite(name: str) -> None:
    relation = factorise(_scaled(name)).relation
    beta = sp.Symbol("beta", real=True)
    polynomial = sp.Poly(relation.subs(sp.Symbol("alpha", real=True), 1), beta)
    roots = np.roots([float(entry) for entry in polynomial.all_coeffs()])
    assert min(roots.real) == pytest.approx(RELATION_AT_ALPHA_ONE[name], abs=1e-12)


SHAKE = Quantity("shake", "w", "deviation of the velocity's change", METRE / SECOND)
SHIFT = Quantity("shift", "s", "deviation of the position's change", METRE)


def _model(noise: list[list[sp.Expr]], units=(METRE, METRE / SECOND)) -> Model:  # type: ignore[no-untyped-def]
    step, deviation = SAMPLING_INTERVAL.symbol, MEASUREMENT_DEVIATION.symbol
    return Model(
        "trial",
        "Trial",
        sp.ImmutableDenseMatrix([[1, step], [0, 1]]),
        sp.ImmutableDenseMatrix(noise),
        sp.ImmutableDenseMatrix([[1, 0]]),
        sp.ImmutableDenseMatrix([[deviation**2]]),
        (SAMPLING_INTERVAL, MEASUREMENT_DEVIATION, SHAKE, SHIFT),
        units,
    )


def test_units_that_do_not_fit_are_refused() -> None:
    with pytest.raises(ModelError, match="the transition should hold numbers"):
        context(_model([[sp.Integer(0)] * 2, [sp.Integer(0), SHIFT.symbol**2]], (METRE, METRE)))


def test_two_noise_strengths_are_refused() -> None:
    with pytest.raises(ModelError, match="one strength times a matrix"):
        context(_model([[SHIFT.symbol**2, sp.Integer(0)], [sp.Integer(0), SHAKE.symbol**2]]))


def test_a_noise_outside_the_method_is_named() -> None:
    noise = SHAKE.symbol**2 * sp.Matrix([[5 * SAMPLING_INTERVAL.symbol**2, 0], [0, 1]])
    with pytest.raises(ModelError, match=r"noise\(4\)/noise\(0\)"):
        context(_model(noise.tolist()))


@pytest.mark.parametrize(
    ("noise", "message"),
    [
        ([[0, 0], [0, -1]], "positive strength"),
        ([[0, 0], [0, 0]], "positive strength"),
        ([[1, 25], [25, 100]], "covariances are wanted"),
    ],
)
def test_what_is_no_covariance_is_refused(noise: list[list[int]], message: str) -> None:
    scale = sp.diag(SAMPLING_INTERVAL.symbol, 1)
    with pytest.raises(ModelError, match=message):
        context(_model((SHAKE.symbol**2 * scale * sp.Matrix(noise) * scale).tolist()))
