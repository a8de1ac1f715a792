"""A changed formula printed and read again: what is offered is what was read back and judged."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from gainproof.verify.judge.claim.record import Claim, Setting, SymbolEntry
from gainproof.verify.judge.claim_decision import judge_claim
from gainproof.verify.judge.formula import Formula, Reading, Relation
from gainproof.verify.judge.kinds.catalogue import kind_named
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.latex_printer import reading_to_latex
from gainproof.verify.judge.reader.reader import read_formula
from gainproof.verify.judge.repair.printed_formula import Printed
from gainproof.verify.judge.repair.whole_formula import Change
from gainproof.verify.judge.setting.environment import Environment


@dataclass(frozen=True)
class Offer:
    """A proved formula near a claim."""

    formula: Formula
    change: Change
    environment: str


def reread(formula: Printed | Reading, symbols: Mapping[str, SymbolEntry]) -> Formula | None:
    """The formula as the reader reads its own print; None if it has no print with one reading."""
    try:
        reading = formula if isinstance(formula, Reading) else formula.reading()
        latex = reading_to_latex(reading)
        read = read_formula(latex, symbols)
    except (ReaderError, ValueError, KeyError):
        return None
    return read if len(read.readings) == 1 else None


def with_formula(claim: Claim, formula: Formula) -> Claim:
    """The claim with another formula."""
    return replace(claim, latex=formula.latex, formula=formula)


def is_proved(claim: Claim, setting: Setting, environment: Environment) -> bool:
    """Whether the judge proves the claim on its whole domain."""
    return judge_claim(claim, setting, environment).verdict == "proved"


def is_of_use(claim: Claim, setting: Setting, environment: Environment) -> bool:
    """Whether the judge proves the claim, and an implication or equivalence connects something:
    its second part does not hold by itself, nor its first part nowhere.
    """
    if not is_proved(claim, setting, environment):
        return False
    formula = claim.formula
    if formula is None or len(formula.readings) != 1:
        return True
    (reading,) = formula.readings
    if not kind_named(claim.kind).two_parts and reading.connective == "if":
        return True

    def alone(relations: tuple[Relation, ...]) -> str:
        part = replace(formula, readings=(Reading(relations),))
        return judge_claim(
            replace(claim, kind="inequality", formula=part), setting, environment
        ).verdict

    may_be_thin = any(r.operator == "=" for r in reading.relations)
    is_never = not may_be_thin and alone(reading.relations) == "refuted"
    return not is_never and alone(reading.conditions) != "proved"


def standing(claim: Claim, setting: Setting, environment: Environment) -> str | None:
    """`proved`, or `conditional` for a claim that fails only where a side has no value."""
    finding = judge_claim(claim, setting, environment)
    witness = finding.witness
    if finding.verdict == "proved":
        return "proved"
    if finding.verdict != "conditional" or witness is None:
        return None
    return "conditional" if witness.left.undefined or witness.right.undefined else None
