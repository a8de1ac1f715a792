"""A sample of the campaign that hands wrong inputs to reader, judge and command line: nothing that
a user types ends in a traceback.
"""

from __future__ import annotations

import tomllib
from dataclasses import replace
from pathlib import Path
from random import Random

import input_fuzz
import pytest
from input_fuzz import dumped, fuzz_commands, fuzz_judged, fuzz_tables, random_tables
from samples import samples

from gainproof import cli
from gainproof.claims.template import template
from gainproof.verify.judge import judge
from gainproof.verify.judge.verdict import ClaimVerdict


@pytest.mark.sampled
def test_tables_of_claim_files() -> None:
    tally = fuzz_tables(20, samples(60))
    assert tally.crashes == []
    assert 0 < tally.read < tally.inputs


@pytest.mark.sampled
def test_claims_that_are_judged() -> None:
    tally = fuzz_judged(20, samples(8))
    assert tally.crashes == []
    assert tally.read


@pytest.mark.sampled
def test_command_lines_and_their_files() -> None:
    tally = fuzz_commands(20, samples(60))
    assert tally.crashes == []
    assert 0 < tally.read < tally.inputs


def test_the_same_seed_gives_the_same_tables() -> None:
    one, other = ([random_tables(Random(3)) for _ in range(5)] for _ in range(2))
    assert one == other


def test_what_is_dumped_is_the_same_data() -> None:
    data = tomllib.loads(template("own"))
    assert tomllib.loads(dumped(data)) == data


def test_a_traceback_a_fault_and_an_odd_status_are_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(_: object) -> int:
        raise KeyError("x")

    for name in ("design", "check", "figure", "campaign"):
        monkeypatch.setattr(cli.COMMANDS[name], "run", broken)
    tally = fuzz_commands(1, 20)
    assert len(tally.crashes) > 3
    assert all("KeyError" in what for _, what in tally.crashes)


def test_a_fault_of_the_judge_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    judged = judge.judge_file

    def stopped(*given: object, **more: object) -> tuple[ClaimVerdict, ...]:
        found = judged(*given, **more)  # type: ignore[arg-type]
        return tuple(replace(v, reason="the judge stopped: KeyError: x") for v in found)

    monkeypatch.setattr(input_fuzz, "judge_file", stopped)
    monkeypatch.setattr(input_fuzz, "random_claims", lambda _: template("own"))
    tally = fuzz_judged(1, 1)
    assert "the judge stopped: KeyError" in tally.crashes[0][1]


@pytest.mark.parametrize("option", ["--new", "--draft"])
def test_an_empty_name_begins_nothing_and_judges_nothing(
    option: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert cli.main(["check", option, ""]) == 2
    assert capsys.readouterr().err.startswith("gainproof: ")
    assert not any(tmp_path.iterdir())


@pytest.mark.parametrize(
    "words",
    [
        ["generate", "random-velocity", "--out", ""],
        ["run", "--report", ""],
        ["design", "--lag", "1", "--plot", ""],
        ["campaign", "float32", "--state", ""],
        ["locate", "a.csv", "b.csv", "--covariance", ""],
    ],
)
def test_an_empty_name_of_a_place_is_refused(
    words: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """It would be the working folder."""
    monkeypatch.chdir(tmp_path)
    assert cli.main(words) == 2
    assert capsys.readouterr().err == f"gainproof: {words[-2]}: a name is wanted, got ''\n"
    assert not any(tmp_path.iterdir())


@pytest.mark.parametrize("seconds", ["nan", "inf", "0", "-1", "1e9", "x"])
def test_times_that_are_none_are_refused(seconds: str) -> None:
    for words in (["check", "suzuki"], ["explain", "suzuki", "1"], ["certify", "random-velocity"]):
        with pytest.raises(SystemExit) as end:
            cli.main([*words, "--seconds", seconds])
        assert end.value.code == 2


def test_an_empty_name_is_no_wish_to_judge_all(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["check", ""]) == 2
    assert "no claim file is called ''" in capsys.readouterr().err
