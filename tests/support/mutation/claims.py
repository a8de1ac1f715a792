"""True relations to break from the claim files: identities about gains."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

from catalogue_subjects import derived

from gainproof.derive.catalogue import CATALOGUE
from gainproof.verify.judge.claim.file import read_claim_file
from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.formula import Relation as Printed
from gainproof.verify.judge.judge import judge_setting
from gainproof.verify.judge.verdict import Finding
from mutation.campaign import INDEX_POINTS, SAMPLE_POINTS, Relation
from mutation.evaluator import Subject, memory_subject, steady_subject
from mutation.tree import Tree, to_graph, to_tree

CLAIMS = Path(__file__).parents[3] / "verify" / "claims"
QUANTITY_NAMES = {
    "filter_gain.1": "alpha",
    "filter_gain.2": "beta",
    "filter_gain.3": "gamma",
    "sample_number": "k",
}


def claimed_relations() -> Iterator[Relation]:
    """Identities of the claim files about gains; for a searched model a mutant must be false under
    all models.
    """
    built = [derived(entry.name).model for entry in CATALOGUE]
    models = [m for m in built if m is not None and len(m["measurement"]) == 1]
    for path in sorted(CLAIMS.glob("*.toml")):
        for claim, setting in _about_gains(path):
            yield _claimed(path.stem, claim, setting, models)


def claimed_names(source: str) -> list[str]:
    """The names of those of one source; nothing is derived for it."""
    return [f"{source} {claim.id}" for claim, _ in _about_gains(CLAIMS / f"{source}.toml")]


def _about_gains(path: Path) -> Iterator[tuple[Claim, Setting]]:
    claim_file = read_claim_file(path)
    for claim in claim_file.claims:
        setting = claim_file.settings[claim.setting]
        if (
            claim.kind != "identity"
            or claim.formula is None
            or setting.kind == "algebra"
            or claim.given
        ):
            continue
        quantities = {t: e.quantity for t, e in setting.symbols.items() if e.role == "quantity"}
        if all(quantities.get(t) in QUANTITY_NAMES for t in claim.formula.symbols):
            yield claim, setting


def _claimed(
    source: str, claim: Claim, setting: Setting, models: Sequence[Mapping[str, Any]]
) -> Relation:
    assert claim.formula is not None
    reading = claim.formula.readings[0]
    printed = reading.relations[0]
    left, right = to_tree(printed.left), to_tree(printed.right)
    tokens = {
        t: QUANTITY_NAMES[e.quantity]
        for t, e in setting.symbols.items()
        if e.quantity in QUANTITY_NAMES
    }

    def judge(a: Tree, b: Tree) -> Finding:
        changed = replace(reading, relations=(Printed("=", to_graph(a), to_graph(b)),))
        formula = replace(claim.formula, readings=(changed,))  # type: ignore[type-var]
        verdict = judge_setting(setting, [replace(claim, formula=formula)], models, solved)[0]
        return Finding(verdict.verdict, verdict.reason)

    solved: dict[Any, Any] = {}
    subjects: tuple[Subject, ...]
    if setting.kind == "growing_memory":
        assert setting.degree is not None
        subjects, points = (_renamed(memory_subject(setting.degree), tokens),), SAMPLE_POINTS
        variable = next(t for t, name in tokens.items() if name == "k")
    else:
        chosen = [m for m in models if setting.model in ("search", m["name"])]
        subjects, points = tuple(_renamed(steady_subject(m), tokens) for m in chosen), INDEX_POINTS
        variable = next(t for t, name in tokens.items() if name == "alpha")
    return Relation(f"{source} {claim.id}", left, right, variable, subjects, points, judge)


def _renamed(subject: Subject, tokens: Mapping[str, str]) -> Subject:
    variable = next((t for t, name in tokens.items() if name == subject.variable), subject.variable)

    def quantities(point: Fraction) -> Mapping[str, Any]:
        values = subject.quantities(point)
        return {token: values[name] for token, name in tokens.items() if name in values}

    return replace(subject, variable=variable, quantities=quantities)
