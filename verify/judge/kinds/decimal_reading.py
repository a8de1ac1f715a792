"""Equations with a decimal number: whether it is taken as rounded or as exact."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.formula import Reading, Relation
from gainproof.verify.judge.kinds.value import judge_value
from gainproof.verify.judge.reader.latex_printer import graph_to_latex
from gainproof.verify.judge.reader.printing import with_decimals
from gainproof.verify.judge.scope import Scope, UndefinedSymbol
from gainproof.verify.judge.setting.environment import Environment, NotEstablished
from gainproof.verify.judge.verdict import Finding
from gainproof.verify.judge.verdict_words import ROUNDED

HOW = {"value": "rounded to its digits", "identity": "an exact number"}
"""How a decimal after `=` is read, by the kind of the claim."""


def decimals_read(claim: Claim, reading: Reading) -> str | None:
    """How the decimals of equations are read, for the reading of a verdict; None without any."""
    found = [
        with_decimals(graph, graph_to_latex(graph), decimals)
        for rel in reading.relations
        for graph, decimals in ((rel.left, rel.left_decimals), (rel.right, rel.right_decimals))
        if rel.operator == "=" and isinstance(decimals, int) and decimals > 0
    ]
    if not found or claim.kind not in HOW:
        return None
    return f"{' and '.join(dict.fromkeys(found))} is {HOW[claim.kind]}"


def with_rounded(
    finding: Finding, claim: Claim, reading: Reading, setting: Setting, environment: Environment
) -> Finding:
    """An equation that is not true of the exact decimal, with a note if it is of a rounded one."""
    if finding.verdict not in ("refuted", "conditional") or claim.kind != "identity":
        return finding
    if not any(_has_decimals(rel) for rel in reading.relations):
        return finding
    scope = Scope(setting, environment, held=claim.held)
    try:
        found = judge_value(claim, reading, scope)
        value = _exact(finding, reading, scope)
    except (Undecided, Malformed, NotEstablished, UndefinedSymbol, ArithmeticError, ValueError):
        return finding
    if found.verdict != "proved":
        return finding
    what = "the other side " if value is None else f"{value} "
    note = f"{what}rounded to these digits: a claim of kind value has it"
    return replace(finding, certificate={**finding.certificate, ROUNDED: note})


def _has_decimals(rel: Relation) -> bool:
    shown = [
        d if isinstance(d, tuple) else (d or 0,) for d in (rel.left_decimals, rel.right_decimals)
    ]
    return rel.operator == "=" and max(map(max, shown)) > 0


def _exact(finding: Finding, reading: Reading, scope: Scope) -> Fraction | None:
    """The other side at the witness, where it is one rational number."""
    names = {label: name for name, label in scope.labels().items()}
    point = {} if finding.witness is None else finding.witness.point
    put_in = {names.get(label, label): number(Fraction(value)) for label, value in point.items()}
    relation = reading.relations[0]
    other = scope.value(relation.left if relation.right_decimals is not None else relation.right)
    return constant_value(substituted(other, put_in)) if isinstance(other, Expr) else None
