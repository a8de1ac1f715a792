"""Undefined symbols in verdicts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from gainproof.verify.judge.choice import verdict_of
from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.undefined.choice import Fixed
from gainproof.verify.judge.verdict import ClaimVerdict, Finding


def used_up_verdict(claim: Claim, fixed: Sequence[Fixed]) -> ClaimVerdict:
    """A claim that says what a symbol is defines it: it is not true or false beyond that."""
    symbol = next(s for s in fixed if s.consumed == claim.id)
    others = ", ".join(name for name in symbol.users if name != claim.id)
    reason = (
        f"used up to say what {symbol.token} is, which the source never defines: "
        f"{symbol.solution}, the only solution ({symbol.reason}); judged with it: {others}"
    )
    return verdict_of(claim, Finding("definition", reason), None, 0.0)


def with_symbols(verdict: ClaimVerdict, fixed: Sequence[Fixed]) -> ClaimVerdict:
    """The verdict with the undefined symbols that its claim uses."""
    mine = [symbol for symbol in fixed if verdict.id in symbol.users]
    if not mine:
        return verdict
    entries = tuple(symbol.entry() for symbol in mine)
    reason = verdict.reason
    if verdict.verdict == "undefined":
        reason = "; ".join(symbol.reason for symbol in mine if symbol.consumed is None)
    return replace(verdict, undefined=entries, reason=reason or verdict.reason)
