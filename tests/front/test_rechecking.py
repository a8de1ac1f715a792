"""Certificates against what is expected of them: nothing that ships may be left unproved."""

from __future__ import annotations

import copy
from typing import Any

import pytest

from gainproof.jobs.session import open_session
from gainproof.subjects import derivations, rechecking
from gainproof.subjects.rechecking import expected_of, recheck
from gainproof.verify.certificate import CertificateReport

Plain = dict[str, Any]


@pytest.fixture(scope="module")
def original() -> tuple[Plain, Plain]:
    (derived,) = derivations.derive(["random-velocity"], open_session(quiet=True))
    return derived.certificate, expected_of(derived)


@pytest.fixture
def pair(original: tuple[Plain, Plain]) -> tuple[Plain, Plain]:
    return copy.deepcopy(original)


def test_as_derived_it_is_accepted(pair: tuple[Plain, Plain]) -> None:
    report = recheck(*pair)
    assert report["accepted"]
    assert report["reason"] == ""
    assert {s["status"] for s in report["statements"]} == {"proved", "cited", "definition"}


@pytest.fixture
def easy_checker(monkeypatch: pytest.MonkeyPatch) -> None:
    """A checker that accepts everything: what is refused now is refused by the comparison alone."""
    accepted = CertificateReport("random-velocity", True, "", ())
    monkeypatch.setattr(rechecking, "check", lambda *_, **__: accepted)


@pytest.mark.usefixtures("easy_checker")
def test_a_kernel_of_which_nothing_is_claimed_is_refused(pair: tuple[Plain, Plain]) -> None:
    certificate, expected = pair
    assert recheck(certificate, expected)["accepted"]
    expected["claims"] = [c for c in expected["claims"] if c["claim"].get("program") != "gains"]
    report = recheck(certificate, expected)
    assert not report["accepted"]
    assert report["reason"].endswith("gains.alpha, gains.beta")


@pytest.mark.usefixtures("easy_checker")
def test_an_output_of_which_nothing_is_claimed_is_refused(pair: tuple[Plain, Plain]) -> None:
    certificate, expected = pair
    claims = [c for c in expected["claims"] if c["claim"].get("program") == "gains"]
    assert claims
    for claim in claims:  # one on each side of a choice
        del claim["claim"]["outputs"]["beta"]
    report = recheck(certificate, expected)
    assert not report["accepted"]
    assert report["reason"].endswith("are: gains.beta")


def test_another_graph_than_the_printed_one_is_refused(pair: tuple[Plain, Plain]) -> None:
    certificate, expected = pair
    nodes = expected["programs"]["gains"]["graph"]["nodes"]
    number = next(node for node in nodes if node[0] == "number")
    number[1] = "7/3"
    report = recheck(certificate, expected)
    assert not report["accepted"]
    assert "programs.gains" in report["reason"]


def test_another_subject_is_refused(pair: tuple[Plain, Plain]) -> None:
    certificate, expected = pair
    certificate["subject"] = "random-acceleration"
    report = recheck(certificate, expected)
    assert not report["accepted"]
    assert "'random-velocity' is expected" in report["reason"]


@pytest.mark.parametrize("part", ["model", "domain", "towers", "claims"])
def test_each_part_of_what_is_expected_counts(part: str, pair: tuple[Plain, Plain]) -> None:
    certificate, expected = pair
    other: dict[str, Any] = {
        "model": {**expected["model"], "process_noise": [["1/4", "1/2"], ["1/2", "1"]]},
        "domain": {**expected["domain"], "main": [{"symbol": "p", "above": "1"}]},
        "towers": {"main": expected["towers"]["main"], "side": expected["towers"]["main"]},
        "claims": expected["claims"][:-1],
    }
    report = recheck(certificate, {**expected, part: other[part]})
    assert not report["accepted"]
    assert report["reason"]


@pytest.mark.usefixtures("easy_checker")
@pytest.mark.parametrize("side", ["below", "above"])
def test_one_side_of_a_choice_is_refused(side: str, pair: tuple[Plain, Plain]) -> None:
    certificate, expected = pair
    for part in (certificate["statements"], expected["claims"]):
        part[:] = [entry for entry in part if entry["id"] != f"kernel-gains-{side}-switch"]
    report = recheck(certificate, expected)
    assert not report["accepted"]
    assert "gains.alpha is proved only where its 'select', node 5, takes" in report["reason"]
