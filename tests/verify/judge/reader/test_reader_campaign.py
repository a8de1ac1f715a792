"""A sample of the campaign that fuzzes the readers: formulas of the repository broken and spliced,
and a hundred claim files.
"""

from __future__ import annotations

from random import Random

import pytest
import reader_campaign
from fuzz_tally import Tally
from reader_campaign import corpus, fuzz_files, fuzz_formulas, fuzz_made, random_formula
from samples import samples

SECONDS_EACH = 10.0
"""A busy machine may take so long for the longest input; one that hangs takes longer."""


@pytest.mark.sampled
def test_formulas() -> None:
    tally = fuzz_formulas(20, samples(500))
    assert tally.inputs == samples(500)
    assert tally.crashes == []
    assert tally.seconds < SECONDS_EACH, tally.slowest
    # a fuzz that reads little tests the lexer only
    assert tally.read > tally.inputs // 20


@pytest.mark.sampled
def test_made_formulas() -> None:
    tally = fuzz_made(20, samples(250))
    assert tally.crashes == []
    assert 0 < tally.read < tally.inputs


@pytest.mark.sampled
def test_claim_files() -> None:
    tally = fuzz_files(20, samples(30))
    assert tally.crashes == []
    assert tally.seconds < SECONDS_EACH, tally.slowest
    assert tally.read > tally.inputs // 20


def test_the_same_seed_gives_the_same_inputs() -> None:
    one, other = ([random_formula(Random(3))[0] for _ in range(5)] for _ in range(2))
    assert one == other
    assert len(corpus()) > 100


def test_a_crash_is_counted_and_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(text: str, _: object) -> None:
        raise KeyError(text)

    monkeypatch.setattr(reader_campaign, "read_formula", broken)
    tally = fuzz_formulas(1, 50)
    assert len(tally.crashes) > 20
    assert tally.crashes[0][1].startswith("KeyError")


def test_the_worst_of_two_tallies_is_kept() -> None:
    one = Tally(2, 1, [("a", "b")], 0.5, "slow", 10, "small")
    other = Tally(3, 1, [], 0.25, "fast", 20, "large")
    assert one.joined(other) == Tally(5, 2, [("a", "b")], 0.5, "slow", 20, "large")
