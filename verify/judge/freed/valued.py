"""What follows for symbols of which nothing is said from where logarithms have a value."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.domain import bounded
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of, walk
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.freed.monomials import UNIT, monomials
from gainproof.verify.judge.freed.rewriting import bound_names


def valued(
    statement: Statement, boxes: Mapping[str, Box]
) -> tuple[Statement, Mapping[str, Box], bool]:
    """The statement where the arguments of its logarithms are positive, and whether that takes more
    than bounds of symbols to say.

    Of symbols that are in no stated domain a statement speaks only where every part has a value,
    so that it says the same as before.
    """
    calls = (node for node in walk(*statement.exprs()) if node.kind == "call")
    logarithms = [node for node in calls if node.name == "log"]
    if statement.connective != "if" or not logarithms:
        return statement, boxes, False
    over = bound_names(statement)
    wanted: list[Rel] = []
    where = dict(boxes)
    for (argument,) in dict.fromkeys(node.parts for node in logarithms):
        names = symbols_of(argument)
        unsaid = [n for n in names if not boxes.get(n, Box(stated=False)).stated]
        plain = not any(node.kind == "call" for node in walk(argument))
        if names and len(unsaid) == len(names) and plain and not names & over:
            where |= {n: boxes.get(n, Box(stated=False)) for n in names}
            wanted.append(_positive(argument))
    narrowed, left = bounded(where, wanted)
    if any(box.is_empty for box in narrowed.values()):
        return statement, boxes, False
    kept = {n: replace(box, stated=where[n].stated) for n, box in narrowed.items()}
    return replace(statement, given=(*statement.given, *left)), kept, bool(left)


def _positive(argument: Expr) -> Rel:
    """That it is positive; of a x + b as a bound of x."""
    plain = Rel(">", argument, number(0))
    try:
        terms = dict(monomials(argument))
    except Undecided:
        return plain
    rest = terms.pop(UNIT, Fraction(0))
    if len(terms) != 1:
        return plain
    ((monomial, factor),) = terms.items()
    if len(monomial) != 1:
        return plain
    ((base, exponent),) = monomial
    if base.kind != "symbol" or exponent != 1:
        return plain
    return Rel(">" if factor > 0 else "<", base, number(-rest / factor))
