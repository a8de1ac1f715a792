"""Definitions against their use: a definition whose dimension no claim can use is at fault itself,
and not the claims.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.claim.record import Claim, Setting, Unit
from gainproof.verify.judge.claim.units import unit_text_of
from gainproof.verify.judge.claim_symbols import names_in
from gainproof.verify.judge.dimensions.formula import dimension_of, reading_fault
from gainproof.verify.judge.formula import Formula
from gainproof.verify.judge.kinds.definition import defined_token
from gainproof.verify.judge.verdict import ClaimVerdict

NAMED = {
    Unit(): "a number",
    Unit(metre=Fraction(1)): "a length",
    Unit(second=Fraction(1)): "a time",
    Unit(second=Fraction(-1)): "a rate",
    Unit(metre=Fraction(2)): "a squared length",
    Unit(Fraction(1), Fraction(-1)): "a velocity",
    Unit(Fraction(1), Fraction(-2)): "an acceleration",
    Unit(Fraction(1), Fraction(-3)): "a jerk",
    Unit(Fraction(2), Fraction(-2)): "a squared velocity",
    Unit(Fraction(2), Fraction(-4)): "a squared acceleration",
}
_MOTIONS = tuple(
    Unit(Fraction(metre), Fraction(second)) for metre in range(-4, 5) for second in range(-6, 7)
)


def in_words(unit: Unit) -> str:
    """`a velocity (m s^-1)`."""
    name = NAMED.get(unit, "a quantity")
    return f"{name} ({unit_text_of(unit)})" if unit != Unit() else name


def _tried(setting: Setting) -> Iterator[Unit]:
    """Units that a use may need: of motions, times what else the symbols of the setting have."""
    others = {
        replace(entry.unit, metre=Fraction(0), second=Fraction(0))
        for entry in setting.symbols.values()
        if entry.unit is not None
    }
    for other in sorted({Unit(), *others, *(unit**-1 for unit in others)}, key=unit_text_of):
        yield from (motion * other for motion in _MOTIONS)


def contradicted(claim: Claim, setting: Setting, claims: Sequence[Claim]) -> str | None:
    """Why the dimension of a definition contradicts its use, the uses named; None if it does not.

    It does if some use needs another dimension and none can do with that of the definition.
    """
    token = defined_token(claim, setting)
    if token is None or claim.formula is None:
        return None
    right = claim.formula.readings[0].relations[0].right
    if token in names_in(right):
        return None
    unit = dimension_of(right, setting)
    if unit is None:
        return None
    against: list[str] = []
    for place, formula in _uses(token, claim, setting, claims):
        if _agrees(formula, token, unit, setting):
            return None
        wanted = [u for u in _tried(setting) if _agrees(formula, token, u, setting)]
        if wanted:
            needed = in_words(wanted[0]) if len(wanted) == 1 else "something else"
            against.append(f"{place} uses it as {needed}")
    if not against:
        return None
    return f"dimensions: {token} is defined as {in_words(unit)}, but " + ", ".join(against)


def _uses(
    token: str, claim: Claim, setting: Setting, claims: Iterable[Claim]
) -> Iterator[tuple[str, Formula]]:
    """Formulas of claims and of other definitions in which the symbol stands, and their place."""
    for other in claims:
        is_other = other.setting == claim.setting and other.id != claim.id
        formula = other.formula
        is_use = is_other and defined_token(other, setting) != token
        if is_use and formula is not None and token in formula.symbols:
            yield f"claim {other.id}", formula
    for name, entry in setting.symbols.items():
        known = entry.definition if name != token and entry.unit is not None else None
        if known is not None and token in known.symbols:
            yield f"the definition of {name}", known


def _agrees(formula: Formula, token: str, unit: Unit, setting: Setting) -> bool:
    """Whether some reading of a formula has agreeing dimensions if the symbol has this one."""
    entry = replace(setting.symbols[token], unit=unit, definition=None, arguments=())
    changed = replace(setting, symbols={**setting.symbols, token: entry})
    return any(reading_fault(reading, changed) is None for reading in formula.readings)


def with_blame(
    verdicts: Sequence[ClaimVerdict], claims: Sequence[Claim], setting: Setting
) -> list[ClaimVerdict]:
    """Verdicts in which claims refuted for their dimensions name the definition at fault."""
    by_id = {claim.id: claim for claim in claims}
    refuted = [v.id for v in verdicts if v.verdict == "refuted" and v.method == "dimensions"]
    faulty = {
        token: name
        for name in refuted
        if (token := defined_token(by_id[name], setting)) is not None
    }
    found = []
    for verdict in verdicts:
        formula = by_id[verdict.id].formula
        used = [t for t in faulty if formula is not None and t in formula.symbols]
        if verdict.id in refuted and verdict.id not in faulty.values() and used:
            told = "; ".join(f"the definition of {t} is at fault, claim {faulty[t]}" for t in used)
            verdict = replace(verdict, reason=f"{verdict.reason}; {told}")
        found.append(verdict)
    return found
