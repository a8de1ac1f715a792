"""`run`: everything looked at, every kind of trouble found, report and snapshots written whole."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from one_of_each import cases

import gainproof.generated
from gainproof import cli
from gainproof.claims import judgements
from gainproof.files import places
from gainproof.jobs.session import open_session
from gainproof.subjects import bounds_ledger, derivations, generated_files

Capture = pytest.CaptureFixture[str]

SUBJECTS = ["random-velocity", "least-squares-mean", "least-squares-line"]
CLAIMS = r"""
format = "gainproof claims 1"
[source]
key = "own-paper"
title = "Notes on a filter"
authors = ["A. Reader"]
publication = "unpublished"
[settings.steady]
title = "alpha-beta filter"
kind = "steady_state"
model = "random-velocity"
gain = "filter"
[settings.steady.symbols]
'\alpha' = { quantity = "filter_gain.1", meaning = "position gain" }
'\beta' = { quantity = "filter_gain.2", meaning = "velocity gain" }
[[claims]]
id = "1"
place = "page 1"
kind = "identity"
setting = "steady"
latex = '\alpha^2 + \alpha\beta = 2\beta'
"""


@dataclass(frozen=True)
class House:
    """A small house: three subjects with their certificates, one module, one claim file."""

    generated: Path
    claims: Path
    report: Path

    def run(self, *options: str) -> int:
        return cli.main(["run", "--report", str(self.report), *options])

    def found(self) -> Any:
        return json.loads((self.report / "report.json").read_text(encoding="utf-8"))


@pytest.fixture
def house(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> House:
    # paths from here are the same in every test, so that what was judged for one is known to all
    monkeypatch.chdir(tmp_path)
    session = open_session(quiet=True)
    files = {
        f"{derived.name.replace('-', '_')}.json": json.dumps(derived.certificate).encode()
        for derived in derivations.derive(SUBJECTS, session)
    }
    files["random_velocity.py"] = b"# a module\n"
    shipped = [each for each in derivations.outlines() if each["name"] in SUBJECTS]
    files[derivations.OUTLINES] = derivations.outlines_file(shipped)
    house = House(*(tmp_path / name for name in ("generated", "claims", "report")))
    monkeypatch.setattr(derivations, "catalogue", lambda: list(SUBJECTS))
    monkeypatch.setattr(generated_files, "fresh", lambda *_: files)
    monkeypatch.setattr(places, "generated_folder", lambda: house.generated)
    monkeypatch.setattr(places, "claims_folder", lambda: house.claims)
    house.claims.mkdir()
    (house.claims / "own-paper.toml").write_text(CLAIMS)
    house.generated.mkdir()
    for name, content in files.items():
        (house.generated / name).write_bytes(content)
    assert house.run("--accept") == 0
    capsys.readouterr()
    return house


def test_verdicts_under_altered_models_are_not_accepted(house: House, capsys: Capture) -> None:
    """Snapshots would hold what is said of other models."""
    shipped, snapshot = (
        house.generated / derivations.OUTLINES,
        house.claims / "own-paper.verdicts.json",
    )
    before, true = snapshot.read_bytes(), shipped.read_bytes()
    subjects = derivations.outlines()
    subjects[0]["model"]["process_noise"] = [["1/4", "1/2"], ["1/2", "1"]]
    shipped.write_bytes(derivations.outlines_file(subjects))
    assert house.run("--accept") == 1
    out = capsys.readouterr().out
    assert f"{derivations.OUTLINES}: different" in out
    assert "changes, under models that are not those derived" in out
    assert snapshot.read_bytes() == before
    shipped.write_bytes(true)
    assert house.run() == 0


def test_all_is_well(house: House, capsys: Capture) -> None:
    assert house.run() == 0
    captured = capsys.readouterr()
    assert "each byte as derived" in captured.out
    assert "3 of 3 accepted" in captured.out
    assert "1 claim: 1 proved" in captured.out
    assert "unchanged" in captured.out
    assert captured.err.count("unchanged") == 2
    assert "trials of claims and repairs: 1 known, 0 done now" in captured.err
    found = house.found()
    assert found["good"] is True
    files = len(list(house.generated.iterdir()))
    assert found["generated"] == {"files": files, "differences": [], "worse": []}
    reports = [(report["subject"], report["accepted"]) for report in found["certificates"]]
    assert reports == [(name, True) for name in SUBJECTS]
    assert found["versions"]["sympy"] == "1.14.0"
    text = (house.report / "report.txt").read_text(encoding="utf-8")
    assert "random-velocity" in text
    assert "own-paper: Notes on a filter" in text


def edited_kernel(house: House) -> None:
    (house.generated / "random_velocity.py").write_bytes(b"# a module \n")


def lost_kernel(house: House) -> None:
    (house.generated / "random_velocity.py").unlink()


def stale_file(house: House) -> None:
    (house.generated / "old.py").touch()


@pytest.mark.parametrize("spoil", [edited_kernel, lost_kernel, stale_file])
def test_drift_has_status_1_and_names_its_cure(
    spoil: Callable[[House], None], house: House, capsys: Capture
) -> None:
    spoil(house)
    assert house.run() == 1
    assert "gainproof generate" in capsys.readouterr().out
    assert len(house.found()["generated"]["differences"]) == 1


def test_a_bound_that_grew_is_said(
    house: House, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    committed, now = (
        {"inputs": [[1.0, 2.0]], "boxes": 1, "outputs": {"x": {"bound": bound}}}
        for bound in ("1.50", "1.51")
    )
    path = house.generated / bounds_ledger.NAME
    path.write_text(bounds_ledger.text({"line": {"gains": {"key": "a", "float32": committed}}}))
    ledger = bounds_ledger.text({"line": {"gains": {"key": "b", "float32": now}}}).encode()
    files = generated_files.fresh((), open_session(quiet=True))
    fresh = {**files, bounds_ledger.NAME: ledger}
    monkeypatch.setattr(generated_files, "fresh", lambda *_: fresh)
    assert house.run() == 1
    said = "line.gains, x (float32): its bound grew from 1.50 to 1.51"
    assert said in capsys.readouterr().out
    assert house.found()["generated"]["worse"] == [said]


def test_a_forged_certificate_has_status_1(house: House, capsys: Capture) -> None:
    path = house.generated / "random_velocity.json"
    certificate = json.loads(path.read_text())
    (statement,) = [s for s in certificate["statements"] if s["id"] == "riccati"]
    row = next(iter(statement["evidence"]["cofactors"].values()))
    target = next(poly for poly in row if poly)
    target[0][0] = "7/5"
    path.write_text(json.dumps(certificate))
    assert house.run() == 1
    assert "random-velocity: riccati" in capsys.readouterr().out
    assert [r["subject"] for r in house.found()["certificates"] if not r["accepted"]] == [
        "random-velocity"
    ]


def test_the_certificate_of_another_family_has_status_1(house: House, capsys: Capture) -> None:
    # of the same states and parameter, as good as that which is expected
    other = Path(gainproof.generated.__file__).with_name("random_acceleration.json")
    shutil.copy(other, house.generated / "random_velocity.json")
    assert house.run() == 1
    assert "2 of 3 accepted" in capsys.readouterr().out


def test_a_statement_left_out_has_status_1(house: House, capsys: Capture) -> None:
    path = house.generated / "least_squares_mean.json"
    certificate = json.loads(path.read_text())
    del certificate["statements"][3]
    path.write_text(json.dumps(certificate))
    assert house.run() == 1
    assert "2 of 3 accepted" in capsys.readouterr().out


@pytest.mark.parametrize("content", cases(["", "{", "[]", "null"], lambda t: t in {"{", "null"}))
def test_an_unreadable_certificate_has_status_1(content: str, house: House) -> None:
    (house.generated / "random_velocity.json").write_text(content)
    assert house.run() == 1


def test_a_changed_verdict_has_status_1_until_accepted(house: House, capsys: Capture) -> None:
    path = house.claims / "own-paper.toml"
    path.write_text(CLAIMS.replace(r"2\beta", r"3\beta"))
    assert house.run() == 1
    out = capsys.readouterr().out
    assert "own-paper.toml\n" in out
    assert "verdict was proved, is refuted" in out
    assert "run --accept" in out
    assert house.run("--accept") == 0
    assert house.run() == 0


def test_no_snapshot_has_status_1(house: House) -> None:
    (house.claims / "own-paper.verdicts.json").unlink()
    assert house.run() == 1


def test_a_bad_claim_file_has_status_2_and_writes_nothing(house: House, capsys: Capture) -> None:
    before = (house.report / "report.json").read_bytes()
    (house.claims / "own-paper.toml").write_text(CLAIMS.replace(r"2\beta", r"2\bata"))
    assert house.run() == 2
    assert r"\bata" in capsys.readouterr().err
    assert (house.report / "report.json").read_bytes() == before


def test_an_interrupt_while_writing_leaves_the_old_report(
    house: House, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = {path.name: path.read_bytes() for path in house.report.iterdir()}

    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "replace", interrupted)
    assert house.run() == 130
    assert {path.name: path.read_bytes() for path in house.report.iterdir()} == before


def test_fresh_takes_nothing_from_the_cache(house: House, capsys: Capture) -> None:
    (house.claims / "own-paper.toml").write_text(CLAIMS)
    assert house.run("--fresh") == 0
    err = capsys.readouterr().err
    assert "unchanged" not in err
    assert "0 known, 1 done now" in err


def test_an_accident_has_status_1_and_nothing_of_it_is_accepted(
    house: House, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    snapshot = house.claims / "own-paper.verdicts.json"
    before = snapshot.read_bytes()
    judge = judgements.judge

    def broken_off(*given: Any, **options: Any) -> Any:
        (judged,) = judge(*given, **options)
        lost = {"verdict": "undecided", "reason": "killed", "accident": "killed"}
        return [{**judged, "claims": [{**judged["claims"][0], **lost}]}]

    monkeypatch.setattr(judgements, "judge", broken_off)
    for options in ((), ("--accept",)):
        assert house.run(*options) == 1
        out = capsys.readouterr().out
        assert "not judged:       1, by accident" in out
        assert "own-paper, 1: killed" in out
        assert "snapshot:         unchanged" in out
        assert house.found()["good"] is False
    assert snapshot.read_bytes() == before
    monkeypatch.undo()
