"""Claims that follow from the file's own definitions, whatever the filter is."""

from __future__ import annotations

from dataclasses import replace

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.convention import Convention
from gainproof.verify.judge.convention_effect import Chosen
from gainproof.verify.judge.exact.limits import Malformed, Undecided
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.catalogue import judge_reading
from gainproof.verify.judge.pruning import seen_false
from gainproof.verify.judge.reach import graphs_of_claim, reached
from gainproof.verify.judge.scope import Scope, UndefinedSymbol
from gainproof.verify.judge.setting.environment import NotEstablished, algebra

WITH_MODEL = ("steady_state", "growing_memory", "fading_memory", "kalman_bucy", "fixed_gain")
EQUATIONS, ORDERS = "identity", "inequality"
FEW = 2
"""Symbols of an order that is looked at: it is decided over cells, which takes time."""


def holds_for_any_filter(claim: Claim, reading: Reading | None, setting: Setting) -> bool:
    """Whether a claim that is proved of a filter is proved of any numbers in place of its
    quantities too; False also where that is not known, and where the claim differentiates, since
    what a quantity changes with is a matter of the filter.
    """
    if reading is None or setting.kind not in WITH_MODEL or reading.connective != "if":
        return False
    used = reached(claim, setting)
    plain = claim.kind == EQUATIONS or (claim.kind == ORDERS and len(used) <= FEW)
    if not plain or any(n[0] == "derivative" for g in graphs_of_claim(claim) for n in g["nodes"]):
        return False
    symbols = {
        token: replace(entry, role="free", quantity=None) if entry.quantity else entry
        for token, entry in setting.symbols.items()
    }
    free = replace(setting, kind="algebra", model=None, own_model=None, symbols=symbols)
    try:
        # most are false at two points of their own: no more is asked of these
        if seen_false(claim, Convention(algebra(), free, open=False, chosen=Chosen())) is not None:
            return False
        found = judge_reading(claim, reading, Scope(free, algebra(), held=claim.held))
    except (Undecided, Malformed, NotEstablished, UndefinedSymbol, ArithmeticError, ValueError):
        return False
    return found.verdict == "proved"
