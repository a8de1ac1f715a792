"""Settings with free gains that are no such settings, and claims that lack a field."""

from __future__ import annotations

import pytest
from free_gains import FILTERS, verdict
from small_claims import judged

from gainproof.verify.judge.claim.errors import ClaimFileError

GAIN = {
    r"\alpha": "{ quantity = 'filter_gain.1', meaning = 'gain' }",
    "p": "{ quantity = 'predicted_covariance.1.1', meaning = 'variance' }",
    "T": "{ quantity = 'sampling_interval', meaning = 'interval' }",
    "I": "{ quantity = 'tracking_index', meaning = 'index' }",
}
MATRICES = "transition = [['1', 'T'], ['0', '1']]"


@pytest.mark.parametrize(
    ("setting", "problem"),
    [
        ("kind = 'fixed_gain'", "either `states` or"),
        ("kind = 'fixed_gain'\nstates = 4", "wanted 1 to 3"),
        (f"kind = 'fixed_gain'\nstates = 2\n{MATRICES}\nmeasurement = [['1', '0']]", "either"),
        (f"kind = 'fixed_gain'\n{MATRICES}", "matrix is missing"),
        (f"kind = 'fixed_gain'\n{MATRICES}\nmeasurement = [['1', '0', '0']]", "1 by 2"),
        ("kind = 'fixed_gain'\nstates = 2\nprocess_noise = [['1']]", "wanted 2 by 2"),
        (
            "kind = 'fixed_gain'\nstates = 2\nprocess_noise = [['0', '1'], ['1', '0']]",
            "positive semidefinite",
        ),
        ("kind = 'fixed_gain'\nstates = 2\nmodel = 'search'", "does not take"),
        ("kind = 'fixed_gain'\nstates = 2\ndegree = 1", "does not take"),
        ("kind = 'algebra'\nstates = 2", "does not take"),
        (f"kind = 'algebra'\n{FILTERS.replace('beta', 'alpha')}", "does not take"),
        ("kind = 'fixed_gain'\nstates = 2\nfilters = { }", "1 to 20"),
        ("kind = 'fixed_gain'\nstates = 2\nfilters = { A = [] }", "list of equations"),
        ("kind = 'fixed_gain'\nstates = 2\nfilters = { A = ['p > 0'] }", "equations"),
    ],
)
def test_settings(setting: str, problem: str) -> None:
    with pytest.raises(ClaimFileError, match=problem):
        judged("identity", "p = p", GAIN, setting)


@pytest.mark.parametrize(
    ("kind", "fields", "problem"),
    [
        ("stability", "text = 'x'\nsense = 'always'", "is none of"),
        ("optimum", "latex = '\\alpha = 1'\nfixed = ['\\beta']", "missing"),
        ("optimum", "latex = '\\alpha = 1'\nminimised = 'p_{11}'", "list of what is the same"),
        ("optimum", "text = 'x'\nminimised = 'p_{11}'\nfixed = ['\\beta']", "is a formula"),
        ("ordering", "text = 'x'\ncompared = 'p_{11}'\nascending = ['A']\nfixed = ['B']", "two or"),
        ("identity", "latex = 'B = B'\nsense = 'exact'", "does not take"),
    ],
)
def test_claims(kind: str, fields: str, problem: str) -> None:
    with pytest.raises(ClaimFileError, match=problem):
        verdict(kind, fields)


def test_what_such_a_filter_does_not_have() -> None:
    found = judged("identity", "I = 1", GAIN, "kind = 'fixed_gain'\nstates = 2")
    assert found.verdict == "undecided"
    assert "no tracking index" in found.reason


def test_gains_that_move_no_pole() -> None:
    own = "kind = 'fixed_gain'\ntransition = [['1', '0'], ['0', '1']]\nmeasurement = [['1', '0']]"
    assert judged("inequality", "p > 0", GAIN, own).verdict == "undecided"


def test_kinds_need_free_gains() -> None:
    for kind, fields in (
        ("stability", "latex = 'a > 0'"),
        ("optimum", "latex = 'a = 1'\nminimised = 'b'\nfixed = ['c']"),
        ("ordering", "text = 'x'\ncompared = 'b'\nascending = ['A', 'B']\nfixed = ['c']"),
    ):
        found = judged(kind, fields)
        assert found.verdict == "undecided"
        assert "fixed_gain" in found.reason
