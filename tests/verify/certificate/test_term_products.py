"""Products of many terms against SymPy's polynomials; monomials as numbers against tuples."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.verify.certificate.monomials import (
    beyond,
    exponents_of,
    guards,
    highest,
    monomial_of,
)
from gainproof.verify.certificate.polynomial import Ring
from gainproof.verify.certificate.rejection import (
    MAXIMUM_EXPONENT,
    MAXIMUM_TERMS,
    Meter,
    RejectedError,
)
from gainproof.verify.certificate.term_products import Terms, product_of

SYMBOLS = sp.symbols("x y z")
Found = dict[tuple[int, ...], int]


def _terms(highest: int) -> st.SearchStrategy[Found]:
    exponents = st.tuples(*[st.integers(0, highest)] * 3)
    coefficients = st.integers(-(10**30), 10**30).filter(bool)
    return st.dictionaries(exponents, coefficients, min_size=1, max_size=40)


def _numbered(terms: Found) -> Terms:
    return {monomial_of(m): c for m, c in terms.items()}


@settings(deadline=None, max_examples=samples(20))
@given(_terms(2), _terms(MAXIMUM_EXPONENT))
def test_as_sympy_has_it(first: Found, second: Found) -> None:
    expected = (
        sp.Poly.from_dict(first, *SYMBOLS, domain="ZZ")
        * sp.Poly.from_dict(second, *SYMBOLS, domain="ZZ")
    ).as_dict()
    product = product_of(_numbered(first), _numbered(second))
    assert {exponents_of(m, 3): c for m, c in product.items() if c} == expected


def test_too_many_terms_are_refused() -> None:
    count = 210
    assert count * count > MAXIMUM_TERMS
    row: Found = {(i, 0, 0): 1 for i in range(count)}
    column: Found = {(0, i, 0): 1 for i in range(count)}
    with pytest.raises(RejectedError, match="grew beyond"):
        product_of(_numbered(row), _numbered(column))


monomials = st.tuples(*[st.integers(0, MAXIMUM_EXPONENT)] * 3)


@settings(max_examples=samples(50))
@given(st.lists(monomials, min_size=1, max_size=5), monomials)
def test_numbers_are_as_their_exponents(
    found: list[tuple[int, ...]], limits: tuple[int, ...]
) -> None:
    numbers, guard = [monomial_of(m) for m in found], guards(3)
    assert [exponents_of(number, 3) for number in numbers] == found
    assert [exponents_of(number, 3) for number in sorted(numbers)] == sorted(found)
    degrees = tuple(map(max, zip(*found, strict=True)))
    assert exponents_of(highest(numbers, guard), 3) == degrees
    # a sum of two is within its digits, and compared there
    double = tuple(2 * degree for degree in degrees)
    assert exponents_of(2 * monomial_of(degrees), 3) == double
    for high, number in ((degrees, monomial_of(degrees)), (double, 2 * monomial_of(degrees))):
        above = beyond(number, monomial_of(limits), guard)
        assert [bool(digit) for digit in exponents_of(above, 3)] == [
            one > other for one, other in zip(high, limits, strict=True)
        ]


@pytest.mark.parametrize("exponent", [-1, MAXIMUM_EXPONENT + 1])
def test_an_exponent_that_leaves_its_digit_is_refused(exponent: int) -> None:
    with pytest.raises(RejectedError, match="not between"):
        monomial_of((1, exponent, 1))


@pytest.mark.parametrize("position", range(3))
def test_an_exponent_may_not_grow_beyond_its_limit(position: int) -> None:
    ring = Ring(3, Meter())
    top = ring.monomial({position: MAXIMUM_EXPONENT, (position + 1) % 3: 7})
    assert (top * ring.constant(2)).degree(position) == MAXIMUM_EXPONENT
    with pytest.raises(RejectedError, match="grew beyond"):
        _ = top * ring.variable(position)


def test_monomials_that_a_table_does_not_tell_apart_cost_what_they_take() -> None:
    """Digits nine apart lie over one another by four bits: 16 in one is 1 in the other."""
    crowd: dict[tuple[int, ...], Fraction] = {
        (*(0,) * 13, a, b, *(0,) * 7, 16 * (31 - a), 16 * (31 - b)): Fraction(1)
        for a in range(32)
        for b in range(32)
    }
    spread: dict[tuple[int, ...], Fraction] = {
        (*(0,) * 13, a, b, *(0,) * 9): Fraction(1) for a in range(32) for b in range(32)
    }
    costs = []
    for terms in (crowd, spread):
        ring = Ring(24, Meter())
        before = ring.meter.remaining
        polynomial = ring.polynomial(terms)
        costs.append(before - ring.meter.remaining)
        assert len(polynomial.terms) == len(terms) == 1024
    assert len(set(map(hash, map(monomial_of, crowd)))) == 1
    assert costs[0] > 1024 * 1024
    assert costs[1] < 2 * 1024
