"""True relations to break: those of the derivations and those of the claim files."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from typing import Any

import mpmath
from catalogue_subjects import derived
from judged_derivations.relation import judge_relation
from judged_derivations.surroundings import Surroundings, surroundings

from gainproof.derive.catalogue import CATALOGUE
from gainproof.verify.judge.setting.environment import Environment
from gainproof.verify.judge.setting.quantities import steady_state
from gainproof.verify.judge.verdict import Finding
from mutation.campaign import INDEX_POINTS, SAMPLE_POINTS, Relation
from mutation.claims import claimed_relations
from mutation.evaluator import memory_subject, steady_subject
from mutation.three_states import NAMES as OF_THREE_STATES
from mutation.tree import Tree, number, symbols, to_graph, to_tree

__all__ = ["claimed_relations", "derived_relations"]

DEGREES = {"least-squares-mean": 0, "least-squares-line": 1, "least-squares-parabola": 2}
KNOWN_PARAMETERS = (["p"], ["k"])
"""Of towers over the index, its root or a number of samples."""
SHORT = ("kappa", "rho", "psi", "chi")
"""Names of the derivations that no oracle gives a value."""
UNKNOWN_TO_ORACLES = ("information_", "pole", "program")
GAINS_AND_COVARIANCES = ("alpha", "beta", "gamma", "predicted_", "updated_", "tracking_index")
KNOWN_OF_THREE_STATES = (*GAINS_AND_COVARIANCES, "innovation_", "predictor_", *OF_THREE_STATES)
"""Of three states the oracles give these, and no value of the tower's parameter and its roots."""


def derived_relations(whole: bool = False) -> Iterator[Relation]:
    """Equations of every derivation whose symbols the oracles know, where one quantity is
    measured. Of three states whose towers hold roots, which take the judge seconds each, those of
    gains, covariances and index alone, unless `whole`.
    """
    for entry in CATALOGUE:
        found = derived(entry.name)
        degree = DEGREES.get(entry.name)
        model = found.model if degree is None else None
        if degree is None and (model is None or not _of_one_measurement(model)):
            continue
        written = found.certificate
        towers = written["towers"]
        around = _surroundings(model, degree, towers)
        for statement in written["statements"]:
            place = statement["tower"]
            allowed = _allowed(model, towers[place], whole) if model else None
            if statement["kind"] == "equal" and _known(statement, towers[place], allowed):
                yield _derived(entry.name, statement, towers[place], model, degree, around)


def _surroundings(
    model: Mapping[str, Any] | None, degree: int | None, towers: Mapping[str, Any]
) -> Callable[[str], Surroundings]:
    """Those of a tower by its name, made when they are first asked for: few relations are judged
    of those that are collected.
    """

    @cache
    def solved() -> Environment | None:
        return steady_state(model) if model else None

    @cache
    def of(name: str) -> Surroundings:
        return surroundings(model, degree, towers[name], solved())

    return of


def _of_one_measurement(model: Mapping[str, Any]) -> bool:
    return len(model["measurement"]) == 1


def _allowed(
    model: Mapping[str, Any], tower: Mapping[str, Any], whole: bool
) -> tuple[str, ...] | None:
    """How the names begin that may occur; None: any."""
    if len(model["transition"]) != 3:
        return None
    return KNOWN_OF_THREE_STATES if whole or not tower["generators"] else GAINS_AND_COVARIANCES


def _known(
    statement: Mapping[str, Any], tower: Mapping[str, Any], allowed: tuple[str, ...] | None
) -> bool:
    """The oracles give the tracking index itself, and so know the main tower, whose parameter is
    its root, only.
    """
    left, right = (to_tree(statement["claim"][side]) for side in ("left", "right"))
    names = symbols(left) | symbols(right)
    if any(name.startswith(UNKNOWN_TO_ORACLES) for name in names):
        return False
    given = names - set(statement["claim"]["free"])
    if allowed is not None and not all(name.startswith(allowed) for name in given):
        return False
    at_start = any(
        part[0] == "at" for side in ("left", "right") for part in statement["claim"][side]["nodes"]
    )
    if at_start or any(name.startswith("predicted") for name in names if "k" in _parameters(tower)):
        return False
    return _parameters(tower) in KNOWN_PARAMETERS


def _parameters(tower: Mapping[str, Any]) -> list[str]:
    return [p["symbol"] for p in tower["parameters"]]


def _derived(
    family: str,
    statement: Mapping[str, Any],
    tower: Mapping[str, Any],
    model: Any,
    degree: int | None,
    around: Callable[[str], Surroundings],
) -> Relation:
    claim = statement["claim"]
    names = tuple(claim.get("free", ()))
    free = {name: mpmath.mpf(n + 2) / 7 + 1 for n, name in enumerate(names)}
    left, right = to_tree(claim["left"]), to_tree(claim["right"])

    def judge(a: Tree, b: Tree) -> Finding:
        known = around(statement["tower"])
        return judge_relation(to_graph(a), to_graph(b), around=known, free=names)

    if degree is not None:
        subject, points, variable = memory_subject(degree, free), SAMPLE_POINTS, "k"
    else:
        three = len(model["transition"]) == 3
        roots, short = ({}, {}) if three else (_roots(tower), _short(tower))
        subject = steady_subject(model, roots, free, short)
        points, variable = INDEX_POINTS, "tracking_index"
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
