"""Parts of an expression at whose zeros it has no value, such as divisors."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from gainproof.verify.judge.exact.expression import Expr, walk


@dataclass(frozen=True)
class Lack:
    """What leaves a part without a value where it is 0."""

    zero: Expr
    reason: str


def lacks(expr: Expr) -> Iterator[Lack]:
    """Divisors, arguments of logarithms and cosines below tangents, factor by factor."""
    for node in walk(expr):
        match node.kind:
            case "div":
                zeros, reason = factors(node.parts[1]), "a divisor is zero"
            case "pow" if node.fraction < 0:
                zeros, reason = factors(node.parts[0]), "a divisor is zero"
            case "call" if node.name == "log":
                zeros = factors(node.parts[0])
                reason = "a logarithm of a number that is not positive"
            case "call" if node.name == "tan":
                zeros, reason = [Expr("call", "cos", node.parts)], "the tangent of a right angle"
            case _:
                continue
        yield from (Lack(zero, reason) for zero in zeros)


def factors(expr: Expr) -> list[Expr]:
    """Parts of each of which a zero is one of the whole, or leaves it without a value."""
    match expr.kind:
        case "mul":
            return [each for part in expr.parts for each in factors(part)]
        case "neg" | "div":
            return factors(expr.parts[0])
        case "pow" if expr.fraction > 0:
            return factors(expr.parts[0])
        case _:
            return [expr]
