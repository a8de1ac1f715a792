"""The slope of a function at a point, by its expansions to the right and to the left."""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.expression import Expr, number, symbol, walk
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.series.expression_series import expanded
from gainproof.verify.judge.series.series import Oracle, Series, leading

STEP = symbol("step along a derivative")
DEPTHS = (Fraction(3), Fraction(8), Fraction(16))


def slope_at(function: Expr, variable: str, place: Expr, known: Oracle) -> Expr | None:
    """The derivative of a function with respect to a variable at a place; None if it has none.

    At an end of the domain of the function it is that from one side. Nothing is asked about a value
    at the place itself. Raises Undecided.
    """
    function = without_roots_of_zero(function)
    found: list[tuple[Expr, Expr]] = []
    for side in (1, -1):
        moved = substituted(function, {variable: place + number(side) * STEP})
        if not _lacks_values(moved, known):
            start, slope = _beginning(moved, known)
            if start is None or slope is None:
                return None
            found.append((start, number(side) * slope))
    if not found:
        return None
    (start, slope), *others = found
    if any(
        not known.is_zero(a - b)
        for pair in others
        for a, b in zip((start, slope), pair, strict=True)
    ):
        return None
    return slope


def without_roots_of_zero(expr: Expr) -> Expr:
    """Zero in the place of roots of what is zero everywhere: an expansion knows no sign of it."""

    def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        is_root = node.kind == "pow" and node.fraction > 0 and node.fraction.denominator > 1
        return number(0) if is_root and tidied(parts[0]) == number(0) else None

    return rebuilt(expr, change)


def _beginning(moved: Expr, known: Oracle) -> tuple[Expr | None, Expr | None]:
    """The constant and the linear coefficient for a small positive step; None for what is infinite.
    Raises Undecided.
    """
    for depth in DEPTHS:
        series = expanded(moved, STEP.name, known, depth)
        if series.order <= 1:
            continue
        small = {e: c for e, c in series.terms.items() if e < 1 and e != 0}
        if leading(Series(small), known) is not None:
            return None, None
        zero = number(0)
        return series.terms.get(Fraction(0), zero), series.terms.get(Fraction(1), zero)
    raise Undecided("an expansion that cancels to the order reached")


def _lacks_values(moved: Expr, known: Oracle) -> bool:
    """Whether an even root or a logarithm of a negative number is taken for all small steps."""
    for node in walk(moved):
        is_root = node.kind == "pow" and node.fraction.denominator % 2 == 0
        if not (is_root or (node.kind == "call" and node.name == "log")):
            continue
        try:
            first = leading(expanded(node.parts[0], STEP.name, known, DEPTHS[0]), known)
        except Undecided:
            continue
        if first is not None and known.is_positive(-first[1]):
            return True
    return False
