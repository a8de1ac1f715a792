"""Statements at whole numbers, where open sums, products and symbolic powers can be written
out.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from math import ceil

from gainproof.verify.judge.cells.integers import MOST_NUMBERS
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.expression_text import is_series
from gainproof.verify.judge.exact.statement import Statement
from gainproof.verify.judge.meaning.evaluation import general_power
from gainproof.verify.judge.meaning.sequences import with_variables
from gainproof.verify.judge.meaning.sums import series_of
from gainproof.verify.judge.transcendental.induction import open_sums

TRIED = 5


def first_numbers(
    statement: Statement, boxes: Mapping[str, Box]
) -> Iterator[tuple[str, list[int], bool]]:
    """Symbols for whole numbers with the first few that they may be, and whether these are all."""
    bound = {s.parts[1].name for s in open_sums(statement)}
    for name in sorted(statement.symbols() - bound):
        box = boxes.get(name, Box())
        if box.integer:
            start = 0 if box.lower is None else ceil(box.lower)
            numbers = [n for n in range(start, start + MOST_NUMBERS) if box.holds(Fraction(n))]
            are_all = None not in (box.lower, box.upper) and not box.holds(
                Fraction(start + MOST_NUMBERS)
            )
            yield name, numbers if are_all else numbers[:TRIED], are_all


def at_number(statement: Statement, name: str, value: int) -> Statement:
    """The statement with a whole number put in, sums and products up to it written out."""
    put_in = {name: number(value)} if name else {}
    return statement.mapped(lambda e: _written_out(substituted(e, put_in)))


def _written_out(expr: Expr) -> Expr:
    def series(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        return series_of(node.name, parts)[0] if is_series(node) else None

    def powers(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        return general_power(*parts) if node.kind == "call" and node.name == "power" else None

    return with_variables(rebuilt(rebuilt(expr, series), powers))
