"""Quick refutations under a convention: of a claim whose dimensions disagree, or that fails at two
generic points, which a simple one then shows.
"""

from __future__ import annotations

from dataclasses import replace

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.convention import Convention
from gainproof.verify.judge.dimensions.claim import claim_readings, degrees_are_open
from gainproof.verify.judge.exact.certificate import statement_data
from gainproof.verify.judge.exact.rational_points import try_points
from gainproof.verify.judge.exact.statement import ALLOWED, Statement
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.catalogue import symbols_data
from gainproof.verify.judge.repair.formula_values import Values, truth
from gainproof.verify.judge.repair.generic_points import generic_points
from gainproof.verify.judge.repair.printed_formula import printed
from gainproof.verify.judge.scope import Scope, UndefinedSymbol
from gainproof.verify.judge.setting.environment import Environment, NotEstablished
from gainproof.verify.judge.verdict import Finding, finding_of

KINDS = ("identity", "inequality")


def seen_false(claim: Claim, convention: Convention) -> Finding | None:
    """The refutation of a claim that fails at generic points in every reading; None for others."""
    if claim.formula is None:
        return None
    readings, fault = claim_readings(claim, convention.setting)
    if fault is not None and degrees_are_open(claim, convention.setting) is not None:
        return None
    if fault is not None:
        return Finding("refuted", fault, method="dimensions")
    found: Finding | None = None
    for reading in readings:
        finding = seen_to_fail(claim, reading, convention.setting, convention.environment)
        if finding is None:
            return None
        found = found or finding
    return found


def seen_to_fail(
    claim: Claim, reading: Reading, setting: Setting, environment: Environment
) -> Finding | None:
    """The refutation of one reading, whatever its dimensions are; None if none is seen."""
    if claim.kind not in KINDS or claim.given:
        return None
    try:
        return _refuted(claim, reading, setting, environment)
    except (Undecided, Malformed, NotEstablished, UndefinedSymbol, ArithmeticError):
        return None


def _refuted(
    claim: Claim, reading: Reading, setting: Setting, environment: Environment
) -> Finding | None:
    printed_relations = (*reading.relations, *reading.conditions, *claim.domain)
    plain = all(r.operator in ALLOWED for r in printed_relations)
    if reading.connective != "if" or not plain:
        return None
    scope = Scope(setting, environment, held=claim.held)
    relations = tuple(scope.relation(r) for r in reading.relations)
    stated = tuple(scope.relation(r) for r in (*reading.conditions, *claim.domain))
    points, put_in = generic_points(claim, reading.conditions, scope, 2)
    formula = printed(reading)
    failing = [p for p in points if truth(Values(scope, p, put_in), formula) is False]
    if put_in or len(failing) < 2:
        return None
    if scope.uses_steady() and environment.region is not None:
        stated = (*stated, *environment.region.relations)
    domains = [r for token in scope.used for r in setting.symbols[token].domain]
    conditions = (*stated, *[scope.relation(r) for r in domains])
    statement, boxes, labels = Statement(relations, conditions), scope.boxes(), scope.labels()
    outcome = try_points(statement, boxes, labels)
    if outcome is None or outcome.verdict != "refuted":
        return None
    own = {name: box for name, box in boxes.items() if name in statement.symbols()}
    asked = statement_data(statement, own, environment.parameter, labels)
    return replace(finding_of(outcome), certificate={"asked": asked, **symbols_data(scope)})
