"""Orders of named filters at equal lag and equal gain."""

from __future__ import annotations

import pytest
from free_gains import FILTERS, verdict
from one_of_each import cases
from small_claims import check

from gainproof.verify.judge.verdict import ClaimVerdict


def order(
    names: str, fixed: str = "e_{12}", compared: str = "p_{11}", more: str = ""
) -> ClaimVerdict:
    ascending = ", ".join(f"'{name}'" for name in names.split())
    fields = (
        f"text = 'order'\ncompared = '{compared}'\nascending = [{ascending}]\nfixed = ['{fixed}']"
    )
    return verdict("ordering", f"{fields}\n{more}", 2, FILTERS)


ORDERS = [
    ("MV RA", "e_{12}", "p_{11}", "proved"),
    ("MV RA RV", "e_{12}", "p_{11}", "proved"),
    ("MV RA RV", r"\beta", "p_{11}", "proved"),
    ("MV RA RV", "e_{12}", r"\alpha", "proved"),
    ("RA MV", "e_{12}", "p_{11}", "refuted"),
    ("MV RV RA", "e_{12}", "p_{11}", "refuted"),
    ("RV RA MV", "e_{12}", "p_{11}", "refuted"),
    ("RV RA", r"\alpha", "p_{11}", "proved"),
    # of either filter of minimum variance with this gain
    ("RV RA MV", r"\alpha", "p_{11}", "proved"),
    ("MV RA", r"\alpha", "p_{11}", "refuted"),
    # at an equal gain of the position the lag of RA is the smaller one
    ("RA RV", r"\alpha", r"\frac{1}{\beta}", "proved"),
    ("RV RA", r"\alpha", r"\frac{1}{\beta}", "refuted"),
    # equal, hence not strictly ordered
    ("MV RA", "e_{12}", r"\beta", "refuted"),
    ("MV RA", "e_{12}", "e_{12}", "refuted"),
]
LIKE_ANOTHER = [
    ("MV RA", "e_{12}", "p_{11}", "proved"),
    ("MV RA RV", "e_{12}", r"\alpha", "proved"),
    ("MV RV RA", "e_{12}", "p_{11}", "refuted"),
    ("RV RA MV", "e_{12}", "p_{11}", "refuted"),
    ("RV RA", r"\alpha", "p_{11}", "proved"),
    ("RV RA MV", r"\alpha", "p_{11}", "proved"),
    ("MV RA", "e_{12}", "e_{12}", "refuted"),
]


@pytest.mark.parametrize(
    ("names", "fixed", "compared", "wanted"),
    cases(ORDERS, lambda case: case not in LIKE_ANOTHER),
)
def test_orders(names: str, fixed: str, compared: str, wanted: str) -> None:
    found = order(names, fixed, compared)
    allowed = (wanted, "conditional") if wanted == "refuted" else (wanted,)
    assert found.verdict in allowed, found.reason


def test_a_filter_that_does_not_exist_is_no_proof() -> None:
    found = order("MV RA", more="domain = '\\alpha > 1'")
    assert found.verdict == "undecided"


def test_an_unknown_filter() -> None:
    found = order("MV RX")
    assert "no filter RX" in found.reason
    check(order("MV RA"), "proved")
