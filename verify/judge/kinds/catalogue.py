"""All kinds of claims that are decided, and the finding on a claim of any of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.claim.symbols import definition_uses
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.points import with_values
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.asymptotics import judge_asymptotics
from gainproof.verify.judge.kinds.definition import judge_definition
from gainproof.verify.judge.kinds.determines import judge_determines
from gainproof.verify.judge.kinds.equivalence import judge_equivalence
from gainproof.verify.judge.kinds.identity import judge_identity
from gainproof.verify.judge.kinds.implication import judge_implication
from gainproof.verify.judge.kinds.limit import judge_limit
from gainproof.verify.judge.kinds.location import judge_location
from gainproof.verify.judge.kinds.monotone import judge_monotone
from gainproof.verify.judge.kinds.optimum import judge_optimum
from gainproof.verify.judge.kinds.ordering import judge_ordering
from gainproof.verify.judge.kinds.solutions import judge_solutions
from gainproof.verify.judge.kinds.stability import judge_stability
from gainproof.verify.judge.kinds.steady_state import judge_steady_state
from gainproof.verify.judge.kinds.value import judge_value
from gainproof.verify.judge.meaning.value import entries
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.quantities import common_quantities, model_data
from gainproof.verify.judge.verdict import Finding

Judge = Callable[[Claim, Reading, Scope], Finding]


@dataclass(frozen=True)
class Kind:
    """A kind of claim and how it is decided; `in_fields` says that it needs no formula."""

    name: str
    judge: Judge
    in_fields: bool = False


KINDS = (
    Kind("identity", judge_identity),
    Kind("inequality", judge_identity),
    Kind("recursion", judge_identity),
    Kind("definition", judge_definition),
    Kind("implication", judge_implication),
    Kind("equivalence", judge_equivalence),
    Kind("limit", judge_limit),
    Kind("asymptotics", judge_asymptotics),
    Kind("value", judge_value),
    Kind("monotone", judge_monotone, in_fields=True),
    Kind("location", judge_location, in_fields=True),
    Kind("solutions", judge_solutions),
    Kind("steady_state", judge_steady_state),
    Kind("determines", judge_determines, in_fields=True),
    Kind("stability", judge_stability, in_fields=True),
    Kind("optimum", judge_optimum),
    Kind("ordering", judge_ordering, in_fields=True),
)
NO_FORMULA = Reading(())
MOST_ENTRIES = 16
"""Of a matrix that is kept entry by entry."""


def judge_reading(claim: Claim, reading: Reading | None, scope: Scope) -> Finding:
    """The finding on a claim under one reading of its formula, None where it has no formula.

    Raises Undecided, UndefinedSymbol, Malformed.
    """
    finding = _kind(claim, reading).judge(claim, reading or NO_FORMULA, scope)
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
    others = {
        token: value
        for token, value in used.items()
        if token not in meanings and (value.kind != "symbol" or several[value.key] > 1)
    }
    symbols = scope.setting.symbols
    for token, matrix in scope.used.items():
        named = symbols[token].role == "quantity" or token in environment.assigned
        if not named and not isinstance(matrix, Expr) and len(entries(matrix)) <= MOST_ENTRIES:
            for i, row in enumerate(matrix, 1):
                others |= {f"{token}[{i}, {j}]": e for j, e in enumerate(row, 1)}
    found: dict[str, Any] = {}
    if meanings:
        parameters = {expr.key for expr in common_quantities().values()}
        found["quantities"] = {token: graph_of(expr) for token, expr in meanings.items()}
        quantities = {token: symbols[token].quantity or "" for token in meanings}
        found |= model_data(environment, {**meanings, **others}, quantities)
        found["of the filter"] = [
            token
            for token, expr in meanings.items()
            if token not in environment.assigned and expr.key not in parameters
        ]
    means = [token for token in scope.used if "expectation" in definition_uses(symbols[token])]
    found |= {"means": means} if means else {}
    functions = {
        token: entry.definition.latex
        for token, entry in symbols.items()
        if entry.arguments and entry.definition is not None
    }
    found |= {"functions": functions} if functions else {}
    if others:
        found["other symbols"] = {token: graph_of(value) for token, value in others.items()}
    return found


def _meanings(scope: Scope) -> dict[str, Expr]:
    """The quantities of the setting that are no variables."""
    return {
        token: value
        for token, value in scope.used.items()
        if isinstance(value, Expr)
        and value.kind != "symbol"
        and (scope.setting.symbols[token].role == "quantity" or token in scope.environment.assigned)
    }


def _kind(claim: Claim, reading: Reading | None) -> Kind:
    """What is said decides where it can be seen: an arrow makes a limit, `<=>` an equivalence."""
    name = claim.kind
    if name in ("identity", "inequality", "recursion", "definition") and reading is not None:
        if any(r.operator == "->" for r in (*reading.relations, *reading.conditions)):
            name = "limit"
        elif reading.connective in ("iff", "implies"):
            name = "equivalence" if reading.connective == "iff" else "implication"
    found = next((kind for kind in KINDS if kind.name == name), None)
    if found is None or (reading is None and not found.in_fields):
        raise Undecided(f"a claim of kind {claim.kind} in words is not covered")
    return found
