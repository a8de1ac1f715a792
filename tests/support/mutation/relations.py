"""True relations to break: those of the derivations and those of the claim files."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath
from catalogue_subjects import derived

from gainproof.derive.catalogue import CATALOGUE
from gainproof.verify.judge.claim.file import read_claim_file
from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.derivations.relation import judge_relation
from gainproof.verify.judge.derivations.surroundings import Surroundings, surroundings
from gainproof.verify.judge.formula import Relation as Printed
from gainproof.verify.judge.judge import judge_setting
from gainproof.verify.judge.setting.quantities import steady_state
from gainproof.verify.judge.verdict import Finding
from mutation.campaign import INDEX_POINTS, SAMPLE_POINTS, Relation
from mutation.evaluator import Subject, memory_subject, steady_subject
from mutation.tree import Tree, number, symbols, to_graph, to_tree

DEGREES = {"least-squares-mean": 0, "least-squares-line": 1, "least-squares-parabola": 2}
SHORT = ("kappa", "rho", "psi", "chi")
"""Names of the derivations that no oracle gives a value."""
UNKNOWN_TO_ORACLES = ("information_", "pole", "program")
KNOWN_OF_THREE_STATES = ("alpha", "beta", "gamma", "predicted_", "updated_", "tracking_index")
"""Of three states the oracles give these, and no value of the tower's parameter."""
CLAIMS = Path(__file__).parents[3] / "verify" / "claims"


def derived_relations() -> Iterator[Relation]:
    """Equations of every derivation whose symbols the oracles know, where one quantity is
    measured.
    """
    for entry in CATALOGUE:
        found = derived(entry.name)
        degree = DEGREES.get(entry.name)
        model = found.model if degree is None else None
        if degree is None and (model is None or not _of_one_measurement(model)):
            continue
        written = found.certificate
        towers = written["towers"]
        solved = steady_state(model) if model else None
        around = {n: surroundings(model, degree, tower, solved) for n, tower in towers.items()}
        for statement in written["statements"]:
            place = statement["tower"]
            states = len(model["transition"]) if model else 0
            if statement["kind"] == "equal" and _known(statement, towers[place], states):
                yield _derived(entry.name, statement, towers[place], model, degree, around[place])


def _of_one_measurement(model: Mapping[str, Any]) -> bool:
    return len(model["measurement"]) == 1


def _known(statement: Mapping[str, Any], tower: Mapping[str, Any], states: int) -> bool:
    """The oracles give the tracking index itself, and so know the main tower, whose parameter is
    its root, only.
    """
    left, right = (to_tree(statement["claim"][side]) for side in ("left", "right"))
    names = symbols(left) | symbols(right)
    if any(name.startswith(UNKNOWN_TO_ORACLES) for name in names):
        return False
    if states == 3 and not all(name.startswith(KNOWN_OF_THREE_STATES) for name in names):
        return False
    at_start = any(
        part[0] == "at" for side in ("left", "right") for part in statement["claim"][side]["nodes"]
    )
    if at_start or any(name.startswith("predicted") for name in names if "k" in _parameters(tower)):
        return False
    return _parameters(tower) in (["p"], ["k"])


def _parameters(tower: Mapping[str, Any]) -> list[str]:
    return [p["symbol"] for p in tower["parameters"]]


def _derived(
    family: str,
    statement: Mapping[str, Any],
    tower: Mapping[str, Any],
    model: Any,
    degree: int | None,
    around: Surroundings,
) -> Relation:
    claim = statement["claim"]
    names = tuple(claim.get("free", ()))
    free = {name: mpmath.mpf(n + 2) / 7 + 1 for n, name in enumerate(names)}
    left, right = to_tree(claim["left"]), to_tree(claim["right"])

    def judge(a: Tree, b: Tree) -> Finding:
        return judge_relation(to_graph(a), to_graph(b), around=around, free=names)

    if degree is not None:
        subject, points, variable = memory_subject(degree, free), SAMPLE_POINTS, "k"
    else:
        subject, points, variable = (
            steady_subject(model, _roots(tower), free, _short(tower)),
            INDEX_POINTS,
            "tracking_index",
        )
    return Relation(f"{family} {statement['id']}", left, right, variable, (subject,), points, judge)


def _roots(tower: Mapping[str, Any]) -> dict[str, tuple[int, Tree]]:
    """The tower's parameter p is the root of the index; each generator the root of its radicand."""
    found: dict[str, tuple[int, Tree]] = {"p": (2, ("symbol", "tracking_index"))}
    for generator in tower["generators"]:
        found[generator["symbol"]] = (generator["power"], _sum(generator["radicand"], tower))
    return found


def _short(tower: Mapping[str, Any]) -> dict[str, Tree]:
    """The names of a derivation's own that stand for an expression of the index and the roots."""
    return {
        name: ("div", *(_sum(tower["elements"][name][part], tower) for part in ("num", "den")))
        for name in SHORT
        if name in tower["elements"]
    }


def _sum(polynomial: Sequence[Any], tower: Mapping[str, Any]) -> Tree:
    names = ["p", *[g["symbol"] for g in tower["generators"]]]
    terms: list[Tree] = []
    for coefficient, exponents in polynomial:
        powers = [
            ("pow", ("symbol", n), Fraction(e)) for n, e in zip(names, exponents, strict=True) if e
        ]
        terms.append(("mul", number(coefficient), *powers))
    return ("add", number(0), *terms)


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
    built = [derived(e.name).model for e in CATALOGUE if e.name not in DEGREES]
    models = [model for model in built if model is not None and _of_one_measurement(model)]
    for path in sorted(CLAIMS.glob("*.toml")):
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
            if not all(quantities.get(t) in QUANTITY_NAMES for t in claim.formula.symbols):
                continue
            yield _claimed(path.stem, claim, setting, models)


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
