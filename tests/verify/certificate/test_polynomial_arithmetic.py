"""Polynomials and reduction against SymPy; positivity against the definition."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.verify.certificate.field import Field, Generator, Parameter
from gainproof.verify.certificate.polynomial import Polynomial, Ring
from gainproof.verify.certificate.ratio import Ratio, fraction
from gainproof.verify.certificate.rejection import Meter, RejectedError

RING = Ring(3, Meter())
X, Y, Z = sp.symbols("x y z")

coefficients = st.fractions(min_value=-5, max_value=5, max_denominator=6)
terms = st.dictionaries(st.tuples(*[st.integers(0, 4)] * 3), coefficients, max_size=5)
polynomials = terms.map(lambda found: Ring.polynomial(RING, found))


@pytest.fixture(autouse=True)
def _fresh_meter() -> None:
    RING.meter.reset()


def _symbolic(value: Polynomial) -> Any:
    return sp.Add(
        *(
            sp.Rational(c.numerator, c.denominator) * X ** m[0] * Y ** m[1] * Z ** m[2]
            for m, c in value.coefficients()
        )
    )


def _same(value: Polynomial, expected: Any) -> bool:
    return bool(sp.expand(_symbolic(value) - expected) == 0)


@settings(deadline=None, max_examples=samples(10))
@given(polynomials, polynomials)
def test_arithmetic(a: Polynomial, b: Polynomial) -> None:
    assert _same(a + b, _symbolic(a) + _symbolic(b))
    assert _same(a - b, _symbolic(a) - _symbolic(b))
    assert _same(a * b, _symbolic(a) * _symbolic(b))
    assert _same(-a, -_symbolic(a))
    assert (a - a).terms == {}
    assert (a == b) == (sp.expand(_symbolic(a) - _symbolic(b)) == 0)
    assert a + b - b == a
    assert hash(a + b - b) == hash(a)


@settings(deadline=None, max_examples=samples(10))
@given(polynomials, st.integers(0, 2), coefficients)
def test_calculus(a: Polynomial, position: int, number: Fraction) -> None:
    symbol = (X, Y, Z)[position]
    assert _same(a.partial(position), sp.diff(_symbolic(a), symbol))
    shifted = RING.variable(position) + RING.constant(number)
    expected = _symbolic(a).subs(symbol, symbol + sp.Rational(number.numerator, number.denominator))
    assert _same(a.substitute(position, shifted), expected)
    assert (
        sum(
            (part * RING.monomial({position: e}) for e, part in a.by_power(position).items()),
            RING.constant(0),
        )
        == a
    )
    assert a.degree(position) == max((e for e in a.by_power(position)), default=0)
    assert _same(a.times(number), _symbolic(a) * sp.Rational(number.numerator, number.denominator))


@given(polynomials)
def test_primitive(a: Polynomial) -> None:
    factor, rest = a.primitive()
    assert factor > 0
    assert rest.times(factor) == a
    assert rest.denominator == 1


def _field() -> Field:
    """x > 0, y = sqrt(x^2 + 1), z = cube root of x y + 2."""
    field = Field(RING, (Parameter("x", Fraction(0), False),), (), ())
    one = Fraction(1)
    field = field.with_generator(
        Generator("y", 2, RING.polynomial({(2, 0, 0): one, (0, 0, 0): one}))
    )
    return field.with_generator(
        Generator("z", 3, RING.polynomial({(1, 1, 0): one, (0, 0, 0): 2 * one}))
    )


@settings(deadline=None, max_examples=samples(10))
@given(polynomials)
def test_reduction(a: Polynomial) -> None:
    field = _field()
    reduced = field.reduce(a)
    relations = [Z**3 - X * Y - 2, Y**2 - X**2 - 1]
    _, remainder = sp.reduced(_symbolic(a), relations, Z, Y, X, order="lex")
    assert _same(reduced, remainder)
    assert reduced.degree(1) < 2
    assert reduced.degree(2) < 3


@given(polynomials, polynomials)
def test_ideal_members_vanish(a: Polynomial, b: Polynomial) -> None:
    field = _field()
    assert field.is_zero(a * field.relation(0) + b * field.relation(1))


@given(terms, st.lists(st.fractions(0, 9), min_size=3, max_size=3))
def test_positive_means_positive(found: dict[Any, Fraction], point: list[Fraction]) -> None:
    """Parameters x from 1, y from -2, z above 0: no counterexample at a point of the domain."""
    field = Field(
        RING,
        (
            Parameter("x", Fraction(1), True),
            Parameter("y", Fraction(-2), True),
            Parameter("z", Fraction(0), False),
        ),
        (),
        (),
    )
    value = RING.polynomial(found)
    place = (point[0] + 1, point[1] - 2, point[2] + Fraction(1, 7))
    at_place = sum(
        (
            c * place[0] ** m[0] * place[1] ** m[1] * place[2] ** m[2]
            for m, c in value.coefficients()
        ),
        Fraction(0),
    )
    if field.positive(value):
        assert at_place > 0
    if field.nonnegative(value):
        assert at_place >= 0
    if field.positive_inside(value) and point[0] and point[1]:
        assert at_place > 0


def test_positive_examples() -> None:
    field = Field(
        RING,
        (
            Parameter("x", Fraction(1), True),
            Parameter("y", Fraction(0), True),
            Parameter("z", Fraction(0), False),
        ),
        (),
        (),
    )
    one, x, y, z = RING.constant(1), *(RING.variable(i) for i in range(3))
    assert field.positive(x)
    assert not field.positive(x - one)
    assert field.positive_inside(x - one)
    assert not field.positive(y)
    assert not field.positive(y + (x - one) * z)
    assert field.positive(y + z)
    assert field.positive(z)
    assert not field.positive(z - z)
    assert field.nonnegative(z - z)
    assert not field.nonnegative(z - one)


def test_free_symbols_are_never_positive() -> None:
    field = Field(RING, (Parameter("x", Fraction(0), False),), (), ("y", "z"))
    assert field.positive(RING.variable(0))
    assert not field.positive(RING.variable(1))
    assert not field.nonnegative(RING.variable(1) * RING.variable(1))


def test_radicand_must_be_positive() -> None:
    field = Field(RING, (Parameter("x", Fraction(0), True),), (), ())
    for radicand in (
        RING.variable(0),
        RING.constant(0),
        RING.constant(-1),
        RING.variable(0) - RING.constant(1),
    ):
        with pytest.raises(RejectedError, match="not manifestly positive"):
            field.with_generator(Generator("y", 2, radicand))


ratios = st.tuples(polynomials, st.integers(1, 3), st.integers(0, 2)).map(
    lambda made: (made[0], RING.variable(made[2]) + RING.constant(made[1]))
)


@settings(deadline=None, max_examples=samples(12))
@given(ratios, ratios)
def test_ratios(
    first: tuple[Polynomial, Polynomial],
    second: tuple[Polynomial, Polynomial],
) -> None:
    field = Field(RING, tuple(Parameter(n, Fraction(0), False) for n in "xyz"), (), ())
    one, other = (fraction(field, a, b, "") for a, b in (first, second))
    left, right = (_symbolic(a) / _symbolic(b) for a, b in (first, second))
    cases: list[tuple[Ratio, Any]] = [
        (one + other, left + right),
        (one - other, left - right),
        (one * other, left * right),
    ]
    if not second[0].terms:
        with pytest.raises(RejectedError, match="division by zero"):
            one.over(other)
    else:
        cases.append((one.over(other), left / right))
    for found, expected in cases:
        below = sp.Mul(*(_symbolic(f) ** m for f, m in found.factors.items()))
        assert sp.cancel(_symbolic(found.numerator) / below - expected) == 0


def test_two_rings_do_not_mix() -> None:
    other = Ring(3, Meter())
    with pytest.raises(RejectedError, match="different variables"):
        _ = RING.constant(1) + other.constant(1)
