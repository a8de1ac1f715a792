"""A changed formula printed and read again: what is offered is what was read back and judged."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from gainproof.verify.judge.attempt import judge_claim
from gainproof.verify.judge.claim_record import Claim, Setting, SymbolEntry
from gainproof.verify.judge.formula import Formula
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.latex import reading_to_latex
from gainproof.verify.judge.reader.reader import read_formula
from gainproof.verify.judge.repair.printed import Printed
from gainproof.verify.judge.repair.whole import Change
from gainproof.verify.judge.setting.environment import Environment


@dataclass(frozen=True)
class Offer:
    """A proved formula near a claim."""

    formula: Formula
    change: Change
    environment: str


def reread(formula: Printed, symbols: Mapping[str, SymbolEntry]) -> Formula | None:
    """The formula as the reader reads its own print; None if it has no print with one reading."""
    try:
        latex = reading_to_latex(formula.reading())
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


def standing(claim: Claim, setting: Setting, environment: Environment) -> str | None:
    """`proved`, or `conditional` for a claim that fails only where a side has no value."""
    finding = judge_claim(claim, setting, environment)
    witness = finding.witness
    if finding.verdict == "proved":
        return "proved"
    if finding.verdict != "conditional" or witness is None:
        return None
    return "conditional" if witness.left.undefined or witness.right.undefined else None
