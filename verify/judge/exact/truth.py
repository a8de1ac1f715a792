"""The truth of a statement on a connected set on which nothing changes."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.tower_at_place import Local
from gainproof.verify.judge.exact.tower_building import build_tower
from gainproof.verify.judge.exact.work_limits import Limits, Undecided

TRUE, FALSE, NO_VALUE, SKIPPED = "true", "false", "no value", "outside"


class Question:
    """A statement with its tower over some real parameters; other symbols are free."""

    def __init__(
        self,
        statement: Statement,
        boxes: Mapping[str, Box],
        parameters: tuple[str, ...],
        limits: Limits,
    ) -> None:
        self.statement, self.boxes = statement, boxes
        free = tuple(sorted(name for name in boxes if name not in parameters))
        positive = frozenset(name for name, box in boxes.items() if box.is_positive)
        nonnegative = frozenset(name for name, box in boxes.items() if box.is_nonnegative)
        self.differences = {rel: rel.left - rel.right for rel in statement.all_relations()}
        exprs = (*statement.exprs(), *self.differences.values())
        self.tower = build_tower(exprs, parameters, free, positive, limits, nonnegative)

    def equation_fails(self, rel: Rel, local: Local) -> None:
        """Called where the sides of an equation are not identical."""

    def has_value(self, local: Local, *exprs: Expr) -> None:
        """Called where these have values for some values of the free symbols."""


def truth(question: Question, local: Local) -> tuple[str, Rel | None]:
    """The truth on the set of `local`, and the relation that fails there. Raises Undecided."""
    statement = question.statement
    for condition in statement.domain:
        if local.undefined(condition.left, condition.right) is not None:
            return SKIPPED, None
        if not _holds(question, local, condition, everywhere=False):
            return SKIPPED, None
    if statement.connective == "if":
        for rel in statement.relations:
            if local.undefined(rel.left, rel.right, *statement.needed) is not None:
                return NO_VALUE, rel
            question.has_value(local, rel.left, rel.right, *statement.needed)
        for rel in statement.relations:
            if not _holds(question, local, rel, everywhere=True):
                return FALSE, rel
        return TRUE, None
    if local.undefined(*statement.exprs()) is not None:
        one_sided = any(
            local.undefined(*(e for r in rels for e in (r.left, r.right))) is None
            and all(_holds(question, local, rel, everywhere=False) for rel in rels)
            for rels in (statement.relations, statement.conditions)
        )
        # one side is true and the other has no value: that is no equivalence, whatever was stated
        return FALSE if one_sided else NO_VALUE, statement.relations[0]
    question.has_value(local, *statement.exprs())
    first = all(_holds(question, local, rel, everywhere=False) for rel in statement.relations)
    second = all(_holds(question, local, rel, everywhere=False) for rel in statement.conditions)
    good = first == second if statement.connective == "iff" else (second or not first)
    return (TRUE, None) if good else (FALSE, statement.relations[0])


def _holds(question: Question, local: Local, rel: Rel, *, everywhere: bool) -> bool:
    """The truth of a relation at a place; `everywhere`: for all values of the free symbols.

    Otherwise (conditions) a relation that depends on the values of free symbols raises Undecided.
    """
    element = question.tower.element(question.differences[rel])
    equal = local.vanishes(element.num)
    if rel.operator == "=":
        if equal:
            return True
        question.equation_fails(rel, local)
        if not everywhere and question.tower.free:
            local.sign(element.num)
        return False
    if equal:
        return rel.operator in ("<=", ">=")
    above = local.sign(element.num, strict=rel.operator not in ("<=", ">="))
    sign = above * local.sign(element.den)
    match rel.operator:
        case "<" | "<=":
            return sign < 0
        case ">" | ">=":
            return sign > 0
        case "!=":
            return True
        case _:
            raise Undecided(f"the relation {rel.operator} is not covered here")
