"""Small files that ask for much: the meter stops them, and what costs nothing is not charged.

Each was found to outrun the promise of bounded time and memory. The allowance is made small here,
so that a test is over soon also where nothing would stop it; none asserts a time.
"""

from __future__ import annotations

from copy import deepcopy
from fractions import Fraction
from itertools import islice, product
from typing import Any

import pytest
from word_certificates import (
    ONE,
    certificate,
    cofactor,
    equal,
    equation,
    invertible,
    known,
    order,
    poly,
    reasons,
    setting,
    square,
)

from gainproof.verify.certificate import check_statement
from gainproof.verify.certificate.matrix_words.polynomial import MAXIMUM_WORD_TERMS, Polynomial
from gainproof.verify.certificate.rejection import Meter, RejectedError

Data = dict[str, Any]
GIVEN_UP = "more arithmetic than any certificate needs"
NAMES = [f"x{i:02d}" for i in range(20)]


def _allow(monkeypatch: pytest.MonkeyPatch, work: int) -> None:
    monkeypatch.setattr("gainproof.verify.certificate.rejection.MAXIMUM_WORK", work)


def _many(terms: int, letters: int) -> list[Any]:
    """A polynomial of so many terms, each of so many letters."""
    words = islice(product(NAMES, repeat=3), terms)
    return [["1", [], [*word, *["x00"] * (letters - 3)]] for word in words]


def _place(**elements: Any) -> Data:
    names = dict.fromkeys([*NAMES, *elements], "n n")
    return setting(names, elements=elements)


def _words(terms: int, letters: int, first: int) -> Polynomial:
    """The same, without a file around it; words of different `first` differ."""
    empty: tuple[int, ...] = ()
    found = {(empty, (2 * (first + i),) * letters): Fraction(1) for i in range(terms)}
    return Polynomial(found, ("n", "n"))


def test_a_product_is_given_up_while_it_is_formed() -> None:
    """Two rows already have too many terms: the other hundreds are not formed."""
    meter = Meter()
    start = meter.remaining
    long = _words(MAXIMUM_WORD_TERMS // 2 + 1, 1, 1000)
    formed: list[int] = []

    class Counted(dict[Any, Any]):
        def items(self) -> Any:
            for item in super().items():
                formed.append(1)
                yield item

    short = Polynomial(Counted(_words(300, 1, 0).terms), ("n", "n"))
    with pytest.raises(RejectedError, match=f"more than {MAXIMUM_WORD_TERMS} terms"):
        short.times(long, meter, "x")
    assert start - meter.remaining > 300 * len(long.terms)
    looked_at = 2 * 300  # for the longest word and for the effort
    assert len(formed) <= looked_at + 2


def test_words_too_long_are_refused_before_anything_is_multiplied() -> None:
    meter = Meter()
    start = meter.remaining
    with pytest.raises(RejectedError, match="a word of more than"):
        _words(5, 25, 0).times(_words(5, 25, 10), meter, "x")
    assert meter.remaining == start


@pytest.mark.parametrize("letters", [1, 24])
def test_a_product_costs_what_its_words_are_long(letters: int) -> None:
    meter = Meter()
    start = meter.remaining
    _words(10, letters, 0).times(_words(10, letters, 100), meter, "x")
    assert start - meter.remaining >= 10 * 10 * 2 * letters


def test_cofactors_of_long_words_are_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """A hundred terms on both sides, 20 letters each: 20000 products of 41 letters."""
    _allow(monkeypatch, 500_000)
    place = _place(Y=poly("1 x01"))
    many = _many(100, 20)
    claim = equal("x", "x00", "x00", [cofactor(["element", "Y"], many, many)])
    assert GIVEN_UP in reasons(certificate(place, claim))["x"]


@pytest.mark.parametrize("turned", [False, True])
def test_long_equations_used_again_and_again_are_given_up(
    turned: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    _allow(monkeypatch, 1_000_000)
    place = _place(Z=_many(300, 46))
    one = cofactor(["element", "Z"], ONE, ONE, turned=turned)
    claim = equal("x", "x00", "x00", [one] * 100)
    assert GIVEN_UP in reasons(certificate(place, claim))["x"]


@pytest.mark.parametrize("kind", ["neg", "transpose"])
def test_signs_and_transposes_again_and_again_are_given_up(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    _allow(monkeypatch, 100_000)
    nodes: list[list[Any]] = [["symbol", name] for name in NAMES]
    nodes += [["add", *range(20)], ["mul", 20, 20]]
    nodes += [[kind, number] for number in range(21, 390)]
    long = {"nodes": nodes, "outputs": {"value": len(nodes) - 1}}
    claim = equal("x", "x00", "x00", [])
    claim["claim"].update(left=long, right=deepcopy(long))
    assert GIVEN_UP in reasons(certificate(_place(), claim))["x"]


def test_long_hypotheses_are_not_compared_at_every_use(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each is written down once for a statement, and compared by its number from then on."""
    compared: list[int] = []

    class Long(str):
        __slots__ = ()

        def __eq__(self, other: object) -> bool:
            compared.append(1)
            return str.__eq__(self, other)

        __hash__ = str.__hash__

    def copied(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: copied(item) for key, item in value.items()}
        if isinstance(value, list | tuple):
            return [copied(item) for item in value]
        return Long(value) if value == "A" else value

    monkeypatch.setattr("gainproof.verify.certificate.checker.plain", copied)
    place = setting({"A": "n n", "B": "n n"})

    def count(uses: int) -> int:
        given = [equation("B", ("mul", str(k), "A")) for k in range(2, 7)]
        sources = [cofactor(["given", k], ONE, ONE) for k in range(5)]
        sides = ("mul", "5", "B"), ("mul", "20", "A")
        base = equal("p", *sides, sources, *given)
        again = ("mul", str(5 * uses), "B"), ("mul", str(20 * uses), "A")
        used = [cofactor(["statement", "p"], ONE, ONE)] * uses
        data = certificate(place, base, equal("q", *again, used, *given))
        compared.clear()
        assert reasons(data) == {}
        return len(compared)

    assert count(30) == count(1)


def _chain(length: int) -> Data:
    """A = B by hypothesis, and every further statement by the one before it."""
    given = equation("A", "B")
    first = equal("s0", "A", "B", [cofactor(["given", 0], ONE, ONE)], given)
    rest = [
        equal(f"s{i}", "A", "B", [cofactor(["statement", f"s{i - 1}"], ONE, ONE)], given)
        for i in range(1, length)
    ]
    return certificate(setting({"A": "n n", "B": "n n"}), first, *rest)


def test_a_long_chain_of_statements_is_decided_from_its_end() -> None:
    data = _chain(300)
    result = check_statement(data, "s299")
    assert (result.status, result.reason) == ("proved", "")
    data["statements"][0]["evidence"]["cofactors"][0]["left"] = poly("2")
    result = check_statement(data, "s299")
    assert result.status == "rejected"
    assert "left over" in result.reason


def test_a_chain_goes_through_orders_and_inverses() -> None:
    """Each way in which evidence may name a statement is followed."""
    given = known("definite", "A")
    rank = {"left_inverses": [[0, ONE]], "cofactors": []}
    data = certificate(
        setting({"A": "n n", "A_i": "n n"}, units={"I": "n"}, inverses={"A_i": "A"}),
        order("first", "A", "0", [square(ONE, ["given", 0])], given, rank=rank),
        order("second", "A", "0", [square(ONE, ["statement", "first"])], given, rank=rank),
        invertible("third", "A", {"because": ["statement", "second"]}, given),
        equal(
            "fourth",
            ("mul", "A", "A_i"),
            "I",
            [cofactor(["inverse", "third", "right"], ONE, ONE)],
            given,
        ),
    )
    assert reasons(data) == {}
    assert check_statement(data, "fourth").status == "proved"
    data["statements"][0]["evidence"]["squares"][0]["weight"] = poly("2")
    assert "left over" in check_statement(data, "fourth").reason


HIDDEN: dict[str, tuple[list[Data], list[Data], str]] = {
    "once and once less": (
        [cofactor(["given", 0], ONE, ONE), cofactor(["given", 0], poly("-1"), ONE)],
        [equation("A", "B")],
        "cancel",
    ),
    "in three parts": (
        [
            cofactor(["given", 0], poly("1 A", "1 B"), ONE),
            cofactor(["given", 0], poly("-1 A"), ONE),
            cofactor(["given", 0], poly("-1/2 B"), poly("2")),
        ],
        [equation("A", "B")],
        "cancel",
    ),
    "transposed": (
        [
            cofactor(["given", 0], ONE, ONE, turned=True),
            cofactor(["given", 0], poly("-1"), ONE, turned=True),
        ],
        [equation("A", "B")],
        "cancel",
    ),
    "transposed up to the sign": (
        [
            cofactor(["given", 0], ONE, ONE),
            cofactor(["given", 0], ONE, ONE, turned=True),
        ],
        [known("symmetric", "A")],
        "its own transpose",
    ),
    "nothing": (
        [cofactor(["given", 0], ONE, ONE)],
        [equation(("add", "A", "B"), ("add", "B", "A"))],
        "0 = 0",
    ),
}


@pytest.mark.parametrize("name", HIDDEN)
def test_a_needless_hypothesis_is_not_hidden(name: str) -> None:
    cofactors, given, wanted = HIDDEN[name]
    place = setting({"A": "n n", "B": "n n"})
    claim = equal("x", ("mul", "A", "B"), ("mul", "A", "B"), cofactors, *given)
    assert wanted in reasons(certificate(place, claim))["x"]


def test_an_earlier_statement_that_says_nothing_is_no_equation() -> None:
    place = setting({"A": "n n", "B": "n n"})
    nothing = equal("p", "B", "B", [])
    claim = equal("x", "A", "A", [cofactor(["statement", "p"], ONE, ONE)])
    assert "0 = 0" in reasons(certificate(place, nothing, claim))["x"]
