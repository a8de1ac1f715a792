"""What docstrings say of outputs: the gains and covariances of the model as its owner wrote it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
import scipy.linalg
import sympy as sp
from graph_kernels import balls
from one_of_each import cases
from own_models import DEVIATION, SHAKE, T, own_model

from gainproof.derive.any_two_state import proved_module
from gainproof.derive.model import Model
from gainproof.derive.own_model.choice import derive_own_model
from gainproof.derive.quantity import METRE, SECOND, Unit
from gainproof.derive.subject import Subject

VALUES = {"sampling_interval": 0.1, "measurement_deviation": 0.25, "shake": 3.0}
FADING_3 = [[1, "1", "0.45"], [0, 1, "0.9"], [0, 0, "0.8"]]
EXAMPLE = [["0.318", "0.477"], ["0.477", "0.982"]]


@pytest.fixture(autouse=True)
def without_bounds(monkeypatch: pytest.MonkeyPatch) -> None:
    """Bounds of kernels take their time."""
    monkeypatch.setattr(proved_module, "prove", lambda *_: None)


def in_units(transition: Sequence[Any], noise: Sequence[Any], *units: Unit) -> Model:
    """A model with states of these units, its numbers those of the units T = 1, sigma_v = 1."""
    one = sp.diag(*(DEVIATION ** int(unit.metre) * T ** int(unit.second) for unit in units))
    f, q = (sp.Matrix([[sp.Rational(x) for x in row] for row in m]) for m in (transition, noise))
    # the strength is a length, whatever the states are
    strength = SHAKE.symbol**2 / DEVIATION**2
    return own_model(
        transition,
        noise,
        transition=sp.ImmutableDenseMatrix(one * f * one.inv()),
        process_noise=sp.ImmutableDenseMatrix(strength * one * q * one),
        state_units=units,
    )


def number(expression: Any) -> float:
    known = {symbol: VALUES[str(symbol)] for symbol in sp.sympify(expression).free_symbols}
    return float(sp.sympify(expression).subs(known))


def true_values(model: Model) -> dict[str, float]:
    """By SciPy, from the matrices as they are written, in SI units."""
    f, q, h, r = (
        np.array(matrix.applyfunc(number).tolist(), float)
        for matrix in (
            model.transition,
            model.process_noise,
            model.measurement,
            model.measurement_noise,
        )
    )
    before = scipy.linalg.solve_discrete_are(f.T, h.T, q, r)
    gain = before @ h.T / (h @ before @ h.T + r)
    after = before - gain @ h @ before
    names: tuple[str, ...] = ("alpha", "beta", "gamma")
    found: dict[str, float] = dict(zip(names, gain[:, 0].tolist(), strict=False))
    for kind, matrix in (("predicted", before), ("updated", after)):
        for i, j in zip(*np.triu_indices(len(f)), strict=True):
            found[f"{kind}_{i + 1}{j + 1}"] = float(matrix[i, j])
    return found


def said_values(subject: Subject) -> dict[str, float]:
    """Each output of the kernels, freed of the factor or unit that its docstring names."""
    found: dict[str, float] = {}
    for kernel in subject.module.kernels:
        if kernel.name not in ("gains", "predicted_covariance", "updated_covariance"):
            continue
        (given,) = kernel.inputs
        index = number(given.meaning.partition("Lambda^2 = ")[2]) ** 0.5
        values = balls(kernel.graph, {given.name: index})
        for output in kernel.outputs:
            value = float(values[output.name].mid())
            _, times, factor = output.meaning.partition(" times ")
            _, _, unit = output.meaning.partition(" in units of ")
            found[output.name] = value / number(factor) if times else value * number(unit or 1)
    return found


@pytest.mark.parametrize(
    ("transition", "noise", "units"),
    cases(
        [
            ([[1, "0.953"], [0, "0.917"]], EXAMPLE, (METRE, METRE / SECOND)),
            ([[1, "0.953"], [0, "0.917"]], EXAMPLE, (METRE, METRE)),
            ([[1, 1], [0, 1]], [["1/4", "1/2"], ["1/2", 1]], (METRE, METRE * SECOND)),
            ([[1, 1], [0, 1]], [["1/4", "1/2"], ["1/2", 1]], (METRE, SECOND**-2)),
            (FADING_3, np.diag([0, 0, 1]).tolist(), (METRE, METRE / SECOND, METRE / SECOND**2)),
            (FADING_3, np.diag([0, 0, 1]).tolist(), (METRE, METRE, METRE**2 / SECOND)),
        ],
        lambda case: case[2][1] != METRE / SECOND,
    ),
)
def test_docstrings_say_what_outputs_count(
    transition: Sequence[Any], noise: Sequence[Any], units: Sequence[Unit]
) -> None:
    model = in_units(transition, noise, *units)
    wanted = true_values(model)
    found = said_values(derive_own_model(model))
    assert {"beta", "predicted_12", "updated_22"} <= set(found)
    # SciPy is good to about nine digits
    assert found == pytest.approx({name: wanted[name] for name in found}, rel=1e-7)
