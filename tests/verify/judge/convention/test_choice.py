"""What one claim rules out counts for the others, and nothing else does."""

from __future__ import annotations

import pytest
from claim_texts import algebra, claim_file

from gainproof.verify.judge.convention import _models
from gainproof.verify.judge.convention_choice import choose
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


def test_models_of_more_than_a_measured_position_are_not_searched() -> None:
    """They cannot have such gains: each left a false claim undecided."""
    noises = {"position": [["1"]], "position and velocity": [["1", "0"], ["0", "1"]]}
    models = [
        {"name": name, "transition": [["1", "1"], ["0", "1"]], "measurement_noise": noise}
        for name, noise in noises.items()
    ]
    fields = "kind = 'steady_state'\nmodel = '{}'\n[settings.s.symbols]"
    gain = "'a' = {{ quantity = 'filter_gain.1', meaning = 'gain' }}"
    for wanted, kept in (
        ("search", "position"),
        ("position and velocity", "position and velocity"),
    ):
        text = f"[settings.s]\ntitle = 's'\n{fields}\n{gain}\n".format(wanted)
        setting = claim_file(text, [("identity", "a = 2")]).settings["s"]
        assert [m["name"] for m in _models(setting, models)] == [kept]
