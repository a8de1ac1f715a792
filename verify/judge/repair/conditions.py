"""Slips in a printed condition: a comparison strict or not, a bound one off."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from gainproof.verify.judge.exact.expression import number
from gainproof.verify.judge.repair.edit import PLAIN, SLIGHT
from gainproof.verify.judge.repair.printed import Printed
from gainproof.verify.judge.repair.whole import Change, Step

STRICT_OR_NOT = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}


def changed_conditions(formula: Printed) -> Iterator[Change]:
    """The claim under conditions with one such slip undone."""
    if formula.connective != "if":
        return
    for n, link in enumerate(formula.conditions):
        operator = STRICT_OR_NOT.get(link.operator)
        if operator is None:
            continue
        conditions = (
            *formula.conditions[:n],
            replace(link, operator=operator),
            *formula.conditions[n + 1 :],
        )
        step = Step(f"the condition's sign {link.operator} that is {operator}")
        yield Change(replace(formula, conditions=conditions), SLIGHT, (step,))
        for side in (link.left, link.right):
            before = formula.sides[side]
            if before.kind != "number" or before.fraction.denominator != 1:
                continue
            for value in (before.fraction + 1, before.fraction - 1):
                if value >= 0:
                    after = number(value)
                    step = Step("a number in the condition", before, after)
                    yield Change(formula.with_side(side, after), PLAIN, (step,))
