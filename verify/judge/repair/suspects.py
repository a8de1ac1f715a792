"""Definitions that may explain why claims are not true: which claims they are to explain, and which
must stand as they do.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.claim_symbols import closure, reached
from gainproof.verify.judge.exact.formula_tree import read_tree
from gainproof.verify.judge.exact.work_limits import Malformed
from gainproof.verify.judge.repair.requested_operations import asked_names
from gainproof.verify.judge.verdict import ClaimVerdict

NOT_TRUE = ("refuted", "conditional")


@dataclass(frozen=True)
class Suspect:
    """A defined symbol, the claims using it that are not true and those that are; `partly` are ids
    of claims that are true on a part of their domain, which is no gain to them. What is true
    wherever it has a value has no slip to explain; such claims are `kept` so.
    """

    token: str
    wrong: tuple[Claim, ...]
    right: tuple[Claim, ...]
    partly: frozenset[str] = frozenset()
    kept: tuple[Claim, ...] = ()

    @property
    def users(self) -> tuple[Claim, ...]:
        """All claims that must stand with another definition."""
        return (*self.wrong, *self.right, *self.kept)


def suspects_of(
    setting: Setting, claims: Sequence[Claim], verdicts: Mapping[str, ClaimVerdict]
) -> tuple[Suspect, ...]:
    """The definitions of numbers that claims use which are not true; `verdicts` by id. A claim that
    asks for the derivative or mean of what is defined does not speak against the definition.
    """
    suspects: list[Suspect] = []
    for token, entry in setting.symbols.items():
        if entry.role != "definition" or entry.arguments:
            continue
        users = [c for c in claims if token in reached(c, setting)]
        found = {c.id: verdicts[c.id] for c in users if c.id in verdicts}
        kept = tuple(c for c in users if c.id in found and found[c.id].only_lacks_values)
        partly = frozenset(n for n, v in found.items() if v.verdict == "conditional")
        wrong = tuple(c for c in users if _is(c, found, *NOT_TRUE) and c not in kept)
        right = tuple(c for c in users if _is(c, found, "proved"))
        against = [c for c in wrong if not _asks(c, token, setting)]
        # what as many claims bear out as speak against it is right
        if len(against) > len(right):
            suspects.append(Suspect(token, wrong, right, partly, kept))
    return tuple(suspects)


def _is(claim: Claim, found: Mapping[str, ClaimVerdict], *verdicts: str) -> bool:
    return claim.id in found and found[claim.id].verdict in verdicts


def _asks(claim: Claim, token: str, setting: Setting) -> bool:
    """Whether what the claim asks for is computed from the symbol."""
    if claim.formula is None:
        return False
    names: set[str] = set()
    for reading in claim.formula.readings:
        for relation in reading.relations:
            try:
                names |= asked_names(read_tree(relation.left), read_tree(relation.right))
            except Malformed:
                continue
    return token in closure(names, setting.symbols)
