"""Decides statements that may hold exponentials, angles, symbolic powers and open sums."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of, walk
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.points import try_points
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement, Witness
from gainproof.verify.judge.freed.induction import induction, open_sums
from gainproof.verify.judge.freed.rewriting import freed, has_functions
from gainproof.verify.judge.hypothesis import settle
from gainproof.verify.judge.meaning.evaluation import general_power
from gainproof.verify.judge.meaning.sequences import is_term, with_variables
from gainproof.verify.judge.meaning.sums import sum_of

FREED = "function values as free variables"
TRIED = 5


def decided(
    statement: Statement, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> Outcome:
    """The verdict on a statement. Raises Undecided.

    With functions in it: proved if it holds for whatever values these take, or by induction;
    refuted by balls at an exact point, or by the algebraic statement for one whole number.
    """
    if not has_functions(statement):
        return settle(statement, boxes, parameter, labels)
    reasons: list[str] = []
    sums = open_sums(statement)
    ways = [_freely] if all(_is_total(s.parts[0]) for s in sums) else []
    ways += [_inductively, _for_numbers] if sums else [_for_numbers]
    for attempt in ways:
        try:
            return attempt(statement, boxes, parameter, labels)
        except Undecided as reason:
            reasons.append(str(reason))
    points = try_points(statement, boxes, labels)
    if points is None:
        raise Undecided("; ".join(dict.fromkeys(r for r in reasons if r)))
    return points


def _is_total(summand: Expr) -> bool:
    """Whether all terms have a value, at a glance: then so has the sum, whatever it is."""
    return all(
        n.kind in ("number", "symbol", "add", "mul", "neg")
        or (n.kind == "pow" and n.fraction.denominator == 1 and n.fraction >= 0)
        or is_term(n)
        for n in walk(summand)
    )


def _freely(
    statement: Statement, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> Outcome:
    def is_positive(expr: Expr) -> bool:
        return _holds(Rel(">", expr, number(0)), statement, boxes, parameter)

    opened = freed(statement, boxes, is_positive)
    outcome = settle(opened.statement, opened.boxes, parameter, {**labels, **opened.labels})
    if outcome.verdict != "proved":
        raise Undecided(f"not true of {FREED}, which refutes nothing")
    domain = ", ".join([_domain_text(statement, boxes, labels), *opened.exclusions])
    return replace(
        outcome, method=f"{FREED}; {outcome.method}", domain=domain.removeprefix("everywhere, ")
    )


def _holds(rel: Rel, statement: Statement, boxes: Mapping[str, Box], parameter: str | None) -> bool:
    try:
        outcome = settle(Statement((rel,), statement.conditions), boxes, parameter, {})
    except Undecided:
        return False
    return outcome.verdict == "proved"


def _inductively(
    statement: Statement, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> Outcome:
    certificate = {}
    for words, part, where in induction(statement, boxes):
        plain = not has_functions(part)
        work = settle if plain else _freely
        found = work(part, where, parameter, labels)
        if found.verdict != "proved":
            raise Undecided(f"an induction fails {words}, which refutes nothing: {found.reason}")
        certificate[words] = dict(found.certificate)
    domain = _domain_text(statement, boxes, labels)
    return Outcome("proved", domain, "holds on the whole domain", "induction", None, certificate)


def _for_numbers(
    statement: Statement, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> Outcome:
    """The statement for the first whole numbers that a symbol may be: one that fails refutes it."""
    for name, value in _first_numbers(statement, boxes):
        put_in = {name: number(value)}
        part = statement.mapped(lambda e, p=put_in: _written_out(substituted(e, p)))  # type: ignore[misc]
        if has_functions(part):
            continue
        try:
            found = settle(part, boxes, parameter, labels)
        except Undecided:
            continue
        if found.verdict in ("refuted", "conditional") and found.witness is not None:
            point = {labels.get(name, name): str(value), **found.witness.point}
            witness: Witness = replace(found.witness, point=point)
            reason = f"fails {witness.text()}; where it may hold is not determined"
            return replace(found, verdict="refuted", domain="", reason=reason, witness=witness)
    raise Undecided("")


def _first_numbers(statement: Statement, boxes: Mapping[str, Box]) -> Iterator[tuple[str, int]]:
    bound = {s.parts[1].name for s in open_sums(statement)}
    for name in sorted(statement.symbols() - bound):
        box = boxes.get(name, Box())
        if box.integer:
            start = 0 if box.lower is None else int(box.lower.__ceil__())
            numbers = (n for n in range(start, start + 2 * TRIED) if box.holds(number(n).fraction))
            yield from ((name, n) for n, _ in zip(numbers, range(TRIED), strict=False))


def _written_out(expr: Expr) -> Expr:
    def sums(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        if node.kind == "call" and node.name == "sum":
            return sum_of(parts[0], parts[1].name, parts[2], parts[3])[0]
        return None

    def powers(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
        return general_power(*parts) if node.kind == "call" and node.name == "power" else None

    return with_variables(rebuilt(rebuilt(expr, sums), powers))


def _domain_text(statement: Statement, boxes: Mapping[str, Box], labels: Mapping[str, str]) -> str:
    named = sorted(n for n in symbols_of(*statement.exprs()) if n in boxes)
    bounded = [n for n in named if boxes[n].lower is not None or boxes[n].upper is not None]
    return ", ".join(boxes[n].text(labels.get(n, n)) for n in bounded) or "everywhere"
