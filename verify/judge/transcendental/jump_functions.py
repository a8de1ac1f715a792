"""Functions with jumps: whole parts, angles of points and cases, on parts of the domain on each of
which they are something without a jump.

The angle of (x, y) is atan(y/x) right of x = 0, and half a turn from it on the left.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial

from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    div,
    neg,
    number,
    symbols_of,
)
from gainproof.verify.judge.exact.functions import first_case, has_jumps
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.total_expressions import is_total
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.reader.words import OF_CASES
from gainproof.verify.judge.transcendental.algebraic_form import bound_names
from gainproof.verify.judge.transcendental.domain_parts import ZERO, Holds, Part, opposite
from gainproof.verify.judge.transcendental.floor_function import whole_parts
from gainproof.verify.judge.transcendental.monomials import monomials
from gainproof.verify.judge.transcendental.pi import PI

MOST_PARTS = 300


def parts_of(
    statement: Statement, boxes: Boxes, labels: Mapping[str, str], holds: Holds
) -> list[Part]:
    """Parts that together are the domain, in which no function jumps. Raises Undecided."""
    waiting, done, tried = [Part(statement, boxes, labels)], list[Part](), 0
    while waiting:
        part = waiting.pop()
        put_in = partial(substituted, values=part.fixed)
        part = replace(part, statement=part.statement.mapped(put_in))
        claimed = first_jump(*_asked(part.statement))
        jump = claimed or first_jump(*part.statement.exprs())
        if jump is None or part.lacks:
            done.append(part)
            continue
        if symbols_of(jump) & bound_names(part.statement):
            raise Undecided("a function with jumps under a sum whose bounds are symbols")
        # on no further part is anything said where what decides on it has no value
        valued = tuple(Rel("<=", e, e) for e in _deciding(jump) if not is_total(e))
        new = [rel for rel in valued if rel.left not in part.statement.needed]
        if claimed is None:
            part = replace(part, statement=_given(part.statement, *valued))
        elif new:
            alone = Statement(tuple(new), given=part.statement.domain)
            waiting.append(replace(part, statement=alone, only_values=True))
            needed = (*part.statement.needed, *[rel.left for rel in new])
            part = replace(part, statement=replace(part.statement, needed=needed))
        for each in _split(part, jump, holds):
            tried += 1
            if tried > MOST_PARTS:
                raise Undecided(f"more than {MOST_PARTS} cases")
            waiting += [] if each is None else [each]
    return done


def _asked(statement: Statement) -> tuple[Expr, ...]:
    """Of what values are asked for on the whole domain."""
    return (*[e for rel in statement.asked for e in (rel.left, rel.right)], *statement.needed)


def _given(statement: Statement, *relations: Rel) -> Statement:
    """Under further conditions."""
    return replace(statement, given=tuple(dict.fromkeys((*statement.given, *relations))))


def first_jump(*exprs: Expr) -> Expr | None:
    """A function with jumps in whose arguments no other one is; of cases only what the first
    compares is looked at, since of the rest no value may be asked.
    """
    without: set[bytes] = set()

    def first(node: Expr) -> Expr | None:
        if node.key in without:
            return None
        inner = _deciding(node) if node.kind == "call" and has_jumps(node) else node.parts
        found = next((f for part in inner if (f := first(part)) is not None), None)
        if found is None and not has_jumps(node):
            without.add(node.key)
        return found or (node if has_jumps(node) else None)

    return next((f for expr in exprs if (f := first(expr)) is not None), None)


def _deciding(jump: Expr) -> tuple[Expr, ...]:
    """What tells where a function jumps."""
    if not jump.name.startswith(OF_CASES):
        return jump.parts
    return tuple(side for comparison in first_case(jump)[0] for side in comparison[1:])


def _split(part: Part, node: Expr, holds: Holds) -> Iterator[Part | None]:
    if node.name == "floor":
        yield from whole_parts(part, node, holds)
        return
    if node.name == "atan2":
        branches = _angles(*node.parts)
    elif node.name == "no jump":
        branches = _slopes(part, *node.parts)
    else:
        branches = _cases(node)
    for relations, value, lack in branches:
        within = _narrowed(part, relations, holds)
        if within is None or value is not None:
            yield within and within.put_in(node, value or ZERO)
        elif part.statement.connective != "if":
            yield within.put_in(node, div(number(1), ZERO))
        else:
            # only conditions may ask for it: they say nothing where it has no value
            is_asked = first_jump(*_asked(part.statement)) == node
            yield replace(within, lacks=lack) if is_asked else None


def _narrowed(part: Part, relations: Iterable[Rel], holds: Holds) -> Part | None:
    """Where relations hold; None if that is seen to be nowhere."""
    found: Part | None = part
    for rel in relations:
        if found is None or holds(opposite(rel), found):
            return None
        found = found.under(rel)
    return found


Branch = tuple[tuple[Rel, ...], Expr | None, str]


def _angles(y: Expr, x: Expr) -> Iterator[Branch]:
    def at(a: str, b: str = "") -> tuple[Rel, ...]:
        return (Rel(a, x, ZERO), *([Rel(b, y, ZERO)] if b else []))

    angle = Expr("call", "atan", (div(y, x),))
    yield at(">"), angle, ""
    yield at("<", ">"), add(angle, PI), ""
    yield at("<", "="), PI, ""
    yield at("<", "<"), add(angle, neg(PI)), ""
    yield at("=", ">"), div(PI, number(2)), ""
    yield at("=", "<"), neg(div(PI, number(2))), ""
    yield at("=", "="), None, "the angle of the origin"


def _slopes(part: Part, y: Expr, x: Expr, rise: Expr) -> Iterator[Branch]:
    yield (Rel(">", x, ZERO),), ZERO, ""
    yield (Rel("<=", x, ZERO), Rel("!=", y, ZERO)), ZERO, ""
    there = (Rel("<=", x, ZERO), Rel("=", y, ZERO))
    yield (*there, Rel("!=", rise, ZERO)), None, "an angle jumps by a whole turn"
    # where y is 0 to second order the angle may have a slope, and that is what the rules give: this
    # is asked for on a stated domain, and where nothing but such points is left
    stated = any(part.boxes.get(n, Box()).stated for n in symbols_of(y, x, rise))
    asked = stated or not monomials(y) or part.statement.connective != "if"
    value = Expr("call", "slope of an angle where y is 0", ()) if asked else ZERO
    yield (*there, Rel("=", rise, ZERO)), value, ""
    if not asked:
        # of points without one nothing is said, which has to be told
        yield (*there, Rel("=", rise, ZERO)), None, "an angle may jump by a whole turn"


def _cases(node: Expr) -> Iterator[Branch]:
    comparisons, value, other = first_case(node)
    relations = tuple(Rel(*each) for each in comparisons)
    yield relations, value, ""
    for k, rel in enumerate(relations):
        yield (*relations[:k], opposite(rel)), other, "none of the cases"
