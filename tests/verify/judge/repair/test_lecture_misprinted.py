"""Misprinted formulas of the lecture: what is offered is true by an evaluator that shares nothing
with the judge, says something, and mostly is the formula that was misprinted.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path
from random import Random

import pytest
from claim_texts import MODELS
from mutation.campaign import Relation, is_false
from mutation.claims import claimed_names, claimed_relations
from mutation.mutants import misprints
from mutation.tree import Tree, symbols, to_graph, to_tree
from one_of_each import cases

from gainproof.verify.judge.claim.file import read_claim_file
from gainproof.verify.judge.claim.record import ClaimFile
from gainproof.verify.judge.formula import Formula, Reading
from gainproof.verify.judge.formula import Relation as Printed
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.reader.latex_printer import reading_to_latex
from gainproof.verify.judge.reader.reader import read_formula
from gainproof.verify.judge.verdict import ClaimVerdict

LECTURE = Path(__file__).parents[4] / "verify" / "claims" / "kosuge-slides.toml"
SEED, EACH = 5, 8
SOURCE = "kosuge-slides"
NAMES = claimed_names(SOURCE)
Sides = tuple[Tree, Tree]


@cache
def relations() -> dict[str, Relation]:
    """By name; with the models of the catalogue, which are not derived to collect the tests."""
    return {r.name: r for r in claimed_relations() if r.name.startswith(f"{SOURCE} ")}


@cache
def lecture() -> ClaimFile:
    return read_claim_file(LECTURE)


def misprinted(relation: Relation) -> list[Sides]:
    """False variants of a true relation, each one misprint away."""
    made = [(new, relation.right) for _, new in misprints(relation.left)]
    made += [(relation.left, new) for _, new in misprints(relation.right)]
    chosen = Random(SEED).sample(made, min(3 * EACH, len(made)))
    return [sides for sides in chosen if is_false(relation, *sides)][:EACH]


def judged(relation: Relation, mutants: list[Sides]) -> tuple[ClaimVerdict, ...]:
    """The verdicts on misprints, each in a setting that no other claim speaks of."""
    claim = next(c for c in lecture().claims if relation.name.endswith(f" {c.id}"))
    setting = lecture().settings[claim.setting]
    assert claim.formula is not None
    conditions = claim.formula.readings[0].conditions
    claims, settings = [], {}
    for number, sides in enumerate(mutants):
        name = f"{number}"
        left, right = (to_graph(side) for side in sides)
        latex = reading_to_latex(Reading((Printed("=", left, right),), conditions))
        read = read_formula(latex, setting.symbols)
        formula = Formula(latex, read.readings, read.symbols)
        claims.append(replace(claim, id=name, setting=name, latex=latex, formula=formula))
        settings[name] = replace(setting, name=name)
    return judge_file(replace(lecture(), claims=tuple(claims), settings=settings), MODELS)


def offered(verdict: ClaimVerdict, relation: Relation) -> list[Sides]:
    """All repairs as trees."""
    texts = [repair["latex"] for repair in verdict.repairs]
    setting = next(c.setting for c in lecture().claims if relation.name.endswith(" " + c.id))
    table = lecture().settings[setting].symbols
    found = [read_formula(text, table).readings[0].relations[0] for text in texts]
    return [(to_tree(r.left), to_tree(r.right)) for r in found]


@pytest.mark.parametrize("name", cases(NAMES, lambda name: name in NAMES[::12]))
def test_offers_are_true_and_say_something(name: str) -> None:
    relation = relations()[name]
    mutants = misprinted(relation)
    assert len(mutants) >= EACH / 2
    repaired = 0
    for verdict in judged(relation, mutants):
        offers = offered(verdict, relation)
        repaired += bool(offers)
        for left, right in offers:
            assert left != right, verdict.repair
            # under one model at least: a misprint of a row may be another row's formula
            true = [
                subject
                for subject in relation.subjects
                if not is_false(replace(relation, subjects=(subject,)), left, right)
            ]
            assert true, (verdict.latex, verdict.repair)
            assert symbols(left) | symbols(right)
    assert repaired >= 0.8 * len(mutants)
