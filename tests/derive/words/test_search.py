"""Proofs found by rewriting: what is true of random matrices may be found, what is false never is.

Statements are broken at random and given to the search; what it proves and the checker accepts has
to be true of matrices that fulfil the hypotheses. The random matrices prove nothing.
"""

from __future__ import annotations

import copy
import random
from collections.abc import Iterator
from typing import Any

import pytest
from interacting_values import update_matrices
from update_letters import (
    BEST,
    NOISE,
    PRIOR,
    SEEN,
    UPDATE,
    UPDATED,
    H,
    K,
    P,
    R,
    S,
    innovation,
)
from word_values import completed, holds, true

from gainproof.derive.words.expression import Expression, symbols
from gainproof.derive.words.hypotheses import definite, invertible, semidefinite
from gainproof.derive.words.polynomial import ShapeError
from gainproof.derive.words.rewriting import UnprovedError
from gainproof.derive.words.search import Search
from gainproof.derive.words.setting import Setting
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_invertible,
    prove_order,
)
from gainproof.verify.certificate import check

GIVEN = [PRIOR, NOISE]
FORMULAS = (
    (SEEN, UPDATED + (K - BEST) @ S @ (K - BEST).T),
    (UPDATED, (symbols("I")[0] - BEST @ H) @ P),
    (P - UPDATED, P @ H.T @ S.inverse @ H @ P),
    (BEST @ S, P @ H.T),
    (S.inverse @ H @ P @ H.T @ S.inverse, S.inverse - S.inverse @ R @ S.inverse),
)


def written(setting: Setting, statements: list[Statement]) -> dict[str, Any]:
    """A certificate of these statements."""
    return {
        "format": "gainproof certificate 1",
        "subject": "search",
        "towers": {setting.name: setting.data({"I"})},
        "programs": {},
        "statements": [
            {
                "id": s.id,
                "kind": s.kind,
                "tower": setting.name,
                "claim": {**s.claim, "given": list(s.given)},
                "evidence": s.evidence,
            }
            for s in statements
        ],
    }


def places(formula: Expression) -> Iterator[tuple[int, ...]]:
    """The path of every node."""
    yield ()
    for number, part in enumerate(formula.arguments):
        yield from ((number, *rest) for rest in places(part))


def broken(formula: Expression, place: tuple[int, ...], chooser: random.Random) -> Expression:
    """The formula with the node at that place made another."""
    if place:
        parts = list(formula.arguments)
        parts[place[0]] = broken(parts[place[0]], place[1:], chooser)
        return Expression(formula.kind, formula.value, tuple(parts))
    if formula.kind in ("transpose", "inverse", "neg"):
        return formula.arguments[0]
    if formula.kind in ("mul", "add"):
        parts = list(formula.arguments)
        chooser.shuffle(parts)
        return Expression(formula.kind, "", tuple(parts))
    if formula.kind == "number":
        return Expression("number", str(int(formula.value) + 1))
    shape = UPDATE.matrices.get(formula.value)
    letters = [name for name, other in UPDATE.matrices.items() if other == shape]
    return Expression("symbol", chooser.choice(letters)) if letters else formula.T


@pytest.mark.parametrize(
    "seed", [0, *(pytest.param(n, marks=pytest.mark.thorough) for n in range(1, 8))]
)
def test_nothing_false_is_proved(seed: int) -> None:
    chooser = random.Random(seed)
    known = innovation(UPDATE, "", R, H)
    values = [completed(UPDATE.data(), update_matrices(number, False)) for number in range(2)]
    proved = refused = 0
    for number in range(60):
        left, right = chooser.choice(FORMULAS)
        for _ in range(chooser.choice((0, 1, 1, 2))):
            place = chooser.choice([p for p in places(right) if p or chooser.random() < 0.1])
            right = broken(right, place, chooser)
        try:
            found = prove_equal(f"x{number}", Search(UPDATE, GIVEN, known), left, right)
        except (UnprovedError, ShapeError, KeyError):
            refused += 1
            continue
        proved += 1
        report = check(written(UPDATE, [*known, found]))
        result = {r.id: r for r in report.statements}[f"x{number}"]
        assert result.status == "proved", result.reason
        for entry in values:
            assert all(holds(UPDATE.data(), h, entry) for h in found.given)
            assert true(UPDATE.data(), found.kind, found.claim, entry), right
    assert proved > 5
    assert refused > 5


def test_a_claim_without_its_evidence_is_refused() -> None:
    """Broken claims under the evidence of the true ones: none is accepted unless it is true."""
    known = innovation(UPDATE, "", R, H)
    found = prove_equal("x", Search(UPDATE, GIVEN, known), *FORMULAS[0])
    data = written(UPDATE, [*known, found])
    values = completed(UPDATE.data(), update_matrices(5, False))
    chooser, accepted = random.Random(7), 0
    for _ in range(150):
        changed = copy.deepcopy(data)
        nodes = changed["statements"][-1]["claim"]["right"]["nodes"]
        node = chooser.choice([n for n in nodes if n[0] in ("mul", "add", "transpose")])
        if node[0] == "transpose":
            node[:] = ["neg", node[1]]
        else:
            node[1:] = chooser.sample(node[1:], len(node) - 1)
        result = check(changed).statements[-1]
        if result.status == "proved":
            accepted += 1
            claim = changed["statements"][-1]["claim"]
            assert true(UPDATE.data(), "matrix_equal", claim, values)
    assert 0 < accepted < 150  # sums in another order are the same


def test_only_the_hypotheses_that_are_needed_are_kept() -> None:
    setting = Setting("m", {"A": "n n", "B": "n n"})
    a, b = symbols("A B")
    found = prove_equal("x", Search(setting, [definite("A"), definite("B")]), (a @ b).T, b.T @ a)
    assert found.given == (definite("A"),)


def test_what_is_not_implied_is_not_found() -> None:
    setting = Setting("m", {"A": "n n", "B": "n n"}, inverses=("A",))
    a, b = symbols("A B")
    with pytest.raises(UnprovedError, match="left over"):
        prove_equal("x", Search(setting, [definite("A"), definite("B")]), a @ b, b @ a)
    with pytest.raises(UnprovedError, match="left over"):
        prove_equal("x", Search(setting, [invertible("A")]), a @ a.inverse @ b, b)
    with pytest.raises(UnprovedError, match="left over"):
        prove_order("x", Search(setting, [semidefinite("A")]), a, b, [Square(a, semidefinite("A"))])
    with pytest.raises(ShapeError, match="are added"):
        prove_equal("x", Search(Setting("m", {"A": "n n", "B": "n m"})), a + b, a)


def test_the_matrix_inversion_lemma_is_found() -> None:
    """(A + U C V)^-1 from A^-1, C^-1 and the small inverse: by equations from both sides."""
    setting = Setting(
        "m",
        {"A": "n n", "C": "m m", "U": "n m", "V": "m n", "small": "m m", "X": "n n"},
        units={"I": "n"},
        elements={
            "small": Expression("symbol", "C").inverse
            + symbols("V")[0] @ symbols("A")[0].inverse @ symbols("U")[0]
        },
        inverses=("A", "C", "small"),
    )
    a, c, u, v, small, unit = symbols("A C U V small I")
    given = [invertible(name) for name in ("A", "C", "small")]
    known = [
        prove_invertible(f"{name}-inverse", Search(setting, given), name, invertible(name))
        for name in ("A", "C", "small")
    ]
    inverse = a.inverse - a.inverse @ u @ small.inverse @ v @ a.inverse
    for product in ((a + u @ c @ v) @ inverse, inverse @ (a + u @ c @ v)):
        found = prove_equal("x", Search(setting, given, known, rounds=1), product, unit)
        assert set(map(str, found.given)) == set(map(str, given))
