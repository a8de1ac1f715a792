"""Snapshots of verdicts: each change that matters is seen, time is none of them."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import pytest

from gainproof.bad_input import BadInputError
from gainproof.verdicts import verdict_snapshot


def claim(name: str, verdict: str, **fields: Any) -> dict[str, Any]:
    return {
        "id": name,
        "place": "slide 3",
        "kind": "identity",
        "latex": r"\beta = \alpha",
        "verdict": verdict,
        "domain": None,
        "evidence": {"method": "towers", "certificate": {"steps": 3}, "witness": None},
        "repair": None,
        "convention": None,
        "reading": None,
        "undefined": [],
        "reason": "",
        "seconds": 0.01,
    } | fields


JUDGED: dict[str, Any] = {
    "source": {"key": "lecture", "title": "Tracking"},
    "claims": [
        claim("a", "proved", convention="filter gain"),
        claim(
            "b",
            "refuted",
            repair={"latex": r"\beta = 2", "verdict": "proved"},
            reason="false at Lambda = 1",
        ),
        claim("c", "remark", reason="an opinion"),
    ],
}


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "lecture.toml"
    verdict_snapshot.write_snapshot(JUDGED, path)
    return path


def test_unchanged_verdicts_are_no_change(file: Path) -> None:
    assert (file.parent / "lecture.verdicts.json").is_file()
    again = copy.deepcopy(JUDGED)
    again["claims"][0]["seconds"] = 99
    again["claims"][0]["evidence"]["certificate"] = {"steps": 4}
    assert verdict_snapshot.changes(again, file) == []


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("verdict", "held"),
        ("domain", "Lambda < 1"),
        ("convention", "predictor gain"),
        ("reading", "(4a/b)T"),
        ("repair", {"latex": "x", "verdict": "proved"}),
        ("undefined", [{"symbol": "r", "solution": "1", "consumed": ["b"]}]),
    ],
)
def test_each_change_is_seen(file: Path, field: str, value: Any) -> None:
    again = copy.deepcopy(JUDGED)
    again["claims"][0][field] = value
    (line,) = verdict_snapshot.changes(again, file)
    assert line.startswith(f"a: {field} was ")


def test_a_weaker_method_is_seen(file: Path) -> None:
    again = copy.deepcopy(JUDGED)
    again["claims"][0]["evidence"]["method"] = "replayed"
    assert verdict_snapshot.changes(again, file) == ["a: method was towers, is replayed"]


def test_new_lost_and_moved_claims_are_seen(file: Path) -> None:
    again = copy.deepcopy(JUDGED)
    again["claims"][0]["id"] = "z"
    assert verdict_snapshot.changes(again, file) == [
        "a: no longer among the claims",
        "z: new, proved",
    ]
    moved = copy.deepcopy(JUDGED)
    moved["claims"].reverse()
    assert len(verdict_snapshot.changes(moved, file)) == 1


def test_no_snapshot_is_a_change(tmp_path: Path) -> None:
    assert verdict_snapshot.changes(JUDGED, tmp_path / "new.toml") == [
        "new.verdicts.json: there is no snapshot yet"
    ]


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"claims": [1]}', '{"claims": [{"id": []}]}'])
def test_a_damaged_snapshot_is_bad_input(file: Path, text: str) -> None:
    file.with_name("lecture.verdicts.json").write_text(text)
    with pytest.raises(BadInputError, match="not a snapshot"):
        verdict_snapshot.changes(JUDGED, file)


def test_snapshots_hold_no_times(file: Path) -> None:
    text = file.with_name("lecture.verdicts.json").read_text()
    assert "seconds" not in text
    assert [c["id"] for c in json.loads(text)["claims"]] == ["a", "b", "c"]


def test_unsettled_and_tally() -> None:
    data = copy.deepcopy(JUDGED)
    assert verdict_snapshot.unsettled(data) == []
    data["claims"] += [claim("d", "held"), claim("e", "undecided")]
    assert verdict_snapshot.unsettled(data) == ["d", "e"]
    assert list(verdict_snapshot.tally([data])) == [
        "proved",
        "refuted",
        "held",
        "undecided",
        "remark",
    ]


def test_what_met_with_an_accident_is_no_change_and_stays_as_it_was(file: Path) -> None:
    """Nor is it settled, and a claim that is new does not get into the snapshot by it."""
    again = copy.deepcopy(JUDGED)
    again["claims"][0] |= {"verdict": "undecided", "accident": "killed"}
    again["claims"].append(claim("d", "refuted", accident="killed"))
    assert verdict_snapshot.changes(again, file) == []
    assert verdict_snapshot.unsettled(again) == ["a", "d"]
    assert verdict_snapshot.accidents(again) == {"a": "killed", "d": "killed"}
    before = file.with_name("lecture.verdicts.json").read_text()
    again["claims"][1]["verdict"] = "conditional"
    assert len(verdict_snapshot.changes(again, file)) == 1
    verdict_snapshot.write_snapshot(again, file)
    after = file.with_name("lecture.verdicts.json").read_text()
    assert after == before.replace('"refuted"', '"conditional"')


def test_without_a_snapshot_an_accident_is_left_out(tmp_path: Path) -> None:
    judged = copy.deepcopy(JUDGED)
    judged["claims"][1]["accident"] = "killed"
    verdict_snapshot.write_snapshot(judged, tmp_path / "new.toml")
    data = json.loads((tmp_path / "new.verdicts.json").read_text())
    assert [entry["id"] for entry in data["claims"]] == ["a", "c"]
