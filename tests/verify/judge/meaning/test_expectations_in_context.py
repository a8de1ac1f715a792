"""What stands round an expectation: arguments, indices, hypotheses, variances that are none."""

from __future__ import annotations

import pytest
from small_claims import check, judged

from gainproof.verify.judge.claim.errors import ClaimFileError

SYMBOLS = {
    "s": "{ unit = '1', domain = 's > 0', meaning = 'deviation' }",
    "w": "{ unit = '1', variance = 's^2', distribution = 'normal', meaning = 'noise' }",
    "v": "{ unit = '1', variance = 't^2', distribution = 'normal', meaning = 'noise' }",
    "u": "{ unit = '1', variance = 'i', meaning = 'noise' }",
    "w_k": "{ unit = '1', variance = '1', meaning = 'noise' }",
    "w_j": "{ unit = '1', variance = '1', meaning = 'noise' }",
    "w_{k-1}": "{ unit = '1', variance = '1', meaning = 'noise' }",
    "m": "{ unit = '1', variance = 'q', meaning = 'noise' }",
    "b": "{ unit = '1', variance = '-s^2', meaning = 'noise' }",
    "z": "{ unit = '1', variance = '1/x', meaning = 'noise' }",
    "l": "{ unit = '1', variance = 'E[v^2]', meaning = 'noise' }",
    "f": r"{ arguments = ['s'], definition = 'E[\cos w]', meaning = 'mean' }",
    "g": "{ arguments = ['s'], definition = 'E[w^2]', meaning = 'mean' }",
    "c": "{ definition = 'E[w^2]', meaning = 'mean' }",
    "h": "{ arguments = ['s'], definition = 'c', meaning = 'mean' }",
    "a": "{ arguments = ['x'], definition = 'E[(x - v)^2]', meaning = 'mean' }",
}
TRUE = [
    "g(3) = 9",
    "g(2) = 4",
    "h(2) = 4",
    r"\frac{d}{dx} g(x) = 2 x",
    r"\int_0^1 E[w^2] ds = \frac{1}{3}",
    r"\sum_{i=1}^{3} E[u^2] = 6",
    r"\prod_{i=1}^{3} E[u^2] = 6",
    "E[w_k w_{k-1}] = 0",
    "E[m^2] = q",
    r"a(3) = 9 + t^2",
]
NOT_PROVED = [
    "f(1) = f(2)",
    "g(3) = s^2",
    "g(2) = g(3)",
    "h(2) = s^2",
    r"\frac{d}{dx} g(x) = 0",
    r"\int_0^1 E[w^2] ds = s^2",
    r"\sum_{i=1}^{3} E[u^2] = 3 i",
    r"\prod_{i=1}^{3} E[u^2] = i^3",
    "E[w_k w_j] = 0",
    "a(v) = v^2 + t^2",
    r"\left. E[x v] \right|_{x=v} = 0",
    r"\frac{d}{dw} E[w^2] = 0",
    "E[b^2] = -s^2",
    "E[b] = 0",
    "E[l^2] = t^2",
    "E[w/0] = 0",
    r"E[\sqrt{-1} w] = 0",
    r"E[\frac{1}{0} \sin w] = 0",
    "E[w v] = w v",
]
FIELDS = [
    ("identity", "latex = 'E[w v] = 0'\ngiven = ['w = v']"),
    ("identity", "latex = 'E[w] = 0'\ngiven = ['w > 0']"),
    ("identity", "latex = 'E[w] = 0'\ndomain = 'w > 0'"),
    ("implication", r"latex = 'w = v \Rightarrow E[w v] = 0'"),
    ("limit", r"latex = 'E[x w + w^2] \to s^2 \quad (x \to w)'"),
    ("inequality", "latex = 'E[m^2] < 0'\ndomain = 'q < 0'"),
    ("inequality", r"latex = 'E[b^2] \leq 0'"),
]


@pytest.mark.parametrize("latex", TRUE)
def test_true(latex: str) -> None:
    check(judged("identity", latex, SYMBOLS), "proved")


@pytest.mark.parametrize("latex", NOT_PROVED)
def test_false_or_without_meaning(latex: str) -> None:
    found = judged("identity", latex, SYMBOLS)
    assert found.verdict in ("refuted", "undecided"), found.reason


@pytest.mark.parametrize(("kind", "fields"), FIELDS)
def test_hypotheses_on_noises_are_none(kind: str, fields: str) -> None:
    found = judged(kind, fields, SYMBOLS)
    assert found.verdict in ("refuted", "undecided"), found.reason


@pytest.mark.parametrize(
    "latex", [r"E[w \sqrt{x}] = 0", "E[w/x] = 0", r"E[\sqrt{x} \sin w] = 0", "E[z] = 0"]
)
def test_a_term_of_mean_0_still_needs_its_value(latex: str) -> None:
    found = judged("identity", f"latex = '{latex}'\ndomain = 'x < 1'", SYMBOLS)
    assert found.verdict != "proved"
    check(judged("identity", f"latex = '{latex}'\ndomain = 'x > 0'", SYMBOLS), "proved")


def test_a_variance_is_at_least_0() -> None:
    check(judged("inequality", r"E[m^2] \geq 0", SYMBOLS), "proved")


@pytest.mark.parametrize("field", ["domain = 'n > 0'", "integer = true", "shape = [2, 1]"])
def test_a_noise_is_any_number(field: str) -> None:
    noise = f"{{ unit = '1', variance = 's^2', {field}, meaning = 'noise' }}"
    with pytest.raises(ClaimFileError, match="a noise is any real number"):
        judged("identity", "E[n] = 0", {**SYMBOLS, "n": noise})


def test_a_variance_has_the_dimension_of_a_square() -> None:
    units = "{{ unit = 'm', variance = '{}', meaning = 'noise' }}"
    length = {"p": "{ unit = 'm', meaning = 'deviation' }"}
    check(judged("identity", "E[n^2] = p^2", {**length, "n": units.format("p^2")}), "proved")
    with pytest.raises(ClaimFileError, match="the square of n and its variance"):
        judged("identity", "E[n^2] = p", {**length, "n": units.format("p")})
