"""One proved claim with the convention under which it is proved, as the evaluator sees it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from mutation.tree import Tree, symbols, to_tree

from claim_campaign.point import Definition
from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.convention_effect import Chosen
from gainproof.verify.judge.formula import Relation as Printed


@dataclass(frozen=True)
class Rel:
    """left operator right."""

    operator: str
    left: Tree
    right: Tree

    def symbols(self) -> set[str]:
        """Symbols on both sides."""
        return symbols(self.left) | symbols(self.right)


@dataclass(frozen=True)
class Subject:
    """`claim` has one reading, `setting` one reading of each definition. `model` is the data of a
    steady state's model; `printed` is the setting as the file has it.
    """

    name: str
    claim: Claim
    setting: Setting
    printed: Setting
    convention: str
    chosen: Chosen
    model: Mapping[str, Any] | None

    def relations(self) -> tuple[Rel, ...]:
        """What is claimed in the formula, if there is one."""
        if self.claim.formula is None:
            return ()
        return tuple(map(rel, self.claim.formula.readings[0].relations))

    def conditions(self) -> tuple[Rel, ...]:
        """What is printed behind it, or on the other side of an arrow."""
        if self.claim.formula is None:
            return ()
        return tuple(map(rel, self.claim.formula.readings[0].conditions))

    def connective(self) -> str:
        """`if`, `iff` or `implies`, as the kind of the claim has it."""
        formula = self.claim.formula
        printed = "if" if formula is None else formula.readings[0].connective
        return {"equivalence": "iff", "implication": "implies"}.get(self.claim.kind, printed)

    def definitions(self) -> dict[str, Definition]:
        """Definitions of the source."""
        found = {}
        for token, entry in self.setting.symbols.items():
            if entry.definition is not None:
                body = to_tree(entry.definition.readings[0].relations[0].right)
                found[token] = Definition(entry.arguments, body)
        return found

    def reached(self, names: set[str]) -> set[str]:
        """The names, and those that their definitions and domains use."""
        definitions, found, waiting = self.definitions(), set(), list(names)
        while waiting:
            name = waiting.pop()
            if name in found or name not in self.setting.symbols:
                continue
            found.add(name)
            if name in definitions:
                waiting += symbols(definitions[name].body) | calls(definitions[name].body)
            for relation in self.setting.symbols[name].domain:
                waiting += rel(relation).symbols()
        return found


def rel(relation: Printed) -> Rel:
    """A relation as trees."""
    return Rel(relation.operator, to_tree(relation.left), to_tree(relation.right))


def calls(tree: Tree) -> set[str]:
    """Names of functions, and of what is differentiated or replaced."""
    found: set[str] = set()
    for part in tree[1:]:
        if isinstance(part, tuple):
            found |= calls(part)
    if tree[0] == "call":
        found.add(tree[1])
    if tree[0] in ("derivative", "at"):
        found.add(tree[2])
    return found
