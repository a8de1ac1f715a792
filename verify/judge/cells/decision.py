"""Verdicts on statements with several real parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.cells.cell_statement import Budget, Task
from gainproof.verify.judge.cells.cell_truth import Part, Piece, all_pieces
from gainproof.verify.judge.cells.cells_and_borders import exact_part, parts
from gainproof.verify.judge.cells.certificate import cells_certificate
from gainproof.verify.judge.cells.domain_text import domain_text
from gainproof.verify.judge.cells.integers import runs_of, whole_points
from gainproof.verify.judge.cells.witness import counterexample, simple_points
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import roots_made_prime, substituted
from gainproof.verify.judge.exact.expression import number
from gainproof.verify.judge.exact.rational_points import failure_at
from gainproof.verify.judge.exact.statement import Outcome, Statement, Witness, unstated
from gainproof.verify.judge.exact.truth import SKIPPED, TRUE
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Limits, Nowhere, Undecided

METHOD = "truth on the open cells of several parameters"
BORDERS = "; borders solved for a parameter and decided in the same way"
EMPTY = Outcome("empty", "", "", "")


def decide_in_cells(
    statement: Statement,
    boxes: Mapping[str, Box],
    labels: Mapping[str, str] | None = None,
    limits: Limits = DEFAULT_LIMITS,
    *,
    only_proof: bool = False,
) -> Outcome:
    """The verdict on a statement; all its symbols are real parameters. Raises Undecided.

    With `only_proof` whatever fails somewhere is `refuted`, without a witness or a domain.
    """
    labels = labels or {}
    original = {name: boxes.get(name, unstated()) for name in sorted(statement.symbols())}
    for name, box in original.items():
        if box.is_empty:
            raise Undecided(f"the domain of {labels.get(name, name)} is empty")
    task = _task(statement.mapped(roots_made_prime), original)
    if len(task.names) > limits.parameters:
        raise Undecided(f"more than {limits.parameters} parameters")
    stated = frozenset(name for name, box in original.items() if box.stated)
    budget = Budget(limits)
    found = list(parts(task, budget, stated))
    outcome = _outcome(task, found, budget, stated, labels, only_proof)
    if outcome.verdict != "proved" and any(box.integer for box in original.values()):
        outcome = _for_integers(task, outcome, original, labels, limits)
    certificate = cells_certificate(statement, original, found, labels)
    return replace(outcome, certificate=certificate)


def _for_integers(
    task: Task,
    outcome: Outcome,
    boxes: Mapping[str, Box],
    labels: Mapping[str, str],
    limits: Limits,
) -> Outcome:
    """What a statement that is false for real numbers is for integers: refuted by a simple point
    or at an integer, or proved on real intervals that hold all integers. Raises Undecided.
    """
    whole = [name for name in task.names if boxes[name].integer]
    for tried, point in enumerate(simple_points(task), start=1):
        if all(point[name].denominator == 1 for name in whole):
            witness = failure_at(task.statement, point, labels)
            if witness is not None:
                return _failing(outcome, witness, tried)
    for name in whole:
        runs = runs_of(task, name, boxes, limits)
        each = [_within(task, {**boxes, name: box}, labels, limits) for box in runs.intervals]
        # where the conditions hold nowhere there is nothing to prove
        found = [outcome for outcome in each if outcome != EMPTY]
        if runs.failing is None and each and not found:
            raise Nowhere
        proofs = [outcome for outcome in found if outcome and outcome.verdict == "proved"]
        if proofs and len(proofs) == len(found):
            return _for_all_integers(proofs, boxes, labels)
        ends = [end for box in runs.intervals for end in (box.lower, box.upper) if end is not None]
        for value in ends if runs.failing is None else [Fraction(runs.failing)]:
            point_box = Box(value, value, lower_open=False, upper_open=False)
            there = _within(task, {**boxes, name: point_box}, labels, limits)
            if there is not None and there.witness is not None:
                return _failing(outcome, there.witness, 1)
    few: list[Outcome | None] = []
    for fixed in whole_points(whole, boxes):
        there = _within(task, {**boxes, **fixed}, labels, limits)
        if there is not None and there.witness is not None:
            return _failing(outcome, there.witness, 1)
        few.append(there)
    names = ", ".join(labels.get(name, name) for name in whole)
    proofs = [there for there in few if there is not None and there.verdict == "proved"]
    if proofs and all(there == EMPTY or there in proofs for there in few):
        return _for_all_integers(proofs, boxes, labels)
    raise Undecided(f"false for real numbers; whether for integers {names} was not decided")


def _for_all_integers(
    proofs: Sequence[Outcome], boxes: Mapping[str, Box], labels: Mapping[str, str]
) -> Outcome:
    domain = ", ".join(box.text(labels.get(n, n)) for n, box in sorted(boxes.items()))
    reason = "holds for all integers, though not for all real numbers between them"
    return Outcome("proved", f"for {domain}", reason, proofs[0].method)


def _within(
    task: Task, boxes: Mapping[str, Box], labels: Mapping[str, str], limits: Limits
) -> Outcome | None:
    """What the statement is on a part of its domain, `EMPTY` where its conditions hold nowhere;
    None if undecided, since a reason of the part is none of the whole.
    """
    try:
        found = decide_in_cells(task.statement, boxes, labels, limits)
    except Nowhere:
        return EMPTY
    except Undecided:
        return None
    if found.witness is None:
        return found
    put_in = {labels.get(n, n): str(b.lower) for n, b in boxes.items() if b.lower == b.upper}
    return replace(found, witness=replace(found.witness, point={**put_in, **found.witness.point}))


def _failing(outcome: Outcome, witness: Witness, tried: int) -> Outcome:
    reason = f"fails {witness.text()}"
    if outcome.verdict == "conditional":
        reason += f"; holds at least {outcome.domain}"
    return replace(outcome, witness=witness, reason=reason, reach=tried)


def _task(statement: Statement, boxes: Mapping[str, Box]) -> Task:
    """The statement over all reals of the boxes, in the source's own symbols; a box of one point
    is put in.
    """
    fixed = {
        name: number(box.lower)
        for name, box in boxes.items()
        if box.lower is not None and box.lower == box.upper
    }
    parts = tuple(e for rel in statement.asked for e in (rel.left, rel.right)) + statement.needed
    moved = statement.mapped(lambda expr: substituted(expr, fixed))
    left = {n: replace(b, integer=False) for n, b in boxes.items() if n not in fixed}
    return Task(moved, left, tuple(fixed.items()), parts=parts)


def _outcome(
    task: Task,
    found: Sequence[Part],
    budget: Budget,
    stated: frozenset[str],
    labels: Mapping[str, str],
    only_proof: bool,
) -> Outcome:
    pieces = all_pieces(found)
    present = [p for p in pieces if p.truth != SKIPPED]
    relevant = [p for p in present if p.counted]
    failed = [p for p in relevant if p.truth != TRUE]
    if budget.gaps and not failed:
        failed = _failing_points(task, budget, stated)
        if not failed:
            raise Undecided(f"{budget.gaps[0][1]}; it holds wherever else")
    if not relevant:
        if present:
            raise Undecided("the formula has no value anywhere on its domain")
        raise Nowhere
    size = max(p.dimension for p in present)
    wide = [p for p in relevant if p.truth == TRUE and p.dimension == size]
    method = METHOD + (BORDERS if len(found) > 1 else "")
    if not failed:
        if not wide:
            raise Undecided("the formula has a value on a thin set only")
        domain, _ = domain_text(task, found, budget, stated, labels)
        return Outcome("proved", domain, "holds on the whole domain", method)
    if only_proof:
        return Outcome("refuted", "", "fails somewhere", method)
    witness, tried = counterexample(task, failed, labels)
    if wide:
        domain, whole = domain_text(task, found, budget, stated, labels)
        extent = "holds exactly" if whole else "holds at least"
        reason = f"fails {witness.text()}; {extent} {domain}"
        return Outcome("conditional", domain, reason, method, witness, {}, tried)
    thin = any(p.truth == TRUE for p in relevant)
    reason = f"fails {witness.text()}" + ("; holds on a thin set only" if thin else "")
    domain = "on a thin set only" if thin else "nowhere"
    return Outcome("refuted", domain, reason, method, witness, {}, tried)


def _failing_points(task: Task, budget: Budget, stated: frozenset[str]) -> list[Piece]:
    """Simple points at which the statement is exactly false, where a border was not decided."""
    for point in simple_points(task):
        values = {name: number(value) for name, value in point.items()}
        statement = task.statement.mapped(lambda e, v=values: substituted(e, v))  # type: ignore[misc]
        solved = (*task.solved, *values.items())
        there = replace(task, statement=statement, boxes={}, solved=solved)
        part = exact_part(there, Budget(budget.limits), stated)
        failed = [p for p in part.pieces if p.counted and p.truth != TRUE]
        if failed:
            return failed
    return []
