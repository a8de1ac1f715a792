"""Noises, polynomials and graphs of the recursion of three states."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
import sympy as sp

from gainproof.derive.recursion import three_states, triple_kernels
from gainproof.derive.recursion.noise import NoiseError, T
from gainproof.derive.recursion.polynomial import SignError, nested
from gainproof.derive.recursion.triple_noise import through, triple_noises

# entries 12, 23, 13 of V over t, t, t^2; the power of t in g3; g2/(g3 t^2), g1/(g3 t^4)
NUMBERS: dict[str, tuple[Any, ...]] = {
    "acceleration_increments": (0, 0, 0, 0, 0, 0),
    "wiener_acceleration": (0, 1, "1/2", 0, 0, 0),
    "random_jerk": (0, "1/2", "1/6", 2, 0, 0),
    "continuous_white_jerk": ("1/2", "1/2", "1/6", 1, "1/12", "1/720"),
}


def test_numbers_of_the_noises() -> None:
    found = {n.name: (*n.shears, n.power, n.second, n.first) for n in triple_noises()}
    wanted = {name: tuple(sp.Rational(x) for x in each) for name, each in NUMBERS.items()}
    assert found == wanted


@pytest.mark.parametrize("shape", [[T, 1, 1], [0, -T, 1], [0, T, 1 + T], [T**3, T, 1]])
def test_other_noises_are_refused(shape: list[Any]) -> None:
    with pytest.raises(NoiseError, match="process noise other"):
        through("other", "", "", sp.ImmutableDenseMatrix([[x] for x in shape]))


def test_nested_polynomials() -> None:
    x, y = sp.symbols("x y", real=True)
    at = {x: Fraction(2, 3), y: Fraction(5, 7)}
    for expression in (x**2 * y + x / 3 + 2, x**3, y, sp.Integer(4), (x + y) ** 3 / 6, x * y**2):
        exact = sp.sympify(expression).subs({s: sp.Rational(str(v)) for s, v in at.items()})
        assert sp.Rational(str(nested(expression, (x, y), at))) == exact
    assert nested(sp.Integer(0), (x, y), at) is None
    with pytest.raises(SignError, match="no minus sign is wanted"):
        nested(x - y, (x, y), at)


def test_no_kernel_subtracts() -> None:
    for name, graph in triple_kernels.graphs(triple_noises()).items():
        assert not [node for node in graph["nodes"] if node[0] == "neg"], name
        numbers = [node for node in graph["nodes"] if node[0] == "number"]
        assert not any(str(node[1]).startswith("-") for node in numbers)


def test_every_step_of_the_page_is_of_a_tower() -> None:
    subject = three_states.build()
    assert {step.tower for step in subject.derivation.steps} == set(subject.towers)
    assert [kernel.name for kernel in subject.module.kernels] == list(subject.programs)
