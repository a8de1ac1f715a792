"""What a quantity, or what is computed, truly is where a formula for it is wrong and no misprint
explains it.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.expression import Expr, mul, number, power, symbol, symbols_of
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.exact.polynomial import Poly, exact_value, fraction
from gainproof.verify.judge.exact.simplification import expression_of
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.tower_building import build_tower
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.kinds.claim_domain import framed
from gainproof.verify.judge.reader.latex_printer import graph_to_latex
from gainproof.verify.judge.repair.number_recognition import common_rational
from gainproof.verify.judge.repair.requested_operations import asked_sides
from gainproof.verify.judge.repair.tree_construction import (
    opposite,
    places,
    quotient,
    raised,
    remade,
    total,
)
from gainproof.verify.judge.scope import UndefinedSymbol

if TYPE_CHECKING:
    from gainproof.verify.judge.repair.search import Search

MOST_NODES = 20
"""Longer formulas say less than they take to read."""
MOST_FACTORED = 400
"""So many nodes are multiplied out and factored."""
DIGITS = 6
STATED = ("quantity", "definition")
"""Roles of symbols whose meaning is known."""


def true_value(search: Search) -> str | None:
    """`side = formula` in the source's own symbols if one side of an equation is computed, or is
    the symbol of something known, and the formula is short and proved in the place of the claim;
    where the other side is a number, the number. None for others.
    """
    formula, scope = search.formula, search.scope
    if not search.by_values or len(formula.links) != 1 or formula.links[0].operator != "=":
        return None
    link = formula.links[0]
    asked = asked_sides(formula)
    for n, other in ((link.left, link.right), (link.right, link.left)):
        side = formula.sides[n]
        entry = scope.setting.symbols.get(side.name) if side.kind == "symbol" else None
        if n not in asked and (entry is None or entry.role not in STATED):
            continue
        if not symbols_of(formula.sides[other]) and (value := _number_there(search, side)):
            if isinstance(value, str):
                return f"{_latex(side)} \\approx {value}"
            if _is_proved(search, other, value):
                return f"{_latex(side)} = {_latex(value)}"
        try:
            meaning = scope.expression(graph_of(side))
        except (Undecided, Malformed, UndefinedSymbol, ValueError):
            continue
        shown = in_symbols(short_form(meaning), search)
        if shown is None or shown == side:
            continue
        if _is_proved(search, other, shown):
            return f"{_latex(side)} = {_latex(shown)}"
    return None


def _is_proved(search: Search, place: int, value: Expr) -> bool:
    """Whether the claim is proved with this side: a form may lack a value where what it is the form
    of has one, or be that of one branch, and a number that of all points that were tried.
    """
    formula = search.formula
    sides = tuple(value if k == place else each for k, each in enumerate(formula.sides))
    found = search.judged(replace(formula, sides=sides))
    return found is not None and found.verdict == "proved"


def in_symbols(value: Expr, search: Search) -> Expr | None:
    """A short expression of base variables in the source's symbols; None if it is long or if the
    source has no symbols for it.
    """
    tokens = search.scope.labels()
    names = symbols_of(value)
    known = all(tokens.get(n, n) in search.setting.symbols for n in names)
    if not known or sum(1 for _ in places(value)) > MOST_NODES:
        return None
    named = substituted(value, {n: symbol(tokens[n]) for n in names if n in tokens})
    return rebuilt(named, _with_fractions)


def _with_fractions(node: Expr, parts: tuple[Expr, ...]) -> Expr:
    """The node with a number as a fraction, which would be printed as a decimal."""
    if node.kind != "number" or node.fraction.denominator == 1:
        return remade(node.kind, node.value, parts)
    size = abs(node.fraction)
    made = quotient(number(size.numerator), number(size.denominator))
    return made if node.fraction > 0 else opposite(made)


def short_form(expr: Expr) -> Expr:
    """The shorter of the expression multiplied out and factored, common divisors cancelled; roots
    and functions stay as they are.
    """
    if sum(1 for _ in places(expr)) > MOST_FACTORED:
        return expr
    atoms: dict[str, Expr] = {}

    def frozen(node: Expr, parts: tuple[Expr, ...]) -> Expr:
        made = Expr(node.kind, node.value, parts)
        if node.kind != "call" and not (node.kind == "pow" and node.fraction.denominator > 1):
            return made
        inside = substituted(made, atoms) if symbols_of(made) & atoms.keys() else made
        name = next((n for n, atom in atoms.items() if atom == inside), f"atom {len(atoms)}")
        atoms[name] = inside
        return symbol(name)

    plain = rebuilt(expr, frozen)
    names = tuple(sorted(symbols_of(plain)))
    try:
        element = build_tower([plain], None, names, frozenset()).element(plain)
    except Undecided:
        return expr
    top, bottom = (_short(p, names) for p in (element.num, element.den))
    return substituted(quotient(top, bottom), atoms)


def _short(p: Poly, names: tuple[str, ...]) -> Expr:
    whole = expression_of(p, names)
    content, factors = p.factor()
    parts = [expression_of(f, names) for f, _ in factors]
    made = [raised(part, Fraction(int(e))) for part, (_, e) in zip(parts, factors, strict=True)]
    size = fraction(content)
    odd = [n for n, (_, times) in enumerate(factors) if times % 2]
    if size < 0 and odd:
        turned = odd[-1]
        opposed, times = factors[turned]
        made[turned] = raised(_positive_first(expression_of(-opposed, names)), Fraction(int(times)))
        size = -size
    product = mul(*([] if size == 1 and made else [number(size)]), *made)
    return min((whole, product), key=lambda one: sum(1 for _ in places(one)))


def _positive_first(expr: Expr) -> Expr:
    """A sum that does not begin with a minus sign, if it can."""
    return (
        total(*sorted(expr.parts, key=lambda part: part.kind == "neg"))
        if expr.kind == "add"
        else expr
    )


def _number_there(search: Search, side: Expr) -> Expr | str | None:
    """The rational number that a side is at all points that were tried, or a few digits of the one
    value that it has where the claim is made.
    """
    found = [values.ball(side) for values in search.points]
    balls = [ball for ball in found if ball is not None and ball.is_finite()]
    if not balls or len(balls) < len(found) or not all(b.overlaps(balls[0]) for b in balls):
        return None
    value = common_rational(balls)
    if value is not None:
        return quotient(number(value.numerator), number(value.denominator))
    near = exact_value(balls[0].mid())
    try:
        frame = framed(search.claim, search.scope)
        gap = power(search.scope.expression(graph_of(side)) - number(near), 2)
    except (Undecided, Malformed, UndefinedSymbol, ValueError):
        return None
    if not frame.holds(Rel("<", gap, number((near / 10**DIGITS) ** 2))):
        return None
    digits: str = balls[0].str(DIGITS, radius=False)
    return digits


def _latex(expr: Expr) -> str:
    return graph_to_latex(graph_of(expr))
