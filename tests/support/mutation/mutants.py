"""Mutants of one side of a relation: misprints, and near misses that hold almost everywhere or
almost exactly.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from random import Random

from mutation.tree import Tree, number, parts, symbols

TINY = Fraction(1, 10**12)


def misprints(tree: Tree) -> Iterator[tuple[str, Tree]]:
    """Edits that a misprint makes, with a name each."""
    names = sorted(symbols(tree))
    for part, graft in parts(tree):
        kind = part[0]
        match kind:
            case "number":
                value = part[1]
                for label, new in (
                    ("number negated", -value),
                    ("number doubled", 2 * value),
                    ("number halved", value / 2),
                    ("number plus one", value + 1),
                    ("number minus one", value - 1),
                ):
                    if new != value:
                        yield label, graft(number(new))
            case "symbol":
                yield "sign of a symbol", graft(("neg", part))
                yield "symbol squared", graft(("pow", part, Fraction(2)))
                yield "index shift", graft(("add", part, number(1)))
                for other in names:
                    if other != part[1]:
                        yield f"{other} for {part[1]}", graft(("symbol", other))
            case "add" | "mul":
                other = "mul" if kind == "add" else "add"
                yield f"{other} for {kind}", graft((other, *part[1:]))
                for k in range(1, len(part)):
                    rest = part[1:k] + part[k + 1 :]
                    shorter = rest[0] if len(rest) == 1 else (kind, *rest)
                    yield ("term dropped" if kind == "add" else "factor dropped"), graft(shorter)
                    if kind == "add":
                        yield "sign of a term", graft((*part[:k], ("neg", part[k]), *part[k + 1 :]))
            case "div":
                yield "mul for div", graft(("mul", *part[1:]))
                yield "quotient inverted", graft(("div", part[2], part[1]))
            case "neg":
                yield "sign lost", graft(part[1])
            case "pow":
                for step in (-1, 1):
                    yield "exponent changed", graft(("pow", part[1], part[2] + step))
                yield "power lost", graft(part[1])
            case "matrix" if part[1] == part[2] and part[1] > 1:
                rows, columns = part[1], part[2]
                turned = [part[3 + c * columns + r] for r in range(rows) for c in range(columns)]
                yield "transposed", graft(("matrix", rows, columns, *turned))
            case "derivative":
                yield "derivative lost", graft(part[1])


def near_misses(tree: Tree, variable: str) -> Iterator[tuple[str, Tree]]:
    """False by less than 1e-9, or on a part of the domain only."""
    if any(part[0] == "matrix" for part, _ in parts(tree)):
        for part, graft in parts(tree):
            if part[0] == "number" and part[1] != 0:
                yield (
                    "factor 1 + 1e-10 on a number",
                    graft(number(part[1] * (1 + Fraction(1, 10**10)))),
                )
        return
    x: Tree = ("symbol", variable)
    far = ("add", ("call", "abs", ("add", x, number(-40))), ("add", x, number(-40)))
    low = ("add", ("call", "abs", ("add", x, number(-3))), ("neg", ("add", x, number(-3))))
    yield "factor 1 + 1e-10", ("mul", number(1 + Fraction(1, 10**10)), tree)
    yield "1e-12 x^2 added", ("add", tree, ("mul", number(TINY), ("pow", x, Fraction(2))))
    yield "wrong beyond 40 only", ("add", tree, ("mul", number(Fraction(1, 10**9)), far))
    yield "wrong below 3 only", ("add", tree, ("mul", number(Fraction(1, 10**9)), low))
    for part, graft in parts(tree):
        if part[0] == "number" and part[1] != 0:
            yield "number off by 1e-11", graft(number(part[1] * (1 + Fraction(1, 10**11))))


def sample(
    left: Tree, right: Tree, variable: str, count: int, random: Random
) -> list[tuple[str, bool, Tree, Tree]]:
    """`count` mutants of a relation, a fifth of them near misses: name, near miss, left, right."""
    plain = [(name, False, new, right) for name, new in misprints(left) if new != left]
    plain += [(name, False, left, new) for name, new in misprints(right) if new != right]
    close = [(name, True, left, new) for name, new in near_misses(right, variable)]
    close += [(name, True, new, right) for name, new in near_misses(left, variable)]
    wanted = max(1, count // 5)
    chosen = random.sample(close, min(wanted, len(close)))
    return chosen + random.sample(plain, min(count - len(chosen), len(plain)))
