"""Definitions as printed, against what their symbol stands for in the setting: what all other
claims on it are about.
"""

from __future__ import annotations

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.exact.expression import Expr, symbol, symbols_of
from gainproof.verify.judge.exact.free_names import is_free
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.identity import judge_identity
from gainproof.verify.judge.kinds.kind import EQUATION, Kind
from gainproof.verify.judge.meaning.value import entries
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.verdict import Finding


def defined_token(claim: Claim, setting: Setting) -> str | None:
    """The symbol that a claim of kind definition defines: it stands alone on the left."""
    if claim.kind != "definition" or claim.formula is None:
        return None
    nodes = claim.formula.readings[0].relations[0].left["nodes"]
    token = str(nodes[0][1]) if len(nodes) == 1 and nodes[0][0] == "symbol" else None
    return token if token in setting.symbols else None


def compared_token(claim: Claim, setting: Setting) -> str | None:
    """The symbol or function that a definition is of, where the setting says what it is by its
    table or by its model.
    """
    token = defined_token(claim, setting)
    if token is None and claim.kind == "definition" and claim.formula is not None:
        last = claim.formula.readings[0].relations[0].left["nodes"][-1]
        token = str(last[1]) if last[0] == "call" and last[1] in setting.symbols else None
    if token is None or setting.symbols[token].role not in ("definition", "quantity"):
        return None
    return token


def is_as_declared(claim: Claim, setting: Setting) -> bool:
    """Whether the table of symbols has the very formula that is printed."""
    token = compared_token(claim, setting)
    entry = None if token is None else setting.symbols[token]
    if entry is None or entry.definition is None or claim.formula is None:
        return False
    declared = [reading.relations[0] for reading in entry.definition.readings]
    return any(
        (relation.left, relation.right) == (one.left, one.right)
        for reading in claim.formula.readings
        if len(reading.relations) == 1 and not reading.conditions
        for relation in reading.relations
        for one in declared
    )


def is_compared(claim: Claim, setting: Setting) -> bool:
    """Whether it takes a proof that the formula is what its symbol stands for."""
    return compared_token(claim, setting) is not None and not is_as_declared(claim, setting)


def judge_definition(claim: Claim, reading: Reading, scope: Scope) -> Finding:
    """Whether the formula is what its symbol stands for. Raises Undecided where the formula itself
    says what the symbol, or a free symbol in it, is.
    """
    token = defined_token(claim, scope.setting)
    if token is not None and scope.setting.symbols[token].role == "quantity":
        left = scope.symbol(token)
        right = [e for rel in reading.relations for e in entries(scope.value(rel.right))]
        if _says(left, right):
            raise Undecided(f"the formula itself says what {token} is")
    return judge_identity(claim, reading, scope)


def _says(left: object, right: list[Expr]) -> bool:
    """Whether a quantity of the model is a base variable that the right side does not hold, or the
    right side holds a symbol of which the model says nothing.
    """
    names = symbols_of(*right)
    if any(is_free(symbol(name)) for name in names):
        return True
    return isinstance(left, Expr) and left.kind == "symbol" and left.name not in names


DEFINITION = Kind(
    "definition",
    "nothing of its own: dimensions are compared, and the formula with what its symbol stands for "
    "in all other claims, where the table of symbols, the model or the letters say that",
    judge_definition,
    operators=EQUATION,
    not_decided="nothing to decide but dimensions",
    settings="any",
    repaired=False,
)
