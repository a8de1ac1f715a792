"""Numbers before matrices of any size, against NumPy where they are drawn."""

from __future__ import annotations

import random
from collections.abc import Mapping

import numpy as np
import pytest
from samples import samples

from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.matrices.decision import decide
from gainproof.verify.judge.verdict import Finding

HEAD = """
format = "gainproof claims 1"
[source]
title = "trial"
[settings.s]
title = "trial"
kind = "matrices"
sizes = ["n", "m"]
[settings.s.symbols]
"""
COVARIANCE = "is = ['positive definite'], meaning = 'covariance' }"
LETTERS = {
    **dict.fromkeys("PQ", f"{{ shape = ['n', 'n'], {COVARIANCE}"),
    "R": f"{{ shape = ['m', 'm'], {COVARIANCE}",
    "N": "{ shape = ['n', 'n'], is = ['positive semidefinite'], meaning = 'noise' }",
    "H": "{ shape = ['m', 'n'], meaning = 'measurement' }",
    **dict.fromkeys("BC", "{ shape = ['n', 'n'], meaning = 'any' }"),
    **dict.fromkeys("xy", "{ shape = ['n', '1'], meaning = 'column' }"),
    **dict.fromkeys("st", "{ shape = ['1', '1'], is = ['positive definite'], meaning = 'scale' }"),
    "w": "{ shape = ['1', '1'], meaning = 'weight' }",
    "V": "{ shape = ['n', 'n'], definition = 's P', meaning = 'scaled' }",
    "v": "{ shape = ['1', '1'], definition = '1 - w', meaning = 'the other weight' }",
}


def found(kind: str, latex: str, letters: Mapping[str, str] = LETTERS) -> Finding:
    table = "".join(f"'{name}' = {entry}\n" for name, entry in letters.items())
    claim = (
        f"[[claims]]\nid = '1'\nplace = '-'\nkind = '{kind}'\nsetting = 's'\nlatex = '{latex}'\n"
    )
    file = read_claim_text(HEAD + table + claim, "trial.toml")
    matrices, asked = file.settings["s"].matrices, file.claims[0].matrices
    assert matrices is not None
    assert asked is not None
    return decide(asked, matrices)


@pytest.mark.alike
@pytest.mark.parametrize(
    ("kind", "latex"),
    [
        ("identity", "(s P)^{-1} = s^{-1} P^{-1}"),
        ("identity", "(s t P)^{-1} = t^{-1} s^{-1} P^{-1}"),
        ("identity", "H s P H^T = s H P H^T"),
        ("identity", "x^T s P y = s x^T P y"),
        ("identity", "x s = s x"),
        ("identity", "w P + (1 - w) Q = Q + w (P - Q)"),
        ("identity", "w P + v P = P"),
        ("identity", "s B C w = w B s C"),
        ("identity", "(s P + t P)^{-1} = (s + t)^{-1} P^{-1}"),
        ("identity", "s P H^T (H s P H^T + s R)^{-1} = P H^T (H P H^T + R)^{-1}"),
        ("identity", "V^{-1} = s^{-1} P^{-1}"),
        # least squares with forgetting
        ("identity", "(s P^{-1} + x x^T)^{-1} = s^{-1} (P - P x (s + x^T P x)^{-1} x^T P)"),
        ("identity", "s P x (x^T s P x + s)^{-1} = P x (x^T P x + 1)^{-1}"),
        (
            "identity",
            r"(s P^{-1} + x x^T)^{-1} = \frac{1}{s} \left(P - \frac{P x x^T P}{s + x^T P x}\right)",
        ),
        (
            "identity",
            r"(P + x x^T)^{-1} = P^{-1} - \frac{P^{-1} x x^T P^{-1}}{1 + x^T P^{-1} x}",
        ),
        ("identity", r"(P + x x^T)^{-1} x = \frac{P^{-1} x}{1 + x^T P^{-1} x}"),
        ("identity", r"\frac{s}{t} P = s t^{-1} P"),
        ("identity", "(s P)^3 = s^3 P P P"),
        ("inequality", "s P > 0"),
        ("inequality", r"s P + Q \geq Q"),
        ("inequality", r"s N \geq 0"),
    ],
)
def test_what_is_true_is_proved(kind: str, latex: str) -> None:
    finding = found(kind, latex)
    assert finding.verdict == "proved", finding.reason


@pytest.mark.alike
@pytest.mark.parametrize(
    ("kind", "latex"),
    [
        ("identity", "(s P)^{-1} = s P^{-1}"),
        ("identity", "(s P)^{-1} = t^{-1} P^{-1}"),
        ("identity", "H s P H^T = s s H P H^T"),
        ("identity", "s B C = C s B"),
        ("identity", "w P + (1 - w) Q = Q + w (P + Q)"),
        ("identity", "s P H^T (H s P H^T + R)^{-1} = P H^T (H P H^T + R)^{-1}"),
        ("identity", "(s P^{-1} + x x^T)^{-1} = s^{-1} (P - P x (1 + x^T P x)^{-1} x^T P)"),
        (
            "identity",
            r"(s P^{-1} + x x^T)^{-1} = \frac{1}{s} \left(P + \frac{P x x^T P}{s + x^T P x}\right)",
        ),
        ("identity", r"\frac{s}{t} P = s t P"),
        ("identity", "(s P)^2 = s P^2"),
        ("identity", "w P = 0"),
        ("inequality", "w P > 0"),
        ("inequality", "s N > 0"),
        ("inequality", r"s P \geq P"),
    ],
)
def test_what_is_false_is_refuted_with_the_number(kind: str, latex: str) -> None:
    finding = found(kind, latex)
    assert finding.verdict == "refuted", finding.reason
    assert finding.witness is not None
    assert {"s", "w", "t"} & set(finding.witness.point)


def test_an_inverse_needs_a_number_that_is_not_zero() -> None:
    finding = found("identity", "(w P)^{-1} = w^{-1} P^{-1}")
    assert finding.verdict == "conditional"
    assert "w has an inverse" in (finding.domain or "")


def test_a_fraction_is_over_a_number() -> None:
    finding = found("identity", r"\frac{B}{P} = B P^{-1}")
    assert (finding.verdict, finding.method) == ("refuted", "shapes")
    assert "a fraction over a matrix of shape n x n" in finding.reason
    finding = found("identity", r"\frac{x x^T}{x^T x} x = x")
    assert finding.verdict == "conditional", finding.reason


def test_what_is_no_letter_before_a_matrix_is_not_read() -> None:
    finding = found("identity", "x^T y P = P x^T y")
    assert finding.verdict == "undecided"
    assert "only letters" in finding.reason


@pytest.mark.sampled
@pytest.mark.parametrize("seed", range(samples(8)))
def test_numbers_may_stand_anywhere_in_a_product(seed: int) -> None:
    source = random.Random(seed)
    values = np.random.default_rng(seed)
    at = {name: values.normal(size=(3, 3)) for name in "BCPQ"}
    at |= {name: values.uniform(2, 3, size=(1, 1)) for name in "stw"}
    at["x"] = values.normal(size=(3, 1))
    word = source.choices("BC", k=source.randint(1, 3)) + source.choice([[], ["x"]])
    numbers = source.choices("stw", k=source.randint(1, 3))

    def spread(numbers: list[str]) -> list[str]:
        found = list(word)
        for number in numbers:
            found.insert(source.randint(0, len(found)), number)
        return found

    def value(factors: list[str]) -> np.ndarray:
        total = np.eye(3)
        for factor in factors:
            own = at[factor]
            total = total * own[0, 0] if own.size == 1 else total @ own
        return total

    left, right = spread(numbers), spread(source.sample(numbers, len(numbers)))
    other = spread([*numbers[1:], source.choice("stw")])
    for side in (right, other):
        verdict = found("identity", f"{' '.join(left)} = {' '.join(side)}").verdict
        assert verdict == ("proved" if np.allclose(value(left), value(side)) else "refuted")


def test_numbers_that_double_with_every_definition_take_no_time() -> None:
    names = [f"a_{{{k}}}" for k in range(60)]
    more = {
        name: f"{{ shape = ['1', '1'], definition = '{before} - {before} + s', meaning = 'twice' }}"
        for before, name in zip(["s", *names], names, strict=False)
    }
    assert found("identity", f"{names[-1]} P = s P", LETTERS | more).verdict == "proved"
