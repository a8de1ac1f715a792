"""Models whose numbers were measured, to a few decimals and to many."""

from __future__ import annotations

import copy
import random
from fractions import Fraction
from functools import cache
from itertools import product

import numpy as np
import pytest
import scipy.linalg
import sympy as sp
from graph_kernels import balls
from one_of_each import cases
from own_models import free_number, own_model

from gainproof.derive.algebra.leading_terms import prime_powers
from gainproof.derive.any_two_state import proved_module
from gainproof.derive.own_model.choice import derive_own_model
from gainproof.derive.steady_state.towers import surd
from gainproof.derive.subject import Subject
from gainproof.subjects.derived import Derived
from gainproof.subjects.deriving import plain_subject
from gainproof.subjects.rechecking import expected_of, recheck

Rows = list[list[sp.Rational]]


@pytest.fixture(autouse=True)
def without_bounds(monkeypatch: pytest.MonkeyPatch) -> None:
    """Bounds of kernels take their time."""
    monkeypatch.setattr(proved_module, "prove", lambda *_: None)


def with_decimals(count: int, seed: int) -> Rows:
    """A damped oscillator with so many more decimals."""
    chosen = random.Random(seed)
    start = [["0.94", "0.94"], ["-0.06", "0.91"]]
    digits = ["".join(chosen.choice("123456789") for _ in range(count)) for _ in range(4)]
    return [[sp.Rational(start[i][j] + digits[2 * i + j]) for j in (0, 1)] for i in (0, 1)]


def gains_at_one(subject: Subject) -> list[float]:
    (kernel,) = (each for each in subject.module.kernels if each.name == "gains")
    found = balls(kernel.graph, {"tracking_index": 1})
    return [float(found[name].mid()) for name in ("alpha", "beta")]


@cache
def of_decimals(count: int) -> Derived:
    """Derived once; nobody changes it."""
    return plain_subject(derive_own_model(own_model(with_decimals(count, count), [[0, 0], [0, 1]])))


@pytest.mark.parametrize("count", cases([1, 2, 4, 10], lambda count: count == 4))
def test_models_of_some_decimals_are_proved_and_right(count: int) -> None:
    transition = with_decimals(count, count)
    subject = derive_own_model(own_model(transition, [[0, 0], [0, 1]]))
    derived = plain_subject(subject)
    report = recheck(derived.certificate, expected_of(derived))
    assert report["accepted"], report["reason"]
    f, h = np.array(transition, float), np.array([[1.0, 0.0]])
    p = scipy.linalg.solve_discrete_are(f.T, h.T, np.diag([0.0, 1.0]), [[1.0]])
    # SciPy is good to about nine digits
    assert gains_at_one(subject) == pytest.approx((p[:, 0] / (p[0, 0] + 1)).tolist(), rel=1e-8)


@pytest.mark.parametrize("count", cases([30, 200], lambda count: count == 30))
def test_numbers_beyond_the_checker_are_told_as_too_long(count: int) -> None:
    derived = of_decimals(count)
    report = recheck(derived.certificate, expected_of(derived))
    assert not report["accepted"]
    assert report["given_up"]
    assert {entry["status"] for entry in report["statements"]}.isdisjoint({"rejected"})
    assert "node" not in report["reason"]


def test_what_is_too_long_and_wrong_besides_is_told_as_wrong() -> None:
    derived = of_decimals(30)
    certificate = copy.deepcopy(derived.certificate)
    certificate["statements"][-1]["claim"] = {}
    report = recheck(certificate, expected_of(derived))
    assert {"given up", "rejected"} <= {entry["status"] for entry in report["statements"]}
    assert not report["accepted"]
    assert not report["given_up"]


@pytest.mark.parametrize(
    "number", [1, 2, 12, 97, 32749, 2**70, 3 * (10**30 + 57) ** 2, (10**30 + 57) * (10**40 + 3)]
)
def test_numbers_are_the_product_of_their_powers(number: int) -> None:
    found = prime_powers(number)
    assert sp.prod(base**power for base, power in found.items()) == number
    small = {base: power for base, power in found.items() if base < 1 << 15}
    assert all(sp.isprime(base) for base in small)


def test_the_root_of_a_large_square_is_found() -> None:
    assert prime_powers(5 * (10**30 + 57) ** 2) == {5: 1, 10**30 + 57: 2}


def test_the_root_of_a_number_of_two_large_primes_is_found() -> None:
    large = (10**30 + 57) * (10**40 + 3)
    factor, inside = surd(Fraction(49 * large, 4))
    assert list(inside.values()) == [large]
    assert factor.as_coeff_Mul()[0] == sp.Rational(7, 2)


R = sp.Symbol("r", real=True)


ENTRIES = [1 / R, 2 + 1 / R**2, (1 + R**2) / R**2, 1 / (3 * R) + 1 / R**3]
PLACED = list(product(("transition", "noise"), ENTRIES))
ONE_OF_EACH = (PLACED[1], PLACED[-1])


@pytest.mark.parametrize(("place", "entry"), cases(PLACED, lambda case: case in ONE_OF_EACH))
def test_quotients_by_a_parameter_below_one_are_proved(place: str, entry: sp.Expr) -> None:
    """They are polynomials over the odds of it, which the checker does not find by itself."""
    numbers = (free_number("r", below_one=True),)
    in_transition = place == "transition"
    transition = [[1, entry if in_transition else 1], [0, sp.Rational(1, 2)]]
    noise = [[1 if in_transition else entry, 0], [0, 1]]
    derived = plain_subject(derive_own_model(own_model(transition, noise, parameters=numbers)))
    report = recheck(derived.certificate, expected_of(derived))
    assert report["accepted"], report["reason"]
