"""Proofs on matrices of claims are decided again, by the checker alone; nothing false goes by."""

from __future__ import annotations

import copy
from pathlib import Path
from typing import Any

import pytest

from gainproof import cli
from gainproof.claims import claim_proofs, judgements
from gainproof.claims.claim_proofs import NOT_AGAIN, checked, recheck, to_recheck
from gainproof.jobs.session import open_session
from gainproof.verdicts.proof_text import proof_lines

Plain = dict[str, Any]

CLAIMS = r"""
format = "gainproof claims 1"
[source]
key = "matrix-notes"
title = "Notes on matrices"
authors = ["A. Reader"]
publication = "unpublished"
[settings.matrices]
title = "matrices of every size"
kind = "matrices"
sizes = ["n", "m"]
[settings.matrices.symbols]
'A' = { shape = ["m", "n"], meaning = "design matrix" }
'V' = { shape = ["m", "m"], is = ["positive definite"], meaning = "covariance" }
[[claims]]
id = "1"
place = "page 1"
kind = "identity"
setting = "matrices"
latex = 'V^{-1} V A = A'
[[claims]]
id = "2"
place = "page 1"
kind = "inequality"
setting = "matrices"
latex = 'A^T V^{-1} A \geq O_{n,n}'
"""
USING = r"""
[[claims]]
id = "3"
place = "page 1"
kind = "inequality"
setting = "matrices"
latex = '2 A^T V^{-1} A \geq O_{n,n}'
using = ["2"]
"""


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("claims") / "matrix-notes.toml"
    path.write_text(CLAIMS)
    return path


@pytest.fixture(scope="module")
def original(file: Path) -> Plain:
    (judged,) = judgements.judge([file], open_session(quiet=True))
    return judged


@pytest.fixture
def judged(original: Plain) -> Plain:
    return copy.deepcopy(original)


def proof_of(judged: Plain, number: int) -> Plain:
    proof: Plain = judged["claims"][number]["evidence"]["certificate"]["words"][-1]
    return proof


def test_every_proof_is_accepted(judged: Plain) -> None:
    assert [claim["verdict"] for claim in judged["claims"]] == ["proved", "proved"]
    report = recheck(judged)
    assert (report["source"], report["claims"], report["rejected"]) == ("matrix-notes", 2, [])
    assert report["statements"] > 2
    asked = to_recheck(judged)
    assert asked is not None
    assert recheck(asked) | {"seconds": 0} == report | {"seconds": 0}


def test_a_claim_that_a_proof_does_not_show_is_rejected(judged: Plain) -> None:
    """The last statement says that 2 V^-1 V A is A."""
    right = proof_of(judged, 0)["statements"][-1]["claim"]["right"]
    nodes, end = right["nodes"], right["outputs"]["value"]
    right["nodes"], right["outputs"] = [*nodes, ["add", end, end]], {"value": len(nodes)}
    assert [each["id"] for each in recheck(judged)["rejected"]] == ["1"]
    good, said = checked(judged["claims"][0])
    assert not good
    assert said.startswith("REJECTED by the checker of certificates")


@pytest.mark.parametrize("field", ["setting", "statements"])
@pytest.mark.parametrize("value", [None, [], {}, "text", 1.5])
def test_what_is_no_proof_is_rejected(judged: Plain, field: str, value: Any) -> None:
    proof_of(judged, 1)[field] = value
    assert [each["id"] for each in recheck(judged)["rejected"]] == ["2"]


def test_a_proof_left_out_is_told(judged: Plain) -> None:
    judged["claims"][1]["evidence"]["certificate"] = None
    assert recheck(judged)["rejected"] == [{"id": "2", "reason": "there is no proof"}]


def test_a_judgement_without_proofs_on_matrices_has_nothing_to_check(judged: Plain) -> None:
    for claim in judged["claims"]:
        claim["evidence"] = {"method": "towers", "certificate": None, "witness": None}
    assert to_recheck(judged) is None
    assert checked(judged["claims"][0])[1].startswith(NOT_AGAIN)
    assert checked({**judged["claims"][0], "verdict": "held"}) == (True, "")


@pytest.mark.parametrize(
    ("verdict", "method", "witness", "reason"),
    [
        ("refuted", "dimensions", None, "the dimensions decide"),
        ("proved", "shapes", None, "the shapes of the letters decide"),
        ("refuted", "balls at an exact point", {"point": {"x": "1"}}, "the counterexample decides"),
        ("proved", "expansion near the limit", None, "such a proof is not kept"),
    ],
)
def test_what_is_not_gone_through_again_is_told_with_its_reason(
    judged: Plain, verdict: str, method: str, witness: Any, reason: str
) -> None:
    evidence = {"method": method, "certificate": None, "witness": witness}
    good, said = checked({**judged["claims"][0], "verdict": verdict, "evidence": evidence})
    assert good
    assert said.startswith(f"{NOT_AGAIN}{reason}")


def test_the_page_of_a_proof_numbers_its_statements(judged: Plain) -> None:
    lines = proof_lines(proof_of(judged, 1))
    assert "1. V is invertible if V > 0" in lines
    assert lines[-1].split("if")[0].endswith("A' V^-1 A >= 0 ")


def test_explain_shows_the_proof_and_that_it_was_checked(
    file: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert cli.main(["explain", str(file), "2"]) == 0
    shown = capsys.readouterr().out
    assert "again by the checker of certificates" in shown
    assert "Proof, for matrices of every size" in shown
    monkeypatch.setattr(claim_proofs, "rejected", lambda _: "not this one")
    assert cli.main(["explain", str(file), "2"]) == 1
    assert "REJECTED by the checker of certificates: not this one" in capsys.readouterr().out


def test_of_claims_that_a_proof_uses_the_page_tells_what_they_say(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "matrix-notes.toml"
    path.write_text(CLAIMS + USING)
    assert cli.main(["explain", str(path), "3"]) == 0
    shown = capsys.readouterr().out
    used, proof = shown.split("\nProof, for matrices of every size")
    lines = used.split("Claim 2, used here")[1].split("\n")
    assert [line.strip() for line in lines if line] == ["A' V^-1 A >= 0 if V > 0"]
    assert "2 A' V^-1 A >= 0" in proof
