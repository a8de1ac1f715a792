"""What is true of expressions wherever they have values: no divisor is zero, and what stands under
an even root is not negative.
"""

from __future__ import annotations

from collections.abc import Iterator

from gainproof.verify.judge.exact.expression import Expr, number, walk
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.total_expressions import divisors

ZERO = number(0)


def where_valued(*exprs: Expr) -> tuple[Rel, ...]:
    """Relations !=, >= and > to zero that hold wherever all the expressions have values."""
    nodes = [node for node in walk(*exprs) if node.kind == "pow"]
    roots = [node.parts[0] for node in nodes if node.fraction.denominator % 2 == 0]
    below = {part.key: part for each in divisors(*exprs) for part in _factors(each)}
    radicands = {base.key: base for base in roots}
    nonzero = [Rel("!=", part, ZERO) for part in below.values()]
    least = [Rel(">" if key in below else ">=", e, ZERO) for key, e in radicands.items()]
    return (*nonzero, *least)


def _factors(expr: Expr) -> Iterator[Expr]:
    """An expression and all others that are not zero where it is not."""
    yield expr
    match expr.kind:
        case "mul":
            for part in expr.parts:
                yield from _factors(part)
        case "pow" if expr.fraction > 0:
            yield from _factors(expr.parts[0])
        case "neg" | "div":
            yield from _factors(expr.parts[0])
        case _:
            pass
