"""Each kind of matrix statement, accepted for the reasons that its rule gives."""

from __future__ import annotations

import re
from typing import Any

import pytest
from word_certificates import (
    ONE,
    certificate,
    cofactor,
    equal,
    equation,
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

from gainproof.verify.certificate import check, check_statement

Data = dict[str, Any]
SQUARE = setting({"A": "n n", "B": "n n", "C": "n m"})


def test_the_transpose_of_a_product_turns_it_round() -> None:
    left = ("transpose", ("mul", "A", "C"))
    right = ("mul", ("transpose", "C"), ("transpose", "A"))
    place = setting({"A": "n n", "C": "n m"})
    assert check(certificate(place, equal("x", left, right, []))).accepted


def test_products_do_not_commute() -> None:
    place = setting({"A": "n n", "B": "n n"})
    data = certificate(place, equal("x", ("mul", "A", "B"), ("mul", "B", "A"), []))
    assert reasons(data) == {"x": "x.evidence: 2 terms are left over"}


def test_products_commute_by_hypothesis() -> None:
    place = setting({"A": "n n", "B": "n n"})
    swap = equation(("mul", "A", "B"), ("mul", "B", "A"))
    cofactors = [
        cofactor(["given", 0], poly("1 A"), ONE),
        cofactor(["given", 0], ONE, poly("1 A")),
    ]
    claim = equal("x", ("mul", "A", "A", "B"), ("mul", "B", "A", "A"), cofactors, swap)
    assert check(certificate(place, claim)).accepted


def test_numbers_and_parameters_commute_with_everything() -> None:
    place = setting(
        {"A": "n n"}, parameters=[{"symbol": "t", "above": "0"}, {"symbol": "z", "any": "real"}]
    )
    left = ("div", ("mul", "A", "z", ("add", "t", "2"), "A", ("pow", "t", "2")), ("mul", "2", "t"))
    right = ("mul", "t", "z", ("add", ("mul", "1/2", "t"), "1"), "A", "A")
    assert check(certificate(place, equal("x", left, right, []))).accepted


def inverse_of_a_sum() -> Data:
    """B > 0 and A >= 0: S = A + B is positive definite, invertible, its inverse symmetric."""
    place = setting(
        {"A": "n n", "B": "n n", "S": "n n", "S_inverse": "n n"},
        elements={"S": poly("1 A", "1 B")},
        inverses={"S_inverse": "S"},
    )
    given = known("semidefinite", "A"), known("definite", "B")
    element = cofactor(["element", "S"], ONE, ONE)
    squares = [square(ONE, ["given", 0]), square(ONE, ["given", 1])]
    rank = {"left_inverses": [[1, ONE]], "cofactors": []}
    symmetric = [
        cofactor(["element", "S"], ONE, ONE, turned=True),
        cofactor(["element", "S"], poly("-1"), ONE),
        cofactor(["given", 0], ONE, ONE),
        cofactor(["given", 1], ONE, ONE),
    ]
    turned = [
        cofactor(["inverse", "inverse", "right"], poly("-1 S_inverse'"), ONE),
        cofactor(["inverse", "inverse", "right"], ONE, poly("1 S_inverse"), turned=True),
        cofactor(["statement", "symmetric"], poly("-1 S_inverse'"), poly("1 S_inverse")),
    ]
    return certificate(
        place,
        order("positive", "S", "0", squares, *given, cofactors=[element], rank=rank),
        invertible("inverse", "S", {"because": ["statement", "positive"]}, *given),
        equal("symmetric", ("transpose", "S"), "S", symmetric, *given),
        equal("turned", ("transpose", ("inverse", "S")), ("inverse", "S"), turned, *given),
    )


def test_a_sum_of_definite_matrices_has_a_symmetric_inverse() -> None:
    data = inverse_of_a_sum()
    assert reasons(data) == {}
    # one statement alone: those that it rests on are decided with it
    assert check_statement(data, "turned").status == "proved"


def test_the_order_of_inverses_needs_no_rule_of_its_own() -> None:
    """A >= B > 0: B^-1 - A^-1 = (B^-1 - A^-1) B (B^-1 - A^-1) + A^-1 (A - B) A^-1."""
    names = {"A": "n n", "B": "n n", "D": "n n", "A_i": "n n", "B_i": "n n"}
    place = setting(names, elements={"D": poly("1 A", "-1 B")}, inverses={"A_i": "A", "B_i": "B"})
    above, below = known("definite", "A"), known("definite", "B")
    difference = known("semidefinite", "D")
    symmetric = [
        (f"{name}-turned", f"{name}_i", name, number) for number, name in enumerate(("A", "B"))
    ]
    statements = [
        invertible("A-inverse", "A", {"because": ["given", 0]}, above),
        invertible("B-inverse", "B", {"because": ["given", 0]}, below),
    ]
    for title, inverse, base, number in symmetric:
        source = ["inverse", f"{base}-inverse", "right"]
        cofactors = [
            cofactor(source, poly(f"-1 {inverse}'"), ONE),
            cofactor(source, ONE, poly(f"1 {inverse}"), turned=True),
            cofactor(["given", 0], poly(f"-1 {inverse}'"), poly(f"1 {inverse}")),
        ]
        formula = ("transpose", ("inverse", base)), ("inverse", base)
        statements.append(equal(title, *formula, cofactors, (above, below)[number]))
    # both factors are symmetric once their turned letters are replaced
    gap = poly("1 A_i", "-1 B_i")
    squares = [square(gap, ["given", 1]), square(poly("1 A_i"), ["given", 2])]
    left = poly("-1 B B_i", "1 B A_i")
    cofactors = [
        cofactor(["statement", "B-turned"], ONE, left),
        cofactor(["statement", "A-turned"], poly("-1"), left),
        cofactor(["inverse", "B-inverse", "right"], poly("-1 B_i", "1 A_i"), ONE),
        cofactor(["inverse", "B-inverse", "left"], ONE, poly("1 A_i")),
        cofactor(["statement", "A-turned"], poly("-1"), poly("1 D A_i")),
        cofactor(["element", "D"], poly("-1 A_i"), poly("1 A_i")),
        cofactor(["inverse", "A-inverse", "left"], poly("-1"), poly("1 A_i")),
    ]
    claim = order(
        "x",
        ("inverse", "B"),
        ("inverse", "A"),
        squares,
        above,
        below,
        difference,
        cofactors=cofactors,
    )
    assert reasons(certificate(place, *statements, claim)) == {}


def test_a_schur_complement_is_a_square() -> None:
    """M >= 0 of blocks: E2' M E2 - 2 terms + ... = F' M F with F = E2 - E1 X."""
    place = setting({"E": "s d", "G": "s d", "M": "s s", "X": "d d"}, blocks={"s": ["E", "G"]})
    factor = ("add", "G", ("neg", ("mul", "E", "X")))
    claim = order(
        "x",
        ("mul", ("transpose", factor), "M", factor),
        "0",
        [square(poly("-1 G", "1 E X"), ["given", 0])],
        known("semidefinite", "M"),
    )
    assert check(certificate(place, claim)).accepted


def test_blocks_are_the_unit_matrix() -> None:
    place = setting(
        {"E": "s d", "G": "s d", "M": "s s"}, units={"I": "d", "J": "s"}, blocks={"s": ["E", "G"]}
    )
    inside = equal(
        "inside",
        ("mul", ("transpose", "E"), "E"),
        "I",
        [cofactor(["blocks", "s", 0, 0], ONE, ONE)],
    )
    beside = equal(
        "beside",
        ("mul", ("transpose", "E"), "G"),
        "0",
        [cofactor(["blocks", "s", 0, 1], ONE, ONE)],
    )
    both = ("add", ("mul", "E", ("transpose", "E")), ("mul", "G", ("transpose", "G")))
    whole = equal(
        "whole",
        ("mul", both, "M"),
        ("mul", "J", "M"),
        [cofactor(["blocks", "s"], ONE, poly("1 M"))],
    )
    assert check(certificate(place, inside, beside, whole)).accepted


def test_what_vanishes_between_a_definite_matrix_is_zero() -> None:
    place = setting({"A": "n m", "B": "n m", "D": "n n"})
    gap = ("add", "A", ("neg", "B"))
    zero = equation(("mul", ("transpose", gap), "D", gap), "0")
    evidence = {
        "cofactors": [cofactor(["given", 0], ONE, ONE)],
        "definite": ["given", 1],
        "side": "left",
    }
    claim = {"left": graph("A"), "right": graph("B"), "given": [zero, known("definite", "D")]}
    assert check(certificate(place, statement("x", "matrix_equal", claim, evidence))).accepted


def semidefinite_product(factor: Any, kind: str = "semidefinite") -> Data:
    """D K = 0 since K' D K = 0, by a factor that is K."""
    place = setting({"K": "n m", "D": "n n"})
    zero = equation(("mul", ("transpose", "K"), "D", "K"), "0")
    evidence = {
        "cofactors": [cofactor(["given", 0], ONE, ONE)],
        "definite": ["given", 1],
        "side": "left",
        "factor": factor,
        "rest": [],
    }
    claim = {
        "left": graph(("mul", "D", "K")),
        "right": graph("0"),
        "given": [zero, known(kind, "D")],
    }
    return certificate(place, statement("x", "matrix_equal", claim, evidence))


def test_what_vanishes_beside_a_semidefinite_matrix() -> None:
    assert check(semidefinite_product(poly("1 K"))).accepted


@pytest.mark.parametrize(
    ("factor", "kind", "reason"),
    [
        (poly("-1 K"), "semidefinite", "left over"),
        (poly("2 K"), "semidefinite", "left over"),
        ([], "semidefinite", "left over"),
        (poly("1 D", "1 K"), "semidefinite", "shape|columns|rows"),
        (poly("1 K"), "symmetric", "definite"),
    ],
)
def test_another_factor_is_refused_beside_it(factor: Any, kind: str, reason: str) -> None:
    assert re.search(reason, reasons(semidefinite_product(factor, kind))["x"])


def test_what_a_semidefinite_matrix_multiplies_need_not_vanish() -> None:
    """Of K' D K = 0 it follows that D K is 0, not that K is; and K' D K = 0 has to be shown."""
    data = semidefinite_product(poly("1 K"))
    data["statements"][0]["claim"]["left"] = graph("K")
    assert "left over" in reasons(data)["x"]
    data = semidefinite_product(poly("1 K"))
    data["statements"][0]["evidence"]["cofactors"] = []
    assert "not shown to vanish" in reasons(data)["x"]
    data = semidefinite_product(poly("1 K"))
    del data["statements"][0]["evidence"]["rest"]
    assert "rest" in reasons(data)["x"]


def test_a_left_inverse_is_enough_for_a_square_matrix() -> None:
    place = setting({"A": "n n", "L": "n n"}, units={"I": "n"})
    left = equation(("mul", "L", "A"), "I")
    evidence = {"left_inverse": poly("1 L"), "cofactors": [cofactor(["given", 0], poly("-1"), ONE)]}
    assert check(certificate(place, invertible("x", "A", evidence, left))).accepted


def test_full_column_rank_keeps_definite() -> None:
    place = setting({"A": "n m", "D": "n n"})
    given = known("definite", "D"), known("full_column_rank", "A")
    formula = ("mul", ("transpose", "A"), "D", "A")
    rank = {"square": 0, "given": 1}
    claim = order("x", formula, "0", [square(poly("1 A"), ["given", 0])], *given, rank=rank)
    assert check(certificate(place, claim)).accepted


def test_traces_turn_round_and_over() -> None:
    place = setting({"A": "n m", "B": "m n"})

    def claim(left: Any, right: Any) -> Data:
        sides = {"left": graph(left), "right": graph(right), "given": []}
        return statement("x", "matrix_trace", sides, {"used": []})

    turned = claim(("mul", "A", "B"), ("mul", "B", "A"))
    over = claim(("mul", "A", "B"), ("mul", ("transpose", "A"), ("transpose", "B")))
    false = claim(("mul", "A", "B", "A", "B"), ("mul", "A", "B"))
    assert check(certificate(place, turned)).accepted
    assert check(certificate(place, over)).accepted
    assert reasons(certificate(place, false)) == {"x": "x.evidence: 2 terms are left over"}


def test_a_number_is_its_own_transpose() -> None:
    place = setting({"u": "n 1", "A": "n n"})
    number = poly("1 u' A u")
    formula = ("mul", ("transpose", "u"), "A", "u")
    claim = equal("x", formula, ("transpose", formula), [cofactor(["number", number], ONE, ONE)])
    assert check(certificate(place, claim)).accepted


@pytest.mark.parametrize("text", ["definition", "cited"])
def test_words_and_definitions_are_what_they_are(text: str) -> None:
    place = setting({"A": "n n", "S": "n n"}, elements={"S": poly("1 A", "1 A'")})
    meaning = {"left": graph("S"), "right": graph(("add", "A", ("transpose", "A")))}
    proof = [
        cofactor(["element", "S"], ONE, ONE, turned=True),
        cofactor(["element", "S"], poly("-1"), ONE),
    ]
    said = {"definition": {"text": "A: anything"}, "cited": {"theorem": "x", "reference": "y"}}
    statements = [
        statement("means", "definition", meaning, {}),
        statement("said", text, said[text], {}),
        equal("x", ("transpose", "S"), "S", proof),
    ]
    report = check(certificate(place, *statements))
    assert report.accepted
    assert [result.status for result in report.statements] == ["definition", text, "proved"]
