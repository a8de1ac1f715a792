"""What must not pass: each of these is one step away from a certificate that is accepted."""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from typing import Any

import pytest
from tests.verify.certificate.matrix_words.test_word_statements import inverse_of_a_sum
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

from gainproof.verify.certificate import check
from gainproof.verify.certificate.alteration_campaign import Campaign

Data = dict[str, Any]
Change = Callable[[Data], object]


def changed(change: Change) -> dict[str, str]:
    data = deepcopy(inverse_of_a_sum())
    change(data)
    return reasons(data)


def _evidence(data: Data, number: int) -> Any:
    return data["statements"][number]["evidence"]


def _claim(data: Data, number: int) -> Any:
    return data["statements"][number]["claim"]


def test_what_is_changed_below_is_accepted() -> None:
    assert changed(lambda _: None) == {}


CHANGES: dict[str, tuple[Change, str]] = {
    "coefficient": (
        lambda d: _evidence(d, 2)["cofactors"][1].update(left=poly("-2")),
        "left over",
    ),
    "transposed factor": (
        lambda d: _evidence(d, 3)["cofactors"][0].update(left=poly("-1 S_inverse")),
        "left over",
    ),
    "transposed equation": (
        lambda d: _evidence(d, 3)["cofactors"][1].pop("transposed"),
        "left over",
    ),
    "sides exchanged": (
        lambda d: _evidence(d, 3)["cofactors"].__setitem__(
            0, cofactor(["inverse", "inverse", "right"], ONE, poly("-1 S_inverse'"))
        ),
        "left over",
    ),
    "cofactor left out": (lambda d: _evidence(d, 2)["cofactors"].pop(), "left over"),
    "unknown field": (lambda d: _evidence(d, 2).update(note="x"), "not known here"),
    "unknown source": (
        lambda d: _evidence(d, 2)["cofactors"][0].update(source=["theorem", "S"]),
        "no source of an equation",
    ),
    "element of another letter": (
        lambda d: _evidence(d, 2)["cofactors"][0].update(source=["element", "A"]),
        "stands for nothing but itself",
    ),
    "no such hypothesis": (
        lambda d: _evidence(d, 2)["cofactors"][2].update(source=["given", 2]),
        "an integer from 0 to 1",
    ),
    "hypothesis missing": (lambda d: _claim(d, 2)["given"].pop(), "an integer from 0 to 0"),
    "hypothesis of what it rests on missing": (
        lambda d: _claim(d, 3)["given"].pop(),
        "a hypothesis that is not given",
    ),
    "needless hypothesis": (
        lambda d: _claim(d, 2)["given"].append(known("invertible", "A")),
        "not needed",
    ),
    "hypothesis twice": (
        lambda d: _claim(d, 2)["given"].append(known("definite", "B")),
        "given twice",
    ),
    "only semidefinite in a strict order": (
        lambda d: _evidence(d, 0)["rank"].update(left_inverses=[[0, ONE]]),
        "only semidefinite",
    ),
    "symmetric taken for definite": (
        lambda d: _claim(d, 0)["given"][0].update(kind="symmetric"),
        "is symmetric, wanted",
    ),
    "invertible taken for definite": (
        lambda d: _claim(d, 0)["given"][1].update(kind="invertible"),
        "is invertible, wanted",
    ),
    "semidefinite taken for invertible": (
        lambda d: _claim(d, 0).update(relation=">=") or _evidence(d, 0).pop("rank"),
        "to be shown positive definite",
    ),
    "negative weight": (
        lambda d: _evidence(d, 0)["squares"][0].update(weight=poly("-1")),
        "not positive",
    ),
    "no weight": (lambda d: _evidence(d, 0)["squares"][0].update(weight=[]), "not positive"),
    "square left out": (lambda d: _evidence(d, 0)["squares"].pop(0), "left over"),
    "order without rank": (lambda d: _evidence(d, 0).pop("rank"), "'rank' is missing"),
    "rests on a later statement": (
        lambda d: d["statements"].insert(0, d["statements"].pop(1)),
        "no earlier statement 'positive'",
    ),
    "rests on itself": (
        lambda d: _evidence(d, 1).update(because=["statement", "inverse"]),
        "no earlier statement 'inverse'",
    ),
    "rests on what is not proved": (
        lambda d: _evidence(d, 0)["squares"].pop(),
        "left over",
    ),
    "inverse of another letter": (
        lambda d: d["towers"]["main"]["inverses"].update(S_inverse="A"),
        "one letter that has one",
    ),
    "element of itself": (
        lambda d: d["towers"]["main"]["elements"].update(S=poly("1 S", "1 B")),
        "rest upon themselves",
    ),
    "element of its own inverse": (
        lambda d: d["towers"]["main"]["elements"].update(S=poly("-1 S_inverse")),
        "rest upon themselves",
    ),
    "inverse that is an element": (
        lambda d: d["towers"]["main"]["elements"].update(S_inverse=[]),
        "two meanings",
    ),
    "wrong shape": (
        lambda d: d["towers"]["main"]["matrices"].update(B=["n", "m"]),
        "are wanted",
    ),
    "letter that nobody uses": (
        lambda d: d["towers"]["main"]["matrices"].update(Z=["n", "n"]),
        "Z not used",
    ),
    "unknown kind of hypothesis": (
        lambda d: _claim(d, 0)["given"][0].update(kind="positive"),
        "is no hypothesis",
    ),
    "terms out of order": (
        lambda d: d["towers"]["main"]["elements"]["S"].reverse(),
        "ascending order",
    ),
    "a kind of towers": (
        lambda d: d["statements"][2].update(kind="equal"),
        "not decided in a setting",
    ),
}


@pytest.mark.parametrize("name", CHANGES)
def test_a_change_is_refused(name: str) -> None:
    change, wanted = CHANGES[name]
    found = changed(change)
    assert any(wanted in reason for reason in found.values()), found


def test_every_number_altered_and_every_field_deleted() -> None:
    tally = Campaign(inverse_of_a_sum()).run()
    assert tally.accepted == ()
    assert tally.unexpected == 0
    assert tally.refuted > 100


def test_shapes_are_checked_at_every_sum_and_product() -> None:
    place = setting({"A": "n n", "C": "n m"}, parameters=[{"symbol": "t", "above": "0"}])
    product = ("mul", "C", "A")
    for formula, wanted in (
        (product, "a matrix n by m is multiplied by a matrix n by n"),
        (("add", "A", "C"), "a matrix n by n and a matrix n by m are added"),
        (("add", "A", "1"), "a matrix n by n and a number are added"),
        (("div", "A", "C"), "a divisor is one term"),
        (("inverse", "A"), "the inverse of one letter that has one"),
        (("pow", "A", "2"), "powers are of numbers only"),
        ("X", "no matrix 'X'"),
    ):
        (reason,) = reasons(certificate(place, equal("x", formula, formula, []))).values()
        assert wanted in reason


def test_sizes_of_different_names_are_different() -> None:
    place = setting({"A": "n n", "B": "m m"})
    (reason,) = reasons(certificate(place, equal("x", "A", "B", []))).values()
    assert "two matrices of one shape" in reason


def test_an_inverse_has_to_be_shown() -> None:
    """Nothing says that A can be inverted."""
    names = {"A": "n n", "A_i": "n n"}
    place = setting(names, units={"I": "n"}, inverses={"A_i": "A"})
    formula = ("mul", "A", ("inverse", "A"))
    source = cofactor(["inverse", "y", "right"], ONE, ONE)
    claim = equal("x", formula, "I", [source])
    assert "no earlier statement 'y'" in reasons(certificate(place, claim))["x"]
    symmetric = known("symmetric", "A")
    shown = invertible("y", "A", {"because": ["given", 0]}, symmetric)
    found = reasons(certificate(place, shown, equal("x", formula, "I", [source], symmetric)))
    assert "wanted ('invertible', 'definite')" in found["y"]
    assert "wanted ('invertible', 'definite')" in found["x"]


def test_blocks_make_no_contradiction() -> None:
    """Blocks of a size that is a number, or of each other, need not exist."""
    for matrices, blocks in (
        ({"E": "2 1"}, {"2": ["E"]}),
        ({"E": "s d", "G": "d s"}, {"s": ["E"], "d": ["G"]}),
        ({"E": "s d", "G": "n d"}, {"s": ["E", "G"]}),
        ({"E": "s d"}, {"s": ["E", "E"]}),
    ):
        data = certificate(setting(matrices, blocks=blocks), equal("x", "E", "E", []))
        assert "" in reasons(data)


def test_what_a_statement_says_is_used_as_what_it_is() -> None:
    """An order, a trace, a definition and words are no equation, an equation is no order."""
    place = setting({"A": "n n", "B": "n n"})
    known_a = known("semidefinite", "A")
    ordered = order("order", "A", "0", [square(ONE, ["given", 0])], known_a)
    sides = {"left": graph(("mul", "A", "B")), "right": graph(("mul", "B", "A")), "given": []}
    trace = statement("trace", "matrix_trace", sides, {"used": []})
    words = statement("words", "definition", {"text": "A is zero"}, {})
    cited = statement("cited", "cited", {"theorem": "A B = B A", "reference": "nobody"}, {})
    for name in ("order", "trace", "words", "cited"):
        source = cofactor(["statement", name], ONE, ONE)
        claim = equal("x", ("mul", "A", "B"), ("mul", "B", "A"), [source], known_a)
        reason = reasons(certificate(place, ordered, trace, words, cited, claim))["x"]
        assert "matrix_equal" in reason or "no matrix statement" in reason
    same = equal("same", "A", "A", [])
    claim = order("x", "B", "0", [square(ONE, ["statement", "same"])])
    assert "no statement of kind matrix_order" in reasons(certificate(place, same, claim))["x"]


def test_a_definition_is_one_of_the_setting() -> None:
    place = setting({"A": "n n", "S": "n n"}, elements={"S": poly("2 A")})
    for left, right in (("A", "0"), ("S", "A"), ("S", ("mul", "A", "A"))):
        claim = {"left": graph(left), "right": graph(right)}
        data = certificate(place, statement("x", "definition", claim, {}), equal("y", "S", "S", []))
        assert "no such element" in reasons(data)["x"]


def test_a_parameter_that_may_vanish_divides_nothing() -> None:
    place = setting({"A": "n n"}, parameters=[{"symbol": "z", "any": "real"}])
    (reason,) = reasons(certificate(place, equal("x", ("div", "A", "z"), "A", []))).values()
    assert "may vanish" in reason
    claim = order(
        "x",
        ("mul", "z", "z", "A"),
        "0",
        [square(ONE, ["given", 0], [["1", [2], []]])],
        known("definite", "A"),
        rank={"left_inverses": [[0, [["1", [0], []]]]], "cofactors": []},
    )
    claim["evidence"]["squares"][0]["factor"] = [["1", [0], []]]
    (reason,) = reasons(certificate(place, claim)).values()
    assert "not positive" in reason


def test_a_definite_matrix_in_the_middle_needs_to_be_strict() -> None:
    """N' D N = 0 with D only semidefinite says nothing of N."""
    place = setting({"N": "n m", "D": "n n"})
    zero = equation(("mul", ("transpose", "N"), "D", "N"), "0")
    evidence = {
        "cofactors": [cofactor(["given", 0], ONE, ONE)],
        "definite": ["given", 1],
        "side": "left",
    }
    claim = {"left": graph("N"), "right": graph("0"), "given": [zero, known("semidefinite", "D")]}
    found = reasons(certificate(place, statement("x", "matrix_equal", claim, evidence)))
    assert "not positive definite" in found["x"]


def test_kinds_of_matrices_are_refused_in_towers() -> None:
    tower = {"parameters": [{"symbol": "x", "above": "0"}], "generators": [], "elements": {}}
    (reason,) = reasons(certificate(tower, equal("y", "x", "x", []))).values()
    assert "a setting of matrices is wanted" in reason


def test_what_grows_without_end_is_given_up() -> None:
    """Squares of squares, in sums, in words and in numbers."""
    place = setting({"A": "n n", "B": "n n"}, parameters=[{"symbol": "t", "above": "0"}])
    for first in (["add", 0, 1], ["mul", 0, 1]):
        nodes: list[list[Any]] = [["symbol", "A"], ["symbol", "B"], first]
        nodes += [["mul", i, i] for i in range(2, 60)]
        long = {"nodes": nodes, "outputs": {"value": len(nodes) - 1}}
        claim = statement("x", "matrix_equal", {"left": long, "right": long, "given": []}, {})
        assert "more than" in reasons(certificate(place, claim))["x"]
    numbers: list[list[Any]] = [["number", "3"], *[["mul", i, i] for i in range(60)]]
    data = {"nodes": numbers, "outputs": {"value": len(numbers) - 1}}
    claim = statement("x", "matrix_equal", {"left": data, "right": data, "given": []}, {})
    assert "too many digits" in reasons(certificate(place, claim))["x"]


def test_what_is_expected_is_compared() -> None:
    """Another setting under the same claims is not what was asked for."""
    data = inverse_of_a_sum()
    claims = [{key: s[key] for key in ("id", "kind", "tower", "claim")} for s in data["statements"]]
    expected = {"claims": claims, "towers": deepcopy(data["towers"])}
    assert check(data, **expected).accepted
    other = deepcopy(data)
    other["towers"]["main"]["matrices"] = {name: ["m", "m"] for name in ("A", "B", "S")}
    other["towers"]["main"]["matrices"]["S_inverse"] = ["m", "m"]
    assert check(other).accepted
    assert not check(other, **expected).accepted
