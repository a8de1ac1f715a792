"""Statements on location, held against matrices that fulfil their hypotheses.

That shows no statement for every size: the checker does. It shows that what is claimed is what is
meant, and that no statement has hypotheses that nothing fulfils.
"""

from __future__ import annotations

import json
import random
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import location_values
import pytest
from samples import samples
from word_values import completed, holds, true

import gainproof.generated
from gainproof.derive.estimation.multipath_location import NAME, build
from gainproof.derive.pages.derivation import FOLDER
from gainproof.verify.certificate import check, check_statement
from gainproof.verify.certificate.alteration_campaign import Campaign
from gainproof.verify.certificate.document import read_document, read_statement
from gainproof.verify.certificate.plain_data import plain
from gainproof.verify.certificate.rejection import Meter, RejectedError

MATRIX = ("matrix_equal", "matrix_order", "matrix_invertible")


@cache
def certificate() -> Mapping[str, Any]:
    """As shipped; `gainproof run` and the tests of drift hold it against the derivation."""
    path = Path(gainproof.generated.__file__).with_name("multipath_location.json")
    found: Mapping[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return found


@cache
def instances(tower: str) -> tuple[Mapping[str, Any], ...]:
    """Sets of matrices for one setting."""
    setting = certificate()["towers"][tower]
    return tuple(completed(setting, values) for values in location_values.matrices(tower))


def statements() -> Iterator[Mapping[str, Any]]:
    """Those on matrices of every size."""
    yield from (s for s in certificate()["statements"] if s["kind"] in MATRIX)


def test_the_shipped_certificate_is_accepted() -> None:
    report = check(certificate())
    assert report.accepted, report.reason
    assert report.count("rejected") == 0
    assert len(list(statements())) > 200


def test_every_statement_is_true_where_its_hypotheses_are() -> None:
    for statement in statements():
        setting = certificate()["towers"][statement["tower"]]
        fulfilled = [
            values
            for values in instances(statement["tower"])
            if all(holds(setting, entry, values) for entry in statement["claim"]["given"])
        ]
        assert fulfilled, f"{statement['id']}: nothing fulfils its hypotheses"
        for values in fulfilled:
            assert true(setting, statement["kind"], statement["claim"], values), statement["id"]


WEAKER = {
    "definite": ("semidefinite", "symmetric", "invertible"),
    "semidefinite": ("symmetric",),
    "invertible": ("full_column_rank",),
}


def test_no_hypothesis_may_be_left_out_or_weakened() -> None:
    """Each implication says what its proof needs and no more."""
    document = read_document(plain(certificate()), Meter())
    for statement in statements():
        for number, hypothesis in enumerate(statement["claim"]["given"]):
            kinds = (None, *WEAKER.get(hypothesis["kind"], ()))
            for kind in kinds:
                given = list(statement["claim"]["given"])
                given[number : number + 1] = [] if kind is None else [{**hypothesis, "kind": kind}]
                altered = {**statement, "claim": {**statement["claim"], "given": given}}
                if statement["kind"] == "matrix_invertible" and kind == "invertible":
                    continue  # that what is positive definite has an inverse says just that
                with pytest.raises(RejectedError):
                    document.decide(read_statement(plain(altered), document.towers, "altered"))


@pytest.mark.sampled
def test_what_is_altered_is_rejected() -> None:
    """Numbers and fields; `tests/campaigns/matrix_statements.py` tries more of them."""
    campaign = Campaign(certificate())
    chosen = random.Random(0).sample(campaign.alterations(), samples(20))
    assert campaign.run(chosen).accepted == ()


WRONG = [
    ("kernel-bias-deviation", "    deviation = sigma_b\n", "    deviation = 2 sigma_b\n"),
    ("example-2", "course_2 = [1500/41, 300/41,", "course_2 = [1500/41, 301/41,"),
    ("example-0-whole", "all_0 = [75, 75,", "all_0 = [75, 76,"),
    ("kernel-bias-deviation", "    share = 1/(1 + rho)\n", "    share = 1/(2 + rho)\n"),
]


@pytest.mark.parametrize(("step", "right", "wrong"), WRONG)
def test_a_number_of_the_page_that_is_not_true_is_rejected(
    tmp_path: Path, step: str, right: str, wrong: str
) -> None:
    text = (FOLDER / f"{NAME}.md").read_text(encoding="utf-8")
    assert text.count(right) == 1
    (tmp_path / f"{NAME}.md").write_text(text.replace(right, wrong), encoding="utf-8")
    found = json.loads(json.dumps(build(tmp_path).certificate()))
    statuses = [check_statement(found, name).status for name in (step, "example-4")]
    assert statuses == ["rejected", "proved"]
