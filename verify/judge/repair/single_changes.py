"""Every change of weight one to three that one misprint makes."""

from __future__ import annotations

from collections.abc import Iterator

from gainproof.verify.judge.exact.expression import Expr, neg, symbol
from gainproof.verify.judge.repair.brackets import brackets
from gainproof.verify.judge.repair.edits import (
    LARGE,
    OF_SYMBOLS,
    PLAIN,
    SLIGHT,
    SYMBOL,
    Edit,
    Edits,
    Table,
)
from gainproof.verify.judge.repair.expansion import PARITY
from gainproof.verify.judge.repair.number_changes import constants, exponents, factor_two
from gainproof.verify.judge.repair.printed_formula import Printed
from gainproof.verify.judge.repair.requested_operations import asked_sides, open_places
from gainproof.verify.judge.repair.tree_construction import (
    ONE,
    exchanged,
    is_of_one_number,
    opposite,
    product,
    quotient,
    remade,
    replaced,
    total,
    without,
)
from gainproof.verify.judge.repair.whole_formula import Change, Step, changes_of_whole

PAIRS = (
    *(("sin", "cos"), ("tan", "cot"), ("sec", "csc"), ("sinh", "cosh")),
    *(("asin", "acos"), ("max", "min")),
)
EXCHANGED = {one: other for pair in PAIRS for one, other in (pair, pair[::-1])}
"""Functions that are mistaken for one another."""


def other_symbols(node: Expr, table: Table) -> Iterator[Edit]:
    """Another declared symbol; one that differs in an index only is a slighter slip."""
    if node.kind != "symbol":
        return
    for name in table.symbols:
        if name != node.name:
            is_sibling = (node.name, name) in table.siblings
            what = "an index" if is_sibling else SYMBOL
            yield Edit(symbol(name), SLIGHT if is_sibling else PLAIN, what)


def other_functions(node: Expr, _: Table) -> Iterator[Edit]:
    """The function that is taken for this one: the cosine for the sine."""
    if node.kind == "call" and (name := EXCHANGED.get(node.name)) is not None:
        yield Edit(Expr("call", name, node.parts), PLAIN, "a function")


def dropped(node: Expr, _: Table) -> Iterator[Edit]:
    """A term or factor too many."""
    if node.kind in ("add", "mul"):
        for k, part in enumerate(node.parts):
            kept = remade(node.kind, None, without(node.parts, k))
            yield Edit(kept, LARGE, "a part too many", part)
    if node.kind == "div":
        top, bottom = node.parts
        yield Edit(top, LARGE, "a divisor too many", bottom)
        if top != ONE:
            yield Edit(quotient(ONE, bottom), LARGE, "a numerator too many", top)


def inserted(node: Expr, table: Table) -> Iterator[Edit]:
    """A term or factor that is missing: a symbol, or one."""
    if node.kind in ("add", "pow"):
        for k, part in enumerate(node.parts):
            for name in table.symbols:
                for new in (product(part, symbol(name)), quotient(part, symbol(name))):
                    parts = exchanged(node.parts, k, new)
                    made = remade(node.kind, node.value, parts)
                    yield Edit(made, LARGE, "a missing factor", part)
    if node.kind in ("symbol", "number"):
        return
    for term in (ONE, *[symbol(name) for name in table.symbols]):
        for new in (total(node, term), total(node, opposite(term))):
            yield Edit(new, LARGE, "a missing term", term)


def signs(node: Expr, _: Table) -> Iterator[Edit]:
    """One term of a sum, or what a function is taken of, with the other sign."""
    # nobody prints sin(-x): the sign would stand in front
    if node.kind == "call" and node.name in PARITY and node.parts[0].kind != "neg":
        return
    if node.kind == "add" or is_of_one_number(node):
        what = "sign of a term" if node.kind == "add" else "sign of an argument"
        for k, part in enumerate(node.parts):
            parts = exchanged(node.parts, k, opposite(part))
            yield Edit(remade(node.kind, node.value, parts), SLIGHT, what, part)


def operators(node: Expr, _: Table) -> Iterator[Edit]:
    """Another operator between neighbours, or one lost between two factors."""
    match node.kind:
        case "add":
            for k in range(len(node.parts) - 1):
                a, b = node.parts[k], node.parts[k + 1]
                if {a, b} & {ONE, neg(ONE)}:
                    continue  # times 1 is the term left out
                yield _joined(node, k, product(a, b), "a sum that is a product")
                yield _joined(node, k, quotient(a, b), "a sum that is a quotient")
        case "mul":
            for k in range(len(node.parts) - 1):
                a, b = node.parts[k], node.parts[k + 1]
                yield _joined(node, k, total(a, b), "a product that is a sum")
                yield _joined(node, k, total(a, opposite(b)), "a product that is a difference")
            for k, factor in enumerate(node.parts):
                under = quotient(product(*without(node.parts, k)), factor)
                yield Edit(under, SLIGHT, "a factor that divides", factor)
        case "div":
            a, b = node.parts
            yield Edit(product(a, b), SLIGHT, "a quotient that is a product")
            yield Edit(quotient(b, a), PLAIN, "a fraction upside down")
            yield Edit(total(a, b), PLAIN, "a quotient that is a sum")
            yield Edit(total(a, opposite(b)), PLAIN, "a quotient that is a difference")


def _joined(node: Expr, k: int, new: Expr, what: str) -> Edit:
    parts = (*node.parts[:k], new, *node.parts[k + 2 :])
    return Edit(remade(node.kind, node.value, parts), SLIGHT, what)


EDITS: tuple[Edits, ...] = (
    signs,
    operators,
    brackets,
    exponents,
    constants,
    factor_two,
    other_symbols,
    other_functions,
    dropped,
    inserted,
)
LARGE_ONLY: tuple[Edits, ...] = (dropped, inserted)
"""Those all of whose edits are large."""


def changes(
    formula: Printed, table: Table, numbers: frozenset[str], most: int = 3
) -> Iterator[Change]:
    """All formulas one edit away whose edit weighs at most `most`, each once."""
    seen = {_key(formula, formula)}
    for change in _all(formula, table, numbers, most):
        key = _key(change.printed, formula)
        if change.weight <= most and key not in seen:
            seen.add(key)
            yield change


def changes_of_bound(
    formula: Printed, table: Table, numbers: frozenset[str], most: int = 3
) -> Iterator[Change]:
    """Those without another symbol: a bound of other symbols is true of many formulas, and the one
    that is meant cannot be told from those that are true by chance. An index is told.
    """
    for change in changes(formula, table, numbers, most):
        if not any(step.what in OF_SYMBOLS for step in change.steps):
            yield change


def _all(formula: Printed, table: Table, numbers: frozenset[str], most: int) -> Iterator[Change]:
    """Those that are cheap to leave out are, if they weigh more than `most`."""
    edits_of = [edits for edits in EDITS if most >= LARGE or edits not in LARGE_ONLY]
    both = formula.connective != "if"
    chosen = range(len(formula.sides)) if both else formula.claimed()
    asked = asked_sides(formula)
    for n in chosen:
        side = formula.sides[n]
        for path, node in open_places(side) if n not in asked else ():
            for edits in edits_of:
                for edit in edits(node, table):
                    if edit.weight > most:
                        continue
                    new = replaced(side, path, edit.new)
                    step = Step(edit.what, node, edit.new, edit.part)
                    yield Change(formula.with_side(n, new), edit.weight, (step,))
    yield from changes_of_whole(formula, table, numbers, most)


def _key(formula: Printed, first: Printed) -> tuple[object, ...]:
    """Equal for formulas written alike, if all are compared with the same first one."""
    sides = [side.key for side in formula.sides]
    if formula.links is first.links and formula.conditions is first.conditions:
        return tuple(sides)
    return (*sides, formula.links, formula.conditions)
