"""Inequalities that say something: a bound that nothing comes near is no repair of another bound,
and a weaker one is none beside a stronger.
"""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.verify.judge.repair.formula_values import Values, truth
from gainproof.verify.judge.repair.printed_formula import Link, Printed
from gainproof.verify.judge.repair.trivial_formulas import OffTheModel

NEAR = 0.02
"""The relative distance at which two sides count as near one another."""
ORDERS = ("<", "<=", ">", ">=")


def is_sharp(formula: Printed, changed: Printed, far: Sequence[Values]) -> bool:
    """Whether each changed comparison comes near equality somewhere on `far`-reaching points; one
    that differs in its sign only is kept as it is.
    """
    if formula.sides == changed.sides:
        return True
    return all(
        _comes_near(changed, link, far)
        for link in changed.links
        if link.operator in ORDERS and not _is_kept(formula, changed, link)
    )


def _is_kept(formula: Printed, changed: Printed, link: Link) -> bool:
    return all(formula.sides[n] == changed.sides[n] for n in (link.left, link.right))


def _comes_near(formula: Printed, link: Link, far: Sequence[Values]) -> bool:
    for values in far:
        a, b = values.ball(formula.sides[link.left]), values.ball(formula.sides[link.right])
        if a is None or b is None:
            continue
        if (a - b).abs_lower() <= NEAR * max(a.abs_upper(), b.abs_upper()):
            return True
    return False


def is_weaker(formula: Printed, than: Printed, off: OffTheModel) -> bool:
    """Whether the formula is seen to hold wherever the other does, whatever the symbols are."""
    if formula.sides == than.sides and formula.connective == "if":
        pairs = zip(formula.links, than.links, strict=True)
        if all(a.operator in (b.operator, f"{b.operator}=") for a, b in pairs):
            return True
    seen = [(truth(values, than), truth(values, formula)) for values in off.values]
    return any(a for a, _ in seen) and all(b is not False for a, b in seen if a)
