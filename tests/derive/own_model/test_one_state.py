"""A model of one state: every statement proved, every kernel within its bound."""

from __future__ import annotations

import importlib.util
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import mpmath
import pytest
import sympy as sp
from own_models import free_number, own_model

from gainproof.derive.model import ModelError
from gainproof.derive.own_model.choice import derive_own_model
from gainproof.subjects.deriving import plain_subject
from gainproof.subjects.generating import printed
from gainproof.subjects.rechecking import expected_of, recheck

HALF, RHO = sp.Rational(1, 2), sp.Symbol("rho", real=True)
MODELS: Mapping[str, tuple[Any, Any]] = {
    "random walk": (1, 1),
    "fading": (sp.Rational(9, 10), 1),
    "fading, free": (RHO, 1 - RHO**2),
    "turning over": (-HALF, sp.Rational(1, 3)),
    "turning over, not fading": (-1, 2),
    "white": (0, 2),
    "growing": (sp.Rational(5, 4), 3),
    "growing, turning over": (-3, sp.Rational(7, 5)),
}
INDICES = (1e-20, 1e-3, 0.3, 1.0, 2.7, 900.0, 1e20)


def expected(
    transition: sp.Rational, noise: sp.Rational, index: float
) -> dict[tuple[str, str], mpmath.mpf]:
    """From the quadratic equation for the predicted variance, in 120 digits."""
    with mpmath.workdps(120):
        f, n = (mpmath.mpf(int(each.p)) / int(each.q) for each in (transition, noise))
        q = mpmath.mpf(index) ** 2 * n
        g = q + f**2 - 1
        root = mpmath.sqrt(g**2 + 4 * q)
        predicted = (g + root) / 2
        rise = index * n * (1 + (g + 2) / root)  # by the index
        gain = predicted / (1 + predicted)
        return {
            ("gains", "alpha"): gain,
            ("predicted_covariance", "predicted_11"): predicted,
            ("updated_covariance", "updated_11"): gain,
            ("gain_derivatives", "alpha"): rise / (1 + predicted) ** 2,
        }


@pytest.mark.alike
@pytest.mark.parametrize("name", MODELS)
def test_a_level(name: str, tmp_path: Path) -> None:
    f, n = MODELS[name]
    parameters = (free_number("rho", below_one=True),) if RHO in sp.sympify(f).free_symbols else ()
    subject = derive_own_model(own_model([[f]], [[n]], parameters=parameters))
    derived = plain_subject(subject)
    report = recheck(derived.certificate, expected_of(derived))
    assert {entry["status"] for entry in report["statements"]} == {"proved", "definition"}
    for file, text in printed(subject, derived.certificate, {})["files"].items():
        (tmp_path / file).write_text(text, encoding="utf-8")
    spec = importlib.util.spec_from_file_location("trial", tmp_path / "trial.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    numbers = [sp.sympify(entry).subs(RHO, HALF) for entry in (f, n)]
    for index in INDICES:
        inputs = (index, 0.5)[: 1 + len(parameters)]
        for (kernel, output), wanted in expected(numbers[0], numbers[1], index).items():
            found = getattr(getattr(module, kernel)(*inputs), output)
            assert abs(found / wanted - 1) <= 8 * 2.0**-52, (kernel, index)


def test_a_free_number_on_both_sides_of_1_is_named() -> None:
    model = own_model([[RHO]], [[1]], parameters=(free_number("rho"),))
    with pytest.raises(ModelError, match=r"\(rho - 1\)\*\*2 is not shown to be other than 0"):
        derive_own_model(model)
