"""Statements with a free variable in place of each function value: proved so, they hold whatever
values the functions take.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from itertools import combinations
from math import ceil

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of, walk
from gainproof.verify.judge.exact.rational_points import (
    try_points,
)
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Nowhere, Undecided
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.transcendental.algebraic_form import (
    Freed,
    arguments,
    bound_names,
    freed,
    has_functions,
)
from gainproof.verify.judge.transcendental.domain_text import domain_text
from gainproof.verify.judge.transcendental.pi import LABEL, PI, VARIABLE, as_variable, pi_box
from gainproof.verify.judge.transcendental.separated_sums import by_sums
from gainproof.verify.judge.transcendental.statements_at_numbers import (
    TRIED,
    at_number,
    first_numbers,
)
from gainproof.verify.judge.transcendental.symbols_over_pi import scaled

FREED = "function values as free variables"
MOST_ANGLES = 3
VALUED = "where every part has a value"


def where_valued(domain: str) -> str:
    """The words of a domain of which only those points are spoken of."""
    if VALUED in domain:
        return domain
    return VALUED if domain in ("", "everywhere") else f"{domain}, {VALUED}"


def freely(
    statement: Statement, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> Outcome:
    turned = scaled(statement, boxes, labels)
    statement, boxes, labels = turned.statement, turned.boxes, turned.labels
    asked, within = statement, boxes
    try:
        opened, outcome = _settled(asked, within, parameter, labels, stated=False)
    except Undecided:
        asked, within = _from_zero(statement, boxes)
        if asked == statement:
            raise
        opened, outcome = _settled(asked, within, parameter, labels, stated=False)
    exclusions = opened.exclusions
    if not all(box.stated for box in opened.boxes.values()):
        everywhere = {n: replace(within.get(n, Box()), stated=True) for n in asked.symbols()}
        try:
            _settled(asked, everywhere, parameter, labels, stated=True)
        except Undecided:
            refuse_without_value(statement, boxes, parameter, labels)
            exclusions = (*exclusions, VALUED)
    domain = ", ".join([domain_text(statement, boxes, labels), *turned.words, *exclusions])
    # the words tell of bounds alone: a region of one parameter holds further conditions
    return replace(
        outcome,
        method=f"{FREED}; {outcome.method}",
        domain=domain.removeprefix("everywhere, "),
        region=(),
    )


def _from_zero(
    statement: Statement, boxes: Mapping[str, Box]
) -> tuple[Statement, Mapping[str, Box]]:
    """Whole exponents counted from the first that they may be, with their domains: where n >= 2,
    x^(n - 1) is x times x^(n - 2), and written as x^n/x it would lack its value at x = 0.
    """
    powers = [n for n in walk(*statement.exprs()) if n.kind == "call" and n.name == "power"]
    names = symbols_of(*[p.parts[1] for p in powers]) - bound_names(statement)
    known = {n: boxes[n] for n in names if n in boxes}
    starts = {n: ceil(b.lower) for n, b in known.items() if b.integer and b.lower is not None}
    starts = {n: first for n, first in starts.items() if first > 0}
    # no symbol of a source is called so, and it reads as what it is
    counted = {n: f"{n} - {first}" for n, first in starts.items()}
    put_in = {n: symbol(counted[n]) + first for n, first in starts.items()}
    within = {
        counted[n]: replace(
            box, lower=box.lower - first, upper=None if box.upper is None else box.upper - first
        )
        for n, first in starts.items()
        for box in [known[n]]
        if box.lower is not None
    }
    kept = {n: box for n, box in boxes.items() if n not in counted}
    return statement.mapped(lambda e: substituted(e, put_in)), {**kept, **within}


def _settled(
    statement: Statement,
    boxes: Mapping[str, Box],
    parameter: str | None,
    labels: Mapping[str, str],
    *,
    stated: bool,
) -> tuple[Freed, Outcome]:
    """The freed statement, which must be proved; with `stated` no divisor at all may vanish. Raises
    Undecided.
    """
    if PI in walk(*statement.exprs()):
        statement = replace(statement, needed=(*statement.needed, *arguments(statement)))
        statement, boxes = statement.mapped(as_variable), {**boxes, VARIABLE.name: pi_box()}
        labels = {**labels, VARIABLE.name: LABEL}

    def is_positive(expr: Expr) -> bool:
        return _holds(Rel(">", expr, number(0)), statement, boxes, parameter)

    def proved(opened: Freed) -> Outcome:
        where = {n: replace(b, stated=stated or b.stated) for n, b in opened.boxes.items()}
        names = {**labels, **opened.labels}
        found = _by_sums_or_cells(opened.statement, where, parameter, names)
        if found.verdict != "proved":
            raise Undecided(f"not true of {FREED}, which refutes nothing")
        return found

    opened = freed(statement, boxes, is_positive)
    outcomes = list[Outcome]()
    with suppress(Nowhere):
        outcomes.append(proved(opened))
    if len(opened.whole_turns) > MOST_ANGLES:
        raise Undecided(f"more than {MOST_ANGLES} angles that may be half a turn")
    for count in range(1, len(opened.whole_turns) + 1):
        for turned in combinations(opened.whole_turns, count):
            with suppress(Nowhere):
                outcomes.append(proved(freed(statement, boxes, is_positive, frozenset(turned))))
    if not outcomes:
        raise Nowhere
    return opened, outcomes[0]


def refuse_without_value(
    statement: Statement, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> None:
    """Raises Undecided unless the statement is seen to have a value at a point: function values
    that were freed may cancel in a divisor everywhere.
    """
    first = [(name, n) for name, few, _ in first_numbers(statement, boxes) for n in few[:TRIED]]
    for name, value in [("", 0), *first]:
        part = at_number(statement, name, value)
        try:
            found = (
                try_points(part, boxes, labels)
                if has_functions(part)
                else settle(part, boxes, parameter, labels)
            )
        except Undecided:
            continue
        if found is not None and found.verdict != "refuted":
            return
    raise Undecided("the formula may have no value anywhere")


def _holds(rel: Rel, statement: Statement, boxes: Mapping[str, Box], parameter: str | None) -> bool:
    """Whether it follows from the conditions without functions."""
    plain = [c for c in statement.domain if not has_functions(Statement((c,)))]
    part = Statement((rel,), tuple(plain))
    try:
        if has_functions(part):
            return _settled(part, boxes, parameter, {}, stated=True)[1].verdict == "proved"
        outcome = _by_sums_or_cells(part, boxes, parameter, {})
    except Undecided:
        return False
    return outcome.verdict == "proved"


def _by_sums_or_cells(
    statement: Statement, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> Outcome:
    """What is proved, or anything else; of what is not proved no witness is asked for."""
    found = by_sums(statement, boxes, parameter, labels)
    return found or settle(statement, boxes, parameter, labels, only_proof=True)
