"""Moments of normal noises: fourth and sixth powers, the characteristic function, no guesses."""

from __future__ import annotations

import pytest
from one_of_each import further
from small_claims import check, judged

SYMBOLS = {
    "v": "{ unit = '1', variance = 's^2', distribution = 'normal', meaning = 'noise' }",
    "w": "{ unit = '1', variance = 't^2', distribution = 'normal', meaning = 'noise' }",
    "u": "{ unit = '1', variance = 'q', meaning = 'noise of any distribution' }",
    "z": "{ unit = '1', variance = 'v^2', meaning = 'noise of a random variance' }",
    "c": r"{ definition = '(r + v) \cos(a + w)', meaning = 'measured range made Cartesian' }",
}
WITHOUT = {name: text for name, text in SYMBOLS.items() if name != "z"}
TRUE = [
    "E[v^3] = 0",
    "E[v^4] = 3 s^4",
    "E[v^6] = 15 s^6",
    "E[(v + w)^4] = 3 (s^2 + t^2)^2",
    "E[v^4 u^2] = 3 s^4 q",
    "E[v u] = 0",
    further(r"E[\cos w] = e^{-t^2/2}"),
    r"E[\sin w] = 0",
    r"E[\cos 2w] = e^{-2 t^2}",
    r"E[\sin(a + w)] = e^{-t^2/2} \sin a",
    further(r"E[w \sin w] = t^2 e^{-t^2/2}"),
    r"E[w^2 \cos w] = (t^2 - t^4) e^{-t^2/2}",
    further(r"E[w^3 \sin(a + w)] = (3 t^4 - t^6) e^{-t^2/2} \cos a"),
    further(r"E[\cos^2 w] = (1 + e^{-2 t^2})/2"),
    r"E[\sin^2 w] = (1 - e^{-2 t^2})/2",
    r"E[\sin w \cos w] = 0",
    further(r"E[\cos^2 w + \sin^2 w] = 1"),
    further(r"E[\cos(v + w)] = e^{-(s^2 + t^2)/2}"),
    further(r"E[v \sin(v - w)] = s^2 e^{-(s^2 + t^2)/2}"),
    further(r"E[\cos(k w)] = e^{-k^2 t^2/2}"),
    r"E[\cos^4 w] = (3 + 4 e^{-2 t^2} + e^{-8 t^2})/8",
    further(r"E[\sin(a + w) \cos(b + w)] = \frac{1}{2} (e^{-2 t^2} \sin(a + b) + \sin(a - b))"),
    further(r"E[\sin(a + w) \sin(b + w)] = \frac{1}{2} (\cos(a - b) - e^{-2 t^2} \cos(a + b))"),
    further(r"E[\cos(a + w) \cos(b - w)] = \frac{1}{2} (\cos(a + b) + e^{-2 t^2} \cos(a - b))"),
    further(r"E[c] = r e^{-t^2/2} \cos a"),
    r"E[c^2] = \frac{1}{2} (r^2 + s^2) (1 + e^{-2 t^2} \cos 2a)",
]
FALSE = [
    "E[v^4] = s^4",
    r"E[\cos w] = e^{-t^2}",
    r"E[\cos 2w] = e^{-t^2}",
    r"E[\cos w] = 1",
    r"E[\cos^2 w] = e^{-t^2}",
    r"E[w \sin w] = -t^2 e^{-t^2/2}",
    r"E[\sin(a + w)] = e^{-t^2/2} \cos a",
    r"E[\cos(v + w)] = e^{-s^2/2} + e^{-t^2/2}",
    r"E[c^2] = \frac{1}{2} (r^2 + s^2) (1 - e^{-2 t^2} \cos 2a)",
]
LEFT_OPEN = [
    (r"E[\cos u] = e^{-q/2}", "not declared normal"),
    (r"E[\cos(w u)] = 1", "not declared normal"),
    (r"E[\cos(w^2)] = 1", "not linear"),
    (r"E[\cos(v w)] = 1", "product of noises"),
    (r"E[\tan w] = 0", "no polynomial"),
    (r"E[1/(1 + w^2)] = 1", "no polynomial"),
    ("E[u^4] = 3 q^2", "beyond its variance"),
]


@pytest.mark.parametrize("latex", TRUE)
def test_true(latex: str) -> None:
    check(judged("identity", latex, WITHOUT), "proved")


@pytest.mark.parametrize("latex", FALSE)
def test_false(latex: str) -> None:
    check(judged("identity", latex, WITHOUT), "refuted")


@pytest.mark.parametrize(("latex", "why"), LEFT_OPEN)
def test_what_is_not_known_is_not_guessed(latex: str, why: str) -> None:
    found = judged("identity", latex, WITHOUT)
    check(found, "undecided")
    assert why in found.reason


def test_a_variance_that_is_random_is_no_variance() -> None:
    found = judged("identity", "E[z^2] = v^2", SYMBOLS)
    check(found, "undecided")
    assert "random itself" in found.reason


@pytest.mark.parametrize(
    ("latex", "said"),
    [
        (r"E[\cos w] = e^{-t^2/2}", True),
        (r"E[c] = r e^{-t^2/2} \cos a", True),
        ("E[u^2] = q", False),
        ("a + b = b + a", False),
    ],
)
def test_the_theorem_on_normal_noises_is_cited_where_it_is_used(latex: str, said: bool) -> None:
    found = judged("identity", latex, WITHOUT)
    assert found.verdict == "proved"
    assert ("cited" in found.certificate) == said
