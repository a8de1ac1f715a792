"""Coupled pairs: what holds is accepted, and what does not hold never is."""

from __future__ import annotations

import random
from copy import deepcopy
from typing import Any

import mpmath as mp
import pytest
import sympy as sp
from tests.verify.certificate.coupled_toy import (
    DETERMINANT,
    LARGE,
    PAIR,
    PLACES,
    PLAIN,
    SMALL,
    X_BY_P,
    Y_BY_K,
    C,
    D,
    Data,
    K,
    P,
    R,
    X,
    Y,
    certificate,
    equality,
    grows,
    program,
    statements,
    tends,
    tower,
)
from tests.verify.certificate.toy_writer import expectations, fraction, graph, poly, statement

from gainproof.verify.certificate import check
from gainproof.verify.certificate.alteration_campaign import Campaign
from gainproof.verify.certificate.rejection import Meter
from gainproof.verify.certificate.tower import read_tower


def why(*listed: Data, pair: Data | None = None) -> str:
    """Why a certificate of these statements is not accepted; empty where it is."""
    return check(certificate(list(listed), pair)).reason


def altered(**changes: Any) -> Data:
    """The toy's pair with other fields."""
    return {**deepcopy(PAIR), **changes}


def values(p: Any, k: Any) -> dict[sp.Symbol, Any]:
    """The tower at a point, by bisection of h(x) - x: nothing of the checker's."""
    r = mp.sqrt(1 + p * p)

    def image(x: Any) -> Any:
        return mp.sqrt(k + 4 * p * mp.sqrt(1 + r * x / 2))

    low, high = mp.mpf(10) ** -30, mp.mpf(10) ** 10
    for _ in range(500):
        middle = mp.sqrt(low * high)
        low, high = (middle, high) if image(middle) > middle else (low, middle)
    return {P: p, K: k, R: r, X: low, Y: mp.sqrt(1 + r * low / 2)}


def test_accepted() -> None:
    data = certificate()
    report = check(data, **expectations(data), towers=data["towers"])
    assert report.accepted, report.reason
    assert report.count("proved") == len(data["statements"]) == 11


def test_the_toy_says_what_is_true() -> None:
    """In 60 digits, by bisection and differences: the derivatives and both ends."""
    with mp.workdps(60):
        step = mp.mpf(10) ** -20
        for p, k in ((mp.mpf("0.3"), mp.mpf(2)), (mp.mpf(7), mp.mpf("0.01"))):
            here = values(p, k)
            by_p = (values(p + step, k)[X] - values(p - step, k)[X]) / (2 * step)
            by_k = (values(p, k + step)[Y] - values(p, k - step)[Y]) / (2 * step)
            for found, form in ((by_p, X_BY_P), (by_k, Y_BY_K)):
                wanted = sp.lambdify(PLACES, form, "mpmath")(*(here[v] for v in PLACES))
                assert abs(found / wanted - 1) < mp.mpf(10) ** -25
            shown = sp.lambdify(PLACES, PLAIN - DETERMINANT * X * Y, "mpmath")
            assert abs(shown(*(here[v] for v in PLACES))) < mp.mpf(10) ** -40 * here[X] * here[Y]
        assert abs(values(mp.mpf(10) ** 8, mp.mpf(3))[X] / mp.mpf(10) ** 8 - 2) < 1e-7
        tiny = values(mp.mpf(10) ** -12, mp.mpf(4))
        assert abs(tiny[X] * tiny[Y] - 2 * mp.sqrt(2)) < 1e-10


def test_altered() -> None:
    """No statement stays accepted with a number or field altered."""
    campaign = Campaign(certificate())
    tally = campaign.run(campaign.alterations())
    assert tally.accepted == ()
    assert tally.refuted > 200


@pytest.mark.parametrize(
    ("changes", "because"),
    [
        ({"free": [poly(K - P, PLACES), poly(1, PLACES)]}, "not manifestly nonnegative"),
        ({"free": [poly(K, PLACES), poly(-1, PLACES)]}, "not manifestly nonnegative"),
        ({"slopes": [poly(0, PLACES), poly(R / 2, PLACES)]}, "not manifestly positive"),
        ({"slopes": [poly(4 * P, PLACES), poly(0, PLACES)]}, "not manifestly positive"),
        ({"slopes": [poly(-2 * P, PLACES), poly(R / 2, PLACES)]}, "not manifestly positive"),
        ({"slopes": [poly(4 * P, PLACES), poly(R - P, PLACES)]}, "not manifestly positive"),
        ({"free": [poly(Y, PLACES), poly(1, PLACES)]}, "only earlier variables"),
        ({"free": [poly(X, PLACES), poly(1, PLACES)]}, "only earlier variables"),
        ({"slopes": [poly(4 * P, PLACES), poly(X, PLACES)]}, "only earlier variables"),
        ({"slopes": [poly(Y, PLACES), poly(R / 2, PLACES)]}, "only earlier variables"),
        ({"coupled": ["x", "x"]}, "given twice"),
        ({"coupled": ["r", "y"]}, "given twice"),
        ({"coupled": ["x"]}, "two entries"),
        ({"coupled": ["x", "y", "z"]}, "two entries"),
        ({"free": [poly(K, PLACES)]}, "two entries"),
        ({"power": 2}, "not known here"),
        ({"coupled": "xy"}, "a list is wanted"),
        ({"slopes": [poly(4 * P, PLACES), None]}, ""),
    ],
)
def test_a_pair_that_is_none(changes: Data, because: str) -> None:
    found = why(equality("square", X**2, X**2), pair=altered(**changes))
    assert found
    assert because in found


def test_powers_come_down_to_products_of_both() -> None:
    """Reduced at once: a power of the one brings powers of the other, whose own bring it back."""
    field = read_tower(tower(), Meter(), "main").field
    here = values(mp.mpf("0.7"), mp.mpf("1.9"))
    for powers in ({3: 7}, {4: 6}, {3: 5, 4: 5}, {2: 3, 3: 4, 4: 1}, {3: 1, 4: 1}):
        reduced = field.reduce(field.ring.monomial(powers))
        assert all(reduced.degree(place) <= 1 for place in (2, 3, 4))
        found = mp.fsum(
            mp.mpf(c.numerator)
            / c.denominator
            * mp.fprod(here[v] ** e for v, e in zip(PLACES, monomial, strict=True))
            for monomial, c in reduced.coefficients()
        )
        wanted = mp.fprod(here[PLACES[place]] ** power for place, power in powers.items())
        assert abs(found / wanted - 1) < 1e-12


def test_a_missing_field() -> None:
    for name in PAIR:
        pair = {key: value for key, value in PAIR.items() if key != name}
        assert why(equality("square", X**2, X**2), pair=pair)


def test_a_coupling_that_may_vanish_at_a_closed_end() -> None:
    """b = k with k >= 0 is 0 at the end: then x = 0 solves the equations too."""
    data = certificate([equality("same", X * K * R * Y, K * X * Y * R * P / P)])
    assert check(data).accepted
    data["towers"]["main"]["parameters"][1] = {"symbol": "k", "from": "0"}
    assert check(data).accepted  # k is a free term here, which may vanish
    slopes = [poly(K, PLACES), poly(R / 2, PLACES)]
    data["towers"]["main"]["generators"][1] = altered(slopes=slopes)
    assert "a coupling of 'x' and 'y' is not manifestly positive" in check(data).reason


def test_a_pair_that_comes_before_what_it_holds() -> None:
    data = certificate([equality("square", X**2, K + 4 * P * Y)])
    data["towers"]["main"]["generators"].reverse()
    assert not check(data).accepted


def test_the_other_order_is_another_pair() -> None:
    """x and y are not to be exchanged: what is true of the one is not of the other."""
    pair = altered(coupled=["y", "x"])
    for entry in statements():
        if entry["id"] in ("gap", "root"):
            continue
        assert why(entry, pair=pair), entry["id"]


@pytest.mark.parametrize(
    ("field", "place", "value"),
    [("free", 0, 2 * K), ("free", 1, 2), ("slopes", 0, P), ("slopes", 1, R)],
)
def test_another_radicand(field: str, place: int, value: Any) -> None:
    pair = deepcopy(PAIR)
    pair[field][place] = poly(value, PLACES)
    for entry in statements():
        if entry["id"] in ("large", "root") and field == "free":
            continue  # the end of large p knows nothing of the free terms
        if entry["id"] in ("square", "root") and (field, place) != ("free", 0):
            continue
        if (entry["id"], field, place) == ("small", "slopes", 0):
            continue  # nor does x y at p = 0 of what is multiplied by p
        assert why(entry, pair=pair), entry["id"]


@pytest.mark.parametrize(
    "entry",
    [
        equality("e", X, Y),
        equality("e", X**2, K + P * Y),
        equality("e", X * Y, P * R),
        equality("e", sp.Derivative(X, P), (2 * Y) / (2 * X)),  # y held
        equality("e", sp.Derivative(X, P), -X_BY_P, shown=True),
        equality("e", sp.Derivative(X, K), Y_BY_K, shown=True),
        equality("e", sp.sqrt(1 + R * X / 2), X),
        equality("e", sp.Derivative(X, P), X_BY_P),  # the divisor is not shown
        grows("e", "decreasing"),
        grows("e", "decreasing", -1),
        grows("e", "increasing", -1),
        tends("e", X / P, "infinity", sp.Integer(1), LARGE),
        tends("e", X / P, "infinity", sp.Integer(0), LARGE),
        tends("e", X, "0", K, SMALL),
        program(root_of_x=Y),
        program(root_of_x=2 * X),
        program(root_of_x=K + 4 * P * Y),
        program(root_of_y=X),
        statement(
            "e",
            "positive",
            {"expression": graph(P * R - X * Y)},
            {"value": fraction(1, 1, PLACES), "nonzero": []},
        ),
        statement(
            "e",
            "positive",
            {"expression": graph(DETERMINANT)},
            {"value": fraction(DETERMINANT, 1, PLACES), "nonzero": []},
        ),
    ],
)
def test_false_or_without_reason(entry: Data) -> None:
    assert why(entry)


def test_zero_solves_the_equations_of_the_end_and_is_no_limit() -> None:
    """X^2 = 4 Y, Y^2 = X/2 at p = infinity: (2, 1), and (0, 0), to which nothing tends."""
    zero: list[Any] = []
    boundary = {**LARGE["boundary"], "x": zero, "y": zero}
    nothing = tends(
        "e", 1 / (1 + X / P), "infinity", sp.Integer(1), {**LARGE, "boundary": boundary}
    )
    assert "not manifestly positive" in why(nothing)
    right = tends("e", 1 / (1 + X / P), "infinity", sp.Rational(1, 3), LARGE)
    assert why(right) == ""


@pytest.mark.parametrize(
    ("weights", "boundary", "because"),
    [
        ({"x": 0}, {}, "the weight is too small"),
        ({"y": 0}, {}, "not a root"),
        ({"x": 2}, {}, ""),
        ({"x": 2, "y": 2}, {"x": [], "y": []}, ""),
        ({}, {"x": poly(3, [K])}, "not a root"),
        ({}, {"x": poly(-2, [K])}, "not manifestly nonnegative"),
        ({}, {"x": [], "y": poly(2, [K])}, "not a root"),
    ],
)
def test_ends_with_other_values(weights: Data, boundary: Data, because: str) -> None:
    evidence = {
        **LARGE,
        "weights": {**LARGE["weights"], **weights},
        "boundary": {**LARGE["boundary"], **boundary},
    }
    found = why(tends("e", X / P, "infinity", sp.Integer(2), evidence))
    assert found
    assert because in found


def test_a_negative_root_at_the_end() -> None:
    """(-c)^2 = k as well, and d with it: no value that x tends to."""
    places = [K, C, D]
    wrong = {**SMALL, "boundary": {**SMALL["boundary"], "x": poly(-C, places)}}
    assert "not manifestly nonnegative" in why(tends("e", X, "0", sp.sqrt(K), wrong))


def test_constants_may_be_coupled_too() -> None:
    """With x^2 = p^2 k + 4 p y the end of large p is X^2 = k + 4 Y, Y^2 = X/2: no radicals."""
    a, b = sp.symbols("a b")
    places = [K, a, b]
    pair = altered(free=[poly(K * P**2, PLACES), poly(1, PLACES)])
    constants: Data = {
        "coupled": ["a", "b"],
        "free": [poly(K, places), []],
        "slopes": [poly(4, places), poly(sp.Rational(1, 2), places)],
    }
    evidence: Data = {
        "weights": LARGE["weights"],
        "constants": [constants],
        "boundary": {"r": poly(1, places), "x": poly(a, places), "y": poly(b, places)},
    }
    true = tends("e", X * P / Y**2, "infinity", sp.Integer(2), evidence)
    assert why(true, pair=pair) == ""
    false = tends("e", X * P / Y**2, "infinity", sp.Integer(1), evidence)
    assert why(false, pair=pair)
    exchanged = {**evidence, "boundary": {**evidence["boundary"], "x": poly(b, places)}}
    assert "not a root" in why(
        tends("e", X * P / Y**2, "infinity", sp.Integer(2), exchanged), pair=pair
    )
    named_twice = {**evidence, "constants": [{**constants, "coupled": ["x", "b"]}]}
    assert "given twice" in why(
        tends("e", X * P / Y**2, "infinity", sp.Integer(2), named_twice), pair=pair
    )


def test_no_false_equality_of_random_polynomials() -> None:
    """Polynomials are accepted as equal just if they are, by bisection, at random points."""
    source = random.Random(11)
    with mp.workdps(60):
        points = [
            values(*(mp.mpf(10) ** source.uniform(-2, 2) for _ in range(2))) for _ in range(3)
        ]
        for number in range(40):
            left = sum(
                source.randint(-3, 3) * sp.Mul(*(v ** source.randint(0, 3) for v in PLACES))
                for _ in range(3)
            )
            right = sp.expand(left).subs(X**3, X * (K + 4 * P * Y)).subs(Y**2, 1 + R * X / 2)
            if number % 2:
                right += source.choice((1, P, X - Y, R**2 - 1 - P, X**2 - K - P * Y))
            gap = sp.lambdify(PLACES, [left - right, abs(left) + abs(right) + 1], "mpmath")
            same = all(
                abs(gap(*(at[v] for v in PLACES))[0])
                < mp.mpf(10) ** -30 * abs(gap(*(at[v] for v in PLACES))[1])
                for at in points
            )
            entry = equality("e", left + X * Y * R, right + X * Y * R)
            assert (why(entry) == "") == same
