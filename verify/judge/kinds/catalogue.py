"""All kinds of claims that are decided, and the finding on a claim of any of them."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import Any

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.claim.symbols import definition_uses
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.exact.rational_points import with_values
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Formula, Reading
from gainproof.verify.judge.kinds.asymptotics import ASYMPTOTICS
from gainproof.verify.judge.kinds.definition import DEFINITION
from gainproof.verify.judge.kinds.determines import DETERMINES
from gainproof.verify.judge.kinds.equivalence import EQUIVALENCE
from gainproof.verify.judge.kinds.identity import IDENTITY, INEQUALITY, ORDERS, RECURSION
from gainproof.verify.judge.kinds.implication import IMPLICATION
from gainproof.verify.judge.kinds.kind import Judge, Kind
from gainproof.verify.judge.kinds.limit import LIMIT
from gainproof.verify.judge.kinds.location import LOCATION
from gainproof.verify.judge.kinds.monotone import MONOTONE
from gainproof.verify.judge.kinds.optimum import OPTIMUM
from gainproof.verify.judge.kinds.ordering import ORDERING
from gainproof.verify.judge.kinds.solutions import SOLUTIONS
from gainproof.verify.judge.kinds.stability import STABILITY
from gainproof.verify.judge.kinds.steady_state import STEADY_STATE
from gainproof.verify.judge.kinds.value import VALUE
from gainproof.verify.judge.matrices.claim_fields import OF_MATRICES
from gainproof.verify.judge.meaning.value import entries
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.quantities import common_quantities, model_data
from gainproof.verify.judge.verdict import Finding

KINDS = (
    IDENTITY,
    INEQUALITY,
    DEFINITION,
    RECURSION,
    LIMIT,
    ASYMPTOTICS,
    VALUE,
    MONOTONE,
    LOCATION,
    SOLUTIONS,
    STEADY_STATE,
    IMPLICATION,
    EQUIVALENCE,
    DETERMINES,
    STABILITY,
    OPTIMUM,
    ORDERING,
    *OF_MATRICES,
    Kind(
        "remark",
        "nothing that can be decided; `note` says why",
        needs_formula=False,
        needs_text=True,
        not_decided="no decidable content",
        settings="any",
    ),
)
"""In the order of docs/claim-files.md."""
_BY_NAME = {kind.name: kind for kind in KINDS}
NO_FORMULA = Reading(())
MOST_ENTRIES = 16
"""Of a matrix that is kept entry by entry."""


def kind_named(name: str) -> Kind:
    """The kind of this name. Raises KeyError."""
    return _BY_NAME[name]


def kind_of(formula: Formula) -> str:
    """The kind of claim that a formula is, as far as its relations say it."""
    reading = formula.readings[0]
    operators = {relation.operator for relation in reading.relations}
    if reading.connective in ("iff", "implies"):
        return "equivalence" if reading.connective == "iff" else "implication"
    if "->" in operators or any(each.operator == "->" for each in reading.conditions):
        orders = any(
            node[:2] == ["call", "order"]
            for relation in reading.relations
            for node in relation.right["nodes"]
        )
        return "asymptotics" if orders or "sim" in operators else "limit"
    if "approx" in operators:
        return "value"
    return "inequality" if operators & ORDERS else "identity"


def judge_reading(claim: Claim, reading: Reading | None, scope: Scope) -> Finding:
    """The finding on a claim under one reading of its formula, None where it has no formula.

    Raises Undecided, UndefinedSymbol, Malformed.
    """
    finding = _judge(claim, reading)(claim, reading or NO_FORMULA, scope)
    if finding.certificate:
        finding = replace(finding, certificate={**finding.certificate, **symbols_data(scope)})
    meanings = _meanings(scope)
    if meanings and finding.witness is not None:
        finding = replace(finding, witness=with_values(finding.witness, meanings, scope.labels()))
    return finding


def symbols_data(scope: Scope) -> dict[str, Any]:
    """What the symbols met so far stand for, as plain data of a certificate; matrices entry by
    entry, under "K[1, 2]"; which are defined by an expectation.
    """
    meanings, environment = _meanings(scope), scope.environment
    used = {token: value for token, value in scope.used.items() if isinstance(value, Expr)}
    several = Counter(value.key for value in used.values())
    found: dict[str, Any] = {}
    if meanings:
        parameters = {expr.key for expr in common_quantities().values()}
        found["quantities"] = {token: graph_of(expr) for token, expr in meanings.items()}
        found |= model_data(environment, meanings)
        found["of the filter"] = [
            token
            for token, expr in meanings.items()
            if token not in environment.assigned and expr.key not in parameters
        ]
    others = {
        token: graph_of(value)
        for token, value in used.items()
        if token not in meanings and (value.kind != "symbol" or several[value.key] > 1)
    }
    symbols = scope.setting.symbols
    means = [token for token in scope.used if "expectation" in definition_uses(symbols[token])]
    found |= {"means": means} if means else {}
    for token, value in scope.used.items():
        named = symbols[token].role == "quantity" or token in environment.assigned
        if not named and not isinstance(value, Expr) and len(entries(value)) <= MOST_ENTRIES:
            for i, row in enumerate(value, 1):
                others |= {f"{token}[{i}, {j}]": graph_of(e) for j, e in enumerate(row, 1)}
    return {**found, "other symbols": others} if others else found


def _meanings(scope: Scope) -> dict[str, Expr]:
    """The quantities of the setting that are no variables."""
    return {
        token: value
        for token, value in scope.used.items()
        if isinstance(value, Expr)
        and value.kind != "symbol"
        and (scope.setting.symbols[token].role == "quantity" or token in scope.environment.assigned)
    }


def _judge(claim: Claim, reading: Reading | None) -> Judge:
    """What is said decides where it can be seen: an arrow makes a limit, `<=>` an equivalence."""
    name = claim.kind
    if name in ("identity", "inequality", "recursion", "definition") and reading is not None:
        if any(r.operator == "->" for r in (*reading.relations, *reading.conditions)):
            name = "limit"
        elif reading.connective in ("iff", "implies"):
            name = "equivalence" if reading.connective == "iff" else "implication"
    kind = _BY_NAME[name]
    if kind.judge is None or (reading is None and kind.needs_formula):
        raise Undecided(f"a claim of kind {claim.kind} in words is not covered")
    return kind.judge
