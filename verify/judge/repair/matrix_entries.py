"""Printed matrices with wrong entries: each entry is repaired like a formula of its own, and the
whole is judged again.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.exact.expression import Expr, symbol
from gainproof.verify.judge.exact.formula_tree import read_tree
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.formula import Reading, Relation
from gainproof.verify.judge.meaning.bindings import Bindings
from gainproof.verify.judge.meaning.value import Value, entries, shape
from gainproof.verify.judge.reader.latex_printer import graph_to_latex
from gainproof.verify.judge.repair.proof import Offer, is_proved, reread, with_formula
from gainproof.verify.judge.repair.requested_operations import ENTRY
from gainproof.verify.judge.repair.search import Search
from gainproof.verify.judge.repair.tree_construction import exchanged
from gainproof.verify.judge.repair.true_value import in_symbols, short_form
from gainproof.verify.judge.repair.whole_formula import Change
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import Environment

MOST_WRONG = 6
"""Of more wrong entries no misprint is to be told."""


class EntryScope(Scope):
    """A scope in which one symbol more stands for what an entry should be, `truth`."""

    def __init__(self, claim: Claim, setting: Setting, at: Environment, truth: Expr) -> None:
        super().__init__(setting, at, held=claim.held)
        self.truth = truth

    def symbol(self, token: str, bindings: Bindings | None = None) -> Value:
        """What a symbol stands for."""
        return self.truth if token == ENTRY else super().symbol(token, bindings)


@dataclass(frozen=True)
class Entry:
    """A place of a printed matrix, counted from 1, as a formula of its own."""

    row: int
    column: int
    search: Search

    @property
    def name(self) -> str:
        """`entry (2, 1)`."""
        return f"entry ({self.row}, {self.column})"


@dataclass(frozen=True)
class PrintedMatrix:
    """The wrong entries of the matrix that stands on one side of an equation."""

    claim: Claim
    reading: Reading
    setting: Setting
    environment: Environment
    side: str
    wrong: tuple[Entry, ...]

    def offers(self, stage: int) -> list[Offer]:
        """The proved matrices of the least weight; of several wrong entries each gets the change
        that comes first.
        """
        if len(self.wrong) > MOST_WRONG:
            return []
        found = [entry.search.near(stage) for entry in self.wrong]
        if len(found) == 1:
            single = [self._offer([change]) for change in found[0]]
            return [offer for offer in single if offer is not None]
        if not all(found):
            return []
        offer = self._offer([changes[0] for changes in found])
        return [] if offer is None else [offer]

    def truth(self) -> str | None:
        """`entry (2, 2) is c`, one for each wrong entry."""
        told = []
        for entry in self.wrong[:MOST_WRONG]:
            assert isinstance(entry.search.scope, EntryScope)
            value = in_symbols(short_form(entry.search.scope.truth), entry.search)
            if value is None:
                return None
            told.append(f"{entry.name} is {graph_to_latex(graph_of(value))}")
        return ", ".join(told)

    def _offer(self, changes: Sequence[Change]) -> Offer | None:
        (relation,) = self.reading.relations
        tree = read_tree(getattr(relation, self.side))
        columns = int(tree.name.split()[1])
        parts, steps = tree.parts, []
        for entry, change in zip(self.wrong, changes, strict=True):
            place = (entry.row - 1) * columns + entry.column - 1
            parts = exchanged(parts, place, change.printed.sides[1])
            steps += [replace(s, what=f"{entry.name}, {s.what}") for s in change.steps]
        graph = graph_of(Expr(tree.kind, tree.value, parts))
        right = self.side == "right"
        made = replace(relation, right=graph) if right else replace(relation, left=graph)
        formula = reread(replace(self.reading, relations=(made,)), self.setting.symbols)
        if formula is None:
            return None
        claim = with_formula(self.claim, formula)
        if not is_proved(claim, self.setting, self.environment):
            return None
        weight = sum(change.weight for change in changes)
        change = replace(changes[0], weight=weight, steps=tuple(steps))
        return Offer(formula, change, self.environment.name)


def printed_matrix(
    claim: Claim,
    reading: Reading,
    setting: Setting,
    environment: Environment,
    others: Sequence[Claim],
    deadline: float,
) -> PrintedMatrix | None:
    """The matrix on the right side of an equation, or on the left, with its wrong entries; None
    where neither side is a matrix as printed. Raises what values of formulas raise.
    """
    if claim.kind != "identity" or len(reading.relations) != 1:
        return None
    (relation,) = reading.relations
    for side, other in (("right", relation.left), ("left", relation.right)):
        tree = read_tree(getattr(relation, side))
        if tree.kind != "matrix":
            continue
        columns = int(tree.name.split()[1])
        truth = Scope(setting, environment, held=claim.held).value(other)
        if shape(truth) != (len(tree.parts) // columns, columns):
            return None
        wrong = []
        for place, (part, true) in enumerate(zip(tree.parts, entries(truth), strict=True)):
            scope = EntryScope(claim, setting, environment, true)
            entry = Relation("=", graph_of(symbol(ENTRY)), graph_of(part))
            single = Reading((entry,), reading.conditions)
            search = Search(claim, single, setting, environment, others, deadline, own_scope=scope)
            if not search.agrees(search.formula):
                wrong.append(Entry(place // columns + 1, place % columns + 1, search))
        return PrintedMatrix(claim, reading, setting, environment, side, tuple(wrong))
    return None
