"""Noises, polynomials and graphs of the recursion of three states."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import catalogue_subjects
import pytest
import sympy as sp

from gainproof.derive.algebra.evidence import evidence
from gainproof.derive.algebra.positive_forms import NoPlainSign
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.recursion import three_state_kernels
from gainproof.derive.recursion.noise import NoiseError, T
from gainproof.derive.recursion.polynomial import SignError, nested
from gainproof.derive.recursion.three_state_names import Q, R, S, filled
from gainproof.derive.recursion.three_state_noise import through, triple_noises
from gainproof.derive.recursion.three_state_start import covariance, newer, older, started, weights
from gainproof.derive.recursion.three_state_towers import samples_tower, values_of
from gainproof.derive.relation import positive
from gainproof.verify.certificate import check

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
    for name, graph in three_state_kernels.graphs(triple_noises()).items():
        assert not [node for node in graph["nodes"] if node[0] == "neg"], name
        numbers = [node for node in graph["nodes"] if node[0] == "number"]
        assert not any(str(node[1]).startswith("-") for node in numbers)


def test_every_step_of_the_page_is_of_a_tower() -> None:
    found = catalogue_subjects.derived("recursion-three-states")
    assert {step.tower for step in found.steps} == set(found.certificate["towers"])
    assert [kernel["name"] for kernel in found.kernels] == list(found.programs)


def test_start_from_three_positions() -> None:
    """The parabola through them, and its covariance at numbers, one entry after the other."""
    s, t, q, r = map(sp.Rational, (2, 3, "1/5", 7))
    at = {S: s, T: t, Q: q, R: r}
    positions = [5 - 4 * x + 3 * x**2 for x in (s + t, s, sp.Integer(0))]
    now = weights().subs(at) * sp.Matrix(positions)
    last = s + t
    assert list(now) == [5 - 4 * last + 3 * last**2, -4 + 6 * last, 6]
    span = (s * t * (s + t)) ** 2
    for noise in triple_noises():
        parts = [(weights(), r * sp.eye(3)), (newer(), noise.covariance.subs(at))]
        parts.append((older(), noise.covariance.subs(T, S).subs(at)))
        wanted = sum((m.subs(at) * w * m.subs(at).T for m, w in parts), sp.zeros(3, 3))
        assert covariance(noise).subs(at) == wanted * span
        d1, d2, d3, a, b, c = values_of(started(noise, at))
        u = sp.Matrix([[1, a + c, a * b], [0, 1, b], [0, 0, 1]])
        assert u * sp.diag(d1, d2, d3) * u.T == wanted


def test_a_start_of_another_noise_is_refused() -> None:
    subject = catalogue_subjects.subject("recursion-three-states")
    certificate = subject.certificate()
    assert check(certificate, claims=subject.claims()).accepted
    elements = certificate["towers"]["start"]["elements"]
    names = "random_jerk_start_third_shear", "wiener_acceleration_start_third_shear"
    elements[names[0]], elements[names[1]] = (elements[name] for name in reversed(names))
    refused = check(certificate, claims=subject.claims())
    assert not refused.accepted
    assert "start" in str(refused.reason)


K, ALPHA = real("k"), real("alpha")


def test_a_bracket_that_is_too_narrow_is_not_shown() -> None:
    holds = [9 / ALPHA - 5 - K, K - (9 / ALPHA - 5 - sp.Rational(8, 3))]
    fails = [9 / ALPHA - sp.Rational(51, 10) - K, K - (9 / ALPHA - 5 - sp.Rational(1, 2))]
    for expression in holds:
        assert evidence(Step("x", "", positive(expression), "", "samples"), samples_tower())
    for expression in fails:
        with pytest.raises(NoPlainSign):
            evidence(Step("x", "", positive(expression), "", "samples"), samples_tower())


def test_entries_give_the_factors() -> None:
    entries = list(map(sp.Integer, (90, 50, 10, 50, 20, 25)))
    p = filled(entries)
    minor, mixed = p[1, 1] * p[2, 2] - p[1, 2] ** 2, p[0, 1] * p[1, 2] - p[0, 2] * p[1, 1]
    a, b, c = p[0, 2] / p[1, 2], p[1, 2] / p[2, 2], p[2, 2] * mixed / (minor * p[1, 2])
    u = sp.Matrix([[1, a + c, a * b], [0, 1, b], [0, 0, 1]])
    assert u * sp.diag(p.det() / minor, minor / p[2, 2], p[2, 2]) * u.T == p
