"""Statements at whole numbers, where open sums and symbolic powers can be written out."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.statement import Statement
from gainproof.verify.judge.freed.induction import open_sums
from gainproof.verify.judge.meaning.evaluation import general_power
from gainproof.verify.judge.meaning.sequences import with_variables
from gainproof.verify.judge.meaning.sums import sum_of

TRIED = 5


def first_numbers(statement: Statement, boxes: Mapping[str, Box]) -> Iterator[tuple[str, int]]:
    """Symbols for whole numbers with the first few that they may be."""
    bound = {s.parts[1].name for s in open_sums(statement)}
    for name in sorted(statement.symbols() - bound):
        box = boxes.get(name, Box())
        if box.integer:
            start = 0 if box.lower is None else int(box.lower.__ceil__())
            numbers = (n for n in range(start, start + 2 * TRIED) if box.holds(number(n).fraction))
            yield from ((name, n) for n, _ in zip(numbers, range(TRIED), strict=False))


def at_number(statement: Statement, name: str, value: int) -> Statement:
    """The statement with a whole number put in, sums up to it written out."""
    put_in = {name: number(value)} if name else {}
    return statement.mapped(lambda e: _written_out(substituted(e, put_in)))


def _written_out(expr: Expr) -> Expr:
    def sums(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        if node.kind == "call" and node.name == "sum":
            return sum_of(parts[0], parts[1].name, parts[2], parts[3])[0]
        return None

    def powers(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        return general_power(*parts) if node.kind == "call" and node.name == "power" else None

    return with_variables(rebuilt(rebuilt(expr, sums), powers))
