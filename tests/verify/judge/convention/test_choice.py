"""What one claim rules out counts for the others, and nothing else does."""

from __future__ import annotations

import pytest
from claim_texts import algebra, claim_file

from gainproof.verify.judge.choice import choose
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.verdict import Finding

CLAIMS = claim_file(
    algebra("'x' = { unit = '1', meaning = 'a number' }"),
    [("identity", "x = 1"), ("identity", "x = 2"), ("identity", "x = 3")],
).claims
P, R, U, C = "proved", "refuted", "undecided", "conditional"


def chosen(*verdicts: tuple[str, str]) -> list[str]:
    """Verdicts of claims whose findings under two conventions X and Y are given."""
    trials = [
        Trial(claim, {n: Finding(v, "") for n, v in zip("XY", pair, strict=True)}, (), True, 0.0)
        for claim, pair in zip(CLAIMS, verdicts, strict=False)
    ]
    return [verdict.verdict for verdict in choose(trials)]


@pytest.mark.parametrize(
    ("findings", "expected"),
    [
        # the other claim rules out Y, under which nothing is known
        ([(P, R), (R, U)], [P, R]),
        ([(P, R), (U, R)], [P, U]),
        # Y is not ruled out, only undecided
        ([(P, U), (R, U)], [P, U]),
        # no convention suits both: none is ruled out by them
        ([(P, R), (R, P), (U, R)], [C, C, U]),
        ([(P, R), (R, P), (U, U)], [C, C, U]),
        ([(P, R), (R, P), (R, R)], [C, C, R]),
        ([(P, P), (R, P)], [P, P]),
        # what holds under both is true whatever the others say
        ([(P, R), (R, P), (P, P)], [C, C, P]),
        ([(R, R)], [R]),
        ([(C, R)], [C]),
        ([(U, R)], [U]),
    ],
)
def test_choice(findings: list[tuple[str, str]], expected: list[str]) -> None:
    assert chosen(*findings) == expected
