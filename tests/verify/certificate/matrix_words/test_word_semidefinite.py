"""What follows from matrices that are positive semidefinite only, and what must not."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from word_certificates import (
    ONE,
    certificate,
    cofactor,
    equal,
    graph,
    invertible,
    known,
    order,
    poly,
    reasons,
    setting,
    square,
    statement,
)

from gainproof.verify.certificate import check

Data = dict[str, Any]
Change = Callable[[Data], object]


def regular(kind: str = "semidefinite") -> Data:
    """A >= 0 with an inverse is positive definite: A x = 0 where x' A x is 0, so x = A^-1 A x."""
    place = setting({"A": "n n", "A_i": "n n"}, inverses={"A_i": "A"})
    given = known(kind, "A"), known("invertible", "A")
    inverse = cofactor(["inverse", "regular", "left"], poly("-1"), ONE)
    rank = {"left_inverses": [[0, poly("1 A_i"), "middle"]], "cofactors": [inverse]}
    return certificate(
        place,
        invertible("regular", "A", {"because": ["given", 0]}, given[1]),
        order("x", "A", "0", [square(ONE, ["given", 0])], *given, rank=rank),
    )


def test_a_semidefinite_matrix_with_an_inverse_is_definite() -> None:
    assert reasons(regular()) == {}


def _rank(data: Data) -> Any:
    return data["statements"][1]["evidence"]["rank"]


CHANGES: dict[str, tuple[Change, str]] = {
    "as if it were definite": (lambda d: _rank(d)["left_inverses"][0].pop(), "only semidefinite"),
    "another word": (
        lambda d: _rank(d)["left_inverses"][0].__setitem__(2, "outside"),
        "pairs of a number and a polynomial",
    ),
    "a word more": (
        lambda d: _rank(d)["left_inverses"][0].append("middle"),
        "pairs of a number and a polynomial",
    ),
    "without its inverse": (
        lambda d: _rank(d)["left_inverses"][0].__setitem__(1, ONE),
        "left over",
    ),
    "an inverse that is none": (lambda d: _rank(d).update(cofactors=[]), "left over"),
    "no such square": (lambda d: _rank(d)["left_inverses"][0].__setitem__(0, 1), "integer"),
    "not symmetric": (
        lambda d: d["statements"][1]["claim"]["given"].__setitem__(0, known("invertible", "A_i")),
        "is invertible, wanted",
    ),
    "symmetric only": (
        lambda d: d["statements"][1]["claim"]["given"].__setitem__(0, known("symmetric", "A")),
        "is symmetric, wanted",
    ),
    "no inverse": (
        lambda d: d["statements"][1]["claim"]["given"].pop(),
        "a hypothesis that is not given",
    ),
}


@pytest.mark.parametrize("name", CHANGES)
def test_one_step_away_is_refused(name: str) -> None:
    change, reason = CHANGES[name]
    data = regular()
    change(data)
    assert reason in reasons(data)["x"]


def test_the_middle_of_a_sum_counts_for_its_own_factor() -> None:
    """A >= 0, B >= 0 and L A + K B = I: A + B > 0. Without the second middle nothing is shown."""
    place = setting(dict.fromkeys("ABLK", "n n"), units={"I": "n"})
    whole = {
        "kind": "equal",
        "left": graph(("add", ("mul", "L", "A"), ("mul", "K", "B"))),
        "right": graph("I"),
    }
    given = known("semidefinite", "A"), known("semidefinite", "B"), whole
    squares = [square(ONE, ["given", 0]), square(ONE, ["given", 1])]
    rest = [cofactor(["given", 2], poly("-1"), ONE)]
    both = [[0, poly("1 L"), "middle"], [1, poly("1 K"), "middle"]]
    for inverses, accepted in ((both, True), (both[:1], False), ([both[0], both[1][:2]], False)):
        rank = {"left_inverses": inverses, "cofactors": rest}
        claim = order("x", ("add", "A", "B"), "0", squares, *given, rank=rank)
        assert check(certificate(place, claim)).accepted is accepted


def both_orders() -> Data:
    """A - B >= 0 and B - A >= 0: A = B."""
    place = setting(
        dict.fromkeys("ABDE", "n n"),
        elements={"D": poly("1 A", "-1 B"), "E": poly("-1 A", "1 B")},
    )
    evidence = {
        "above": ["given", 0],
        "below": ["given", 1],
        "cofactors": [cofactor(["element", "D"], poly("-1"), ONE)],
        "opposite": [
            cofactor(["element", "D"], ONE, ONE),
            cofactor(["element", "E"], ONE, ONE),
        ],
    }
    given = [known("semidefinite", "D"), known("semidefinite", "E")]
    claim = {"left": graph("A"), "right": graph("B"), "given": given}
    return certificate(place, statement("x", "matrix_equal", claim, evidence))


def test_what_is_neither_above_nor_below_is_equal() -> None:
    assert reasons(both_orders()) == {}


def _evidence(data: Data) -> Any:
    return data["statements"][0]["evidence"]


def _given(data: Data) -> Any:
    return data["statements"][0]["claim"]["given"]


SLIPS: dict[str, tuple[Change, str]] = {
    "one side twice": (lambda d: _evidence(d).update(below=["given", 0]), "left over"),
    "sides exchanged": (lambda d: _evidence(d).update(above=["given", 1]), "left over"),
    "not opposite": (lambda d: _evidence(d)["opposite"].pop(), "left over"),
    "not the difference": (lambda d: _evidence(d).update(cofactors=[]), "left over"),
    "another equation": (
        lambda d: d["statements"][0]["claim"].update(right=graph("D")),
        "left over",
    ),
    "symmetric only": (
        lambda d: _given(d).__setitem__(1, known("symmetric", "E")),
        "is symmetric, wanted",
    ),
    "one order left out": (lambda d: _given(d).pop(), "integer from 0 to 0"),
    "a field left out": (lambda d: _evidence(d).pop("opposite"), "opposite"),
    "a field more": (lambda d: _evidence(d).update(side="left"), "is missing"),
    "a unit for the order": (lambda d: _evidence(d).update(below=["unit", "n"]), "left over"),
}


@pytest.mark.parametrize("name", SLIPS)
def test_a_slip_of_both_orders_is_refused(name: str) -> None:
    change, reason = SLIPS[name]
    data = both_orders()
    change(data)
    assert reason in reasons(data)["x"]


def test_an_order_that_is_not_proved_shows_no_equation() -> None:
    """The two orders as earlier statements, of which one is false."""
    place = setting({"A": "n n"})
    orders = [
        order("above", "A", "0", [square(ONE, ["given", 0])], known("semidefinite", "A")),
        order("below", "0", "A", [square(ONE, ["given", 0])], known("semidefinite", "A")),
    ]
    evidence = {
        "above": ["statement", "above"],
        "below": ["statement", "below"],
        "cofactors": [],
        "opposite": [],
    }
    claim = {"left": graph("A"), "right": graph("0"), "given": [known("semidefinite", "A")]}
    found = reasons(certificate(place, *orders, statement("x", "matrix_equal", claim, evidence)))
    assert set(found) == {"below", "x"}


def test_the_kinds_are_still_told_apart() -> None:
    """An order is no equation and an equation no order."""
    place = setting({"A": "n n", "B": "n n"})
    same = equal("same", ("add", "A", "B"), ("add", "B", "A"), [])
    evidence = {
        "above": ["statement", "same"],
        "below": ["statement", "same"],
        "cofactors": [],
        "opposite": [],
    }
    claim = {"left": graph("A"), "right": graph("A"), "given": []}
    data = certificate(place, same, statement("x", "matrix_equal", claim, evidence))
    assert "no statement of kind matrix_order" in reasons(data)["x"]
