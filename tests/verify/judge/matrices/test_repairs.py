"""Repairs of false claims on matrices: what a misprint should have been, and nothing unproved."""

from __future__ import annotations

import random
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from matrix_claims import judged_matrices
from one_of_each import further

import gainproof.verify
from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.matrices.claim_directions import cases_of
from gainproof.verify.judge.matrices.decision import decide
from gainproof.verify.judge.matrices.layered_proof import Proofs
from gainproof.verify.judge.matrices.letters import MatrixClaim, MatrixSetting
from gainproof.verify.judge.matrices.misprints import slips
from gainproof.verify.judge.matrices.reader import read_statement
from gainproof.verify.judge.matrices.repair import repairs
from gainproof.verify.judge.matrices.shapes import ShapeFault, Shapes
from gainproof.verify.judge.matrices.tree import Statement
from gainproof.verify.judge.reader.errors import ReaderError

FILE = Path(gainproof.verify.__file__).parent / "claims" / "kosuge-doppler.toml"
REPAIRS = [
    (r"H^T V H = V_1", "identity", "", r"H^T V H = V_2"),
    (r"Q B Q = (Q B Q)^T", "identity", "", r"Q B^T Q = (Q B Q)^T"),
    (
        r"H^T V^{-1} H = (V_2 + V_{12}^T V_1^{-1} V_{12})^{-1}",
        "identity",
        "",
        r"H^T V^{-1} H = (V_2 - V_{12}^T V_1^{-1} V_{12})^{-1}",
    ),
    (r"E[z] = - A a", "unbiased", "", r"E[z] = A a"),
    (
        r"Y^{-1} \leq X^{-1}",
        "inequality",
        r"given = ['X \geq Y > 0']",
        r"Y^{-1} \geq X^{-1}",
    ),
    (r"0 < A^T A", "inequality", "", r"0 \leq A^T A"),
    (
        r"E[(\hat{a} - a)(\hat{a} - a)^T] = (A^T R A)^{-1}",
        "covariance",
        "given = ['0 < A^T A']",
        r"E[(\hat{a} - a)(\hat{a} - a)^T] = (A^T R^{-1} A)^{-1}",
    ),
    (r"A R A = Q", "identity", "", None),
    further(r"B C = C B", "identity", "", None),
    further(r"B = 2 B", "identity", "", None),
]


@pytest.mark.alike
@pytest.mark.parametrize(("latex", "kind", "more", "repair"), REPAIRS)
def test_the_nearest_true_formula_is_offered(
    latex: str, kind: str, more: str, repair: str | None
) -> None:
    found = judged_matrices(latex, kind, more, repairs=True)
    assert found.verdict in ("refuted", "conditional")
    if repair is None:
        assert found.repair is None
        assert "no misprint-like repair found" in found.reason
        return
    assert found.repair is not None
    offers = [told["latex"] for told in found.repairs]
    assert repair in offers
    for offer in offers:
        assert judged_matrices(offer, kind, more).verdict == "proved", offer


def slipped(
    claims: list[Claim], settings: dict[str, MatrixSetting], source: random.Random, proofs: Proofs
) -> Iterator[tuple[Claim, str, MatrixClaim]]:
    """Claims with a slip that is refuted, one for each claim for which one is found."""
    for claim in claims:
        setting = settings[claim.setting]
        # a term put in may be made up for by less than leaving it out
        pool = [s for s in slips(claim.latex, setting) if not s.what.startswith("a missing term")]
        source.shuffle(pool)
        assert claim.matrices is not None
        for slip in pool:
            try:
                statement = read_statement(slip.latex, setting.letters, setting.sizes)
                other = replace(claim.matrices, statement=statement)
                cases_of(other, Shapes(setting.letters, setting.sizes))
            except (ReaderError, ShapeFault):
                continue
            if decide(other, setting, proofs).verdict in ("refuted", "conditional"):
                yield claim, slip.latex, other
                break


def bare(statement: Statement) -> Statement:
    """Without the text that it was read from."""
    return replace(statement, text="")


@pytest.mark.parametrize("most", [8, pytest.param(90, marks=pytest.mark.thorough)])
def test_most_slips_in_claims_of_the_paper_are_found(most: int) -> None:
    """The repair of a claim with a slip is the claim itself, also among others as near."""
    file = read_claim_text(FILE.read_text(encoding="utf-8"), FILE.name)
    settings = {name: s.matrices for name, s in file.settings.items() if s.matrices is not None}
    kinds = ("identity", "inequality", "unbiased", "equivalence", "implication")
    claims = [c for c in file.claims if c.matrices is not None and c.kind in kinds]
    source = random.Random(1)
    source.shuffle(claims)
    proofs: Proofs = {}
    found = 0
    for claim, latex, slip in slipped(claims[:most], settings, source, proofs):
        setting = settings[claim.setting]
        offers = repairs(latex, slip, setting, proofs, time.perf_counter() + 60)
        statements = [read_statement(o.latex, setting.letters, setting.sizes) for o in offers]
        assert claim.matrices is not None
        found += bare(claim.matrices.statement) in map(bare, statements)
        for statement in statements[:1]:
            judged = decide(replace(slip, statement=statement), setting, proofs)
            assert judged.verdict == "proved"
    assert found >= 0.8 * most, found
