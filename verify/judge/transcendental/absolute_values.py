"""Statements with sizes |a| as statements without them.

|a| <= b says that a <= b and -a <= b; b <= |a| follows from b <= a as from b <= -a. Of a symbol
|x| is x where x >= 0 and -x where x <= 0, so that what holds on both parts of a domain, each with
the size written out, holds on the whole.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import product

from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.expression import Expr, neg, power, walk
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.transcendental.algebraic_form import bound_names
from gainproof.verify.judge.transcendental.certificate import Decides, certificate_of
from gainproof.verify.judge.transcendental.domain_text import domain_text
from gainproof.verify.judge.transcendental.free_values import where_valued

MOST_SYMBOLS = 3
"""Of either sign: of more there are too many parts."""


def by_sizes(
    statement: Statement,
    boxes: Boxes,
    parameter: str | None,
    labels: Mapping[str, str],
    decides: Decides,
) -> Outcome | None:
    """Proved with sizes written out, on every part of the domain; None if it is not."""
    if statement.connective != "if":
        return None
    proofs: list[Outcome] = []
    for part, where in without_sizes(statement, boxes) or [(statement, boxes)]:
        # the statement itself is asked about already
        itself = [] if part is statement else [part]
        found = _first_proved([*itself, *_saying_more(part)], where, parameter, labels, decides)
        if found is None:
            return None
        proofs.append(found)
    domain = domain_text(statement, boxes, labels)
    whole = not any("where" in found.domain for found in proofs)
    return Outcome(
        "proved",
        domain if whole else where_valued(domain),
        "holds with every size written out, whatever the signs",
        f"sizes by signs; {'; '.join(dict.fromkeys(each.method for each in proofs))}",
        None,
        certificate_of(statement, boxes, parameter, labels),
    )


def _first_proved(
    statements: Sequence[Statement],
    boxes: Boxes,
    parameter: str | None,
    labels: Mapping[str, str],
    decides: Decides,
) -> Outcome | None:
    for each in statements:
        try:
            found = decides(each, boxes, parameter, labels)
        except Undecided:
            continue
        if found.verdict == "proved":
            return found
    return None


def _saying_more(statement: Statement) -> Iterator[Statement]:
    """With a, then with -a, where |a| is the larger side: from either the statement follows."""
    for turn in (lambda a: a, neg):
        relations = tuple(_larger(rel, turn) for rel in statement.relations)
        if relations != statement.relations:
            yield replace(statement, relations=relations)


def _larger(rel: Rel, turn: Callable[[Expr], Expr]) -> Rel:
    left, right = _whole_size(rel.left), _whole_size(rel.right)
    if left is not None and rel.operator in (">", ">="):
        return replace(rel, left=turn(left))
    if right is not None and rel.operator in ("<", "<="):
        return replace(rel, right=turn(right))
    return rel


def without_sizes(statement: Statement, boxes: Boxes) -> list[tuple[Statement, Boxes]]:
    """Statements with their domains that together say what this one says; none where there is no
    size to be written out. Only of statements of the form `relations if conditions`.
    """
    apart = replace(
        statement, relations=tuple(part for rel in statement.relations for part in _both(rel))
    )
    names = sorted(_measured(apart))
    if (apart == statement and not names) or len(names) > MOST_SYMBOLS:
        return []
    found: list[tuple[Statement, Boxes]] = []
    for signs in product((1, -1), repeat=len(names)):
        of = dict(zip(names, signs, strict=True))
        parts = {name: _part(boxes.get(name, Box(stated=False)), of[name]) for name in names}
        if not any(box.is_empty for box in parts.values()):
            found.append((apart.mapped(partial(_written_out, signs=of)), {**boxes, **parts}))
    return found


def _both(rel: Rel) -> Iterator[Rel]:
    """A bound of a size as two of what it is the size of; that of a symbol is left to its signs."""
    left, right = _whole_size(rel.left), _whole_size(rel.right)
    if left is not None and left.kind != "symbol" and rel.operator in ("<", "<="):
        yield from (replace(rel, left=left), replace(rel, left=neg(left)))
    elif right is not None and right.kind != "symbol" and rel.operator in (">", ">="):
        yield from (replace(rel, right=right), replace(rel, right=neg(right)))
    else:
        yield rel


def _whole_size(side: Expr) -> Expr | None:
    """The a of |a|."""
    size = _inside(side)
    return size[0] if size is not None and size[1] == 1 else None


def _measured(statement: Statement) -> set[str]:
    """Symbols that stand in it with their size."""
    sizes = (_inside(node) for node in walk(*statement.exprs()))
    names = {size[0].name for size in sizes if size is not None and size[0].kind == "symbol"}
    return names - bound_names(statement)


def _inside(node: Expr) -> tuple[Expr, Fraction] | None:
    """Of |a|^n the a and n: (a^2)^(n/2), or of a higher even power."""
    if node.kind != "pow" or node.fraction.denominator != 2:
        return None
    (square,) = node.parts
    if square.kind != "pow" or square.fraction <= 0 or square.fraction % 2 != 0:
        return None
    return square.parts[0], node.fraction * square.fraction


def _part(box: Box, sign: int) -> Box:
    """The numbers of a box that are not below 0, or not above it."""
    if sign > 0:
        above = box.lower is not None and box.lower >= 0
        return box if above else replace(box, lower=Fraction(0), lower_open=False)
    below = box.upper is not None and box.upper <= 0
    return box if below else replace(box, upper=Fraction(0), upper_open=False)


def _written_out(expr: Expr, signs: Mapping[str, int]) -> Expr:
    """With the size of every symbol that has a sign."""

    def change(node: Expr, _: tuple[Expr, ...]) -> Expr | None:
        size = _inside(node)
        if size is None or size[0].kind != "symbol" or size[0].name not in signs:
            return None
        signed = size[0] if signs[size[0].name] > 0 else neg(size[0])
        return signed if size[1] == 1 else power(signed, size[1])

    return rebuilt(expr, change)
