"""A domain in a parameter of the judge's own is retold where a whole condition stands, and nowhere
else: a number that goes on is another one.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import pytest

from gainproof.verify.judge.claim.record import Setting, SymbolEntry
from gainproof.verify.judge.exact.algebraic_numbers import rational_point
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, power, symbol
from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.setting.environment import DEVIATION, INDEX, INTERVAL, Environment
from gainproof.verify.judge.source_symbols import in_source_symbols
from gainproof.verify.judge.verdict import Finding

p, T, DEV = symbol("p"), symbol(INTERVAL), symbol(DEVIATION)
POSITIVE = Box(lower=Fraction(0))


def cell(left: str, right: str) -> Place:
    low, high = (rational_point(Fraction(end)) for end in (left, right))
    return Place(left=low, right=high, is_cell=True)


def retold(
    domain: str, lower: str, upper: str | None, value: Expr, region: Sequence[Place] = ()
) -> Finding:
    """The finding where the index of the source is `value` of p, which is between two numbers."""
    box = Box(lower=Fraction(lower), upper=None if upper is None else Fraction(upper))
    entry = SymbolEntry(r"\Lambda", "index", "quantity", quantity=INDEX)
    setting = Setting("s", "steady_state", "s", {r"\Lambda": entry})
    boxes = {"p": box, "p_1": POSITIVE}
    environment = Environment("s", {INDEX: value}, boxes, parameter="p")
    found = Finding("conditional", f"true {domain}; not everywhere", domain, region=tuple(region))
    return in_source_symbols(found, setting, environment)


HALF_OPEN = p / (1 - p)
"""Through all positive numbers for p from 0 to 1."""
UNKNOWN = (
    ("for 0 < p < 1/2", "0", "1"),
    ("for 0 < p < 1.5", "0", "1"),
    ("for 0 < p < 15", "0", "1"),
    ("for 0 < p < 1 + sqrt(2)", "0", "1"),
    ("for 0 < p < 1*sqrt(2)", "0", "1"),
    ("for -1/2 + 0 < p < 1", "0", "1"),
    ("for 10 < p < 1", "0", "1"),
    ("for 1/0 < p < 1", "0", "1"),
)


@pytest.mark.parametrize(("domain", "lower", "upper"), UNKNOWN)
def test_a_number_that_goes_on_is_another_one(domain: str, lower: str, upper: str) -> None:
    found = retold(domain, lower, upper, HALF_OPEN)
    wanted = rf"{domain}, where \Lambda = p / (1 - p)"
    assert found.domain == wanted
    assert found.reason == f"true {wanted}; not everywhere"


@pytest.mark.parametrize("domain", ["for p > 0/2", "for p > 0 - q", "for q - p > 0"])
def test_nor_is_one_without_upper_bound(domain: str) -> None:
    assert retold(domain, "0", None, power(p, 2)).domain == rf"{domain}, where \Lambda = p^2"


@pytest.mark.parametrize(
    ("domain", "wanted"),
    [
        ("for 0 < p < 1", r"for \Lambda > 0"),
        ("for 0 < p < 1, T > 0", r"for \Lambda > 0, T > 0"),
        ("T > 0, 0 < p < 1, where every part has a value", None),
        ("except where T = 1 and (0 < p < 1)", r"except where T = 1 and (\Lambda > 0)"),
    ],
)
def test_a_whole_condition_is_retold(domain: str, wanted: str | None) -> None:
    found = retold(domain, "0", "1", HALF_OPEN)
    wanted = wanted or domain.replace("0 < p < 1", r"\Lambda > 0")
    assert found.domain == wanted
    assert found.reason == f"true {wanted}; not everywhere"


def test_a_known_region_is_retold() -> None:
    """p/(1 - p) is 1 at p = 1/2, by hand."""
    found = retold("for 0 < p < 1/2, T > 0", "0", "1", HALF_OPEN, [cell("0", "1/2")])
    assert found.domain == r"for 0 < \Lambda < 1, T > 0"


@pytest.mark.parametrize("domain", ["for p_1 > 0", r"for \dot{p} > 0", "for sharp > 0"])
def test_a_part_of_another_name_is_not_the_parameter(domain: str) -> None:
    assert retold(domain, "0", None, power(p, 2)).domain == domain


@pytest.mark.parametrize("k", [-12, -1, 1, 2, 12])
def test_a_symbol_in_units_is_told_with_every_power_up_to_twelve(k: int) -> None:
    entry = SymbolEntry("q", "strength", "free")
    setting = Setting("s", "steady_state", "s", {"q": entry})
    boxes = {"p": POSITIVE, INTERVAL: POSITIVE}
    environment = Environment(
        "s", {}, boxes, parameter="p", assigned={"q": power(p, 2) * power(T, k)}
    )
    found = in_source_symbols(Finding("proved", "", "for p > 0"), setting, environment)
    size = "" if abs(k) == 1 else f"^{abs(k)}"
    name = INTERVAL
    words = f"q/{name}{size}" if k > 0 else f"q {name}{size}"
    assert found.domain == f"for {words} > 0"


@pytest.mark.parametrize(
    ("value", "end", "wanted"),
    [
        # by hand: p/(1 - p) goes from 0 to infinity, (1 - p)/p back, and so do their squares
        (HALF_OPEN, "0", "0"),
        (HALF_OPEN, "1", "infinity"),
        (1 / HALF_OPEN, "0", "infinity"),
        (1 / HALF_OPEN, "1", "0"),
        (power(HALF_OPEN, 2), "1", "infinity"),
    ],
)
@pytest.mark.parametrize("rest", ["", ", T > 0", ", where every part has a value"])
def test_where_it_goes_is_retold(value: Expr, end: str, wanted: str, rest: str) -> None:
    found = retold(f"as p -> {end}{rest}", "0", "1", value)
    assert found.domain == rf"as \Lambda -> {wanted}{rest}"
    assert found.reason == f"true {found.domain}; not everywhere"


def test_so_is_it_without_an_upper_bound() -> None:
    assert retold("as p -> infinity", "0", None, power(p, 2)).domain == r"as \Lambda -> infinity"
    # 1 is no end
    kept = retold("as p -> 1", "0", None, power(p, 2)).domain
    assert kept == r"as p -> 1, where \Lambda = p^2"
