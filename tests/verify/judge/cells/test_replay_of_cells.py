"""Certificates over cells are gone through again from plain data; altered ones are refused."""

from __future__ import annotations

import copy
import json
from fractions import Fraction
from typing import Any

import pytest

from gainproof.verify.judge.cells.decision import decide_in_cells
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import number, power, sqrt, symbol
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.replay import replay

x, y, z = (symbol(name) for name in "xyz")
POSITIVE = Box(lower=Fraction(0))
ROOT = sqrt(power(x, 2) + power(y, 2))
STATEMENTS = (
    Statement((Rel("<=", ROOT, x + y),)),
    Statement((Rel("<", 2 * ROOT, x + y),)),
    Statement((Rel("<", sqrt(x * y), (x + y) / 2),)),
    Statement((Rel("<=", x + y, sqrt(number(2))),), (Rel("=", ROOT, number(1)),)),
    Statement((Rel("<", power(x + y, 3), number(4)),),
              (Rel("=", power(x, 3) + power(y, 3), number(1)),)),
    Statement((Rel("=", power(x, 2), power(y, 2)),), (Rel("=", x, y),), "iff",
              given=(Rel("<", x, z),)),
)  # fmt: skip


@pytest.mark.parametrize("statement", STATEMENTS, ids=range(len(STATEMENTS)))
def test_certificates_are_replayed(statement: Statement) -> None:
    outcome = decide_in_cells(statement, dict.fromkeys(statement.symbols(), POSITIVE))
    certificate: dict[str, Any] = json.loads(json.dumps(outcome.certificate))
    assert certificate["checked"] == "replayed"
    assert replay(certificate, outcome.verdict) is None
    other = "refuted" if outcome.verdict == "proved" else "proved"
    assert replay(certificate, other) is not None
    altered = copy.deepcopy(certificate)
    altered["statement"]["relations"][0]["operator"] = ">"
    assert replay(altered, outcome.verdict) is not None


def test_a_certificate_holds_what_is_needed_to_follow_it() -> None:
    outcome = decide_in_cells(STATEMENTS[1], {"x": POSITIVE, "y": POSITIVE})
    certificate = outcome.certificate
    assert [level["variable"] for level in certificate["projection"]]
    cell = certificate["places"][0]
    assert set(cell["between"]) == {"x1", "x2"}
    assert cell["samples"]
    assert cell["found"] in ("true", "false")
    for place in range(len(certificate["places"])):
        altered = copy.deepcopy(dict(certificate))
        altered["places"][place]["samples"] = ["1, 7"]
        assert replay(altered, outcome.verdict) is not None
