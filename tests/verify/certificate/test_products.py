"""Products of many terms, dense and sparse, against SymPy's polynomials."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.verify.certificate import products
from gainproof.verify.certificate.products import Terms
from gainproof.verify.certificate.rejection import MAXIMUM_TERMS, RejectedError

SYMBOLS = sp.symbols("x y z")


def _terms(highest: int) -> st.SearchStrategy[Terms]:
    exponents = st.tuples(*[st.integers(0, highest)] * 3)
    coefficients = st.integers(-(10**30), 10**30).filter(bool)
    return st.dictionaries(exponents, coefficients, min_size=1, max_size=40)


def _degrees(*factors: Terms) -> list[int]:
    return [sum(max(m[place] for m in terms) for terms in factors) for place in range(3)]


@settings(deadline=None, max_examples=samples(40))
@given(_terms(2), _terms(3))
def test_both_ways_agree_with_sympy(first: Terms, second: Terms) -> None:
    expected = (
        sp.Poly.from_dict(first, *SYMBOLS, domain="ZZ")
        * sp.Poly.from_dict(second, *SYMBOLS, domain="ZZ")
    ).as_dict()
    degrees = _degrees(first, second)
    by_places = products._by_places(first, second, degrees)
    by_pairs = products._by_pairs(first, second, degrees)
    assert by_places == expected
    assert {m: c for m, c in by_pairs.items() if c} == expected
    chosen = products.product_of(first, second, degrees)
    assert {m: c for m, c in chosen.items() if c} == expected


def test_a_dense_product_goes_by_places(monkeypatch: pytest.MonkeyPatch) -> None:
    square: Terms = {(i, j, 0): 1 for i in range(4) for j in range(4)}
    monkeypatch.setattr(products, "_by_pairs", None)
    assert products.product_of(square, square, _degrees(square, square))[3, 3, 0] == 16


def test_too_many_terms_are_refused() -> None:
    count = 210
    assert count * count > MAXIMUM_TERMS
    row: Terms = {(i, 0, 0): 1 for i in range(count)}
    column: Terms = {(0, i, 0): 1 for i in range(count)}
    with pytest.raises(RejectedError, match="grew beyond"):
        products.product_of(row, column, _degrees(row, column))
