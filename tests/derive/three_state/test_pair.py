"""Acceleration increments and the Wiener process acceleration: one filter, two covariances."""

from __future__ import annotations

import sympy as sp
from catalogue_subjects import subject

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.expression import real

FIRST, SECOND = "acceleration-increments", "wiener-acceleration"
ENTRIES = ("11", "12", "13", "22", "23", "33")


def _main(name: str) -> Tower:
    return subject(name).towers["main"]


def test_gains_and_innovation_are_the_same_elements() -> None:
    for name in ("alpha", "beta", "gamma", "innovation_deviation", "tracking_index"):
        first, second = (_main(family).elements[name] for family in (FIRST, SECOND))
        assert (first.num, first.den) == (second.num, second.den), name


def test_covariances_differ_at_33_by_the_squared_index() -> None:
    first, second = _main(FIRST), _main(SECOND)
    for kind in ("predicted", "updated"):
        for entry in ENTRIES:
            name = f"{kind}_{entry}"
            larger = first.expression(first.elements[name])
            smaller = second.expression(second.elements[name])
            index = first.expression(first.elements["tracking_index"])
            wanted = index**2 if entry == "33" else 0
            assert first.is_zero(larger - smaller - wanted), name


def test_the_page_of_the_second_says_so_and_proves_it() -> None:
    ids = {step.id for step in subject(SECOND).derivation.steps}
    assert {"twin-spectrum", "twin-covariance"} <= ids
    assert "twin-spectrum" not in {step.id for step in subject(FIRST).derivation.steps}


def test_poles_of_white_jerk_turn_real_at_a_number_with_a_root() -> None:
    steps = {step.id: step for step in subject("continuous-white-jerk").derivation.steps}
    turning = real("tracking_index") ** 2 - steps["discriminant"].relation.parts["right"]
    known = sp.Rational(4320, 7) * (3 * sp.sqrt(15) - 10)
    assert sp.simplify(turning.subs(real("root_15"), sp.sqrt(15)) - known) == 0
    assert "real-radicals" not in {s.id for s in subject("random-jerk").derivation.steps}


def test_poles_turn_real_at_432() -> None:
    (step,) = (s for s in subject(FIRST).derivation.steps if s.id == "discriminant")
    assert step.relation.parts["right"] == real("tracking_index") ** 2 - 432
