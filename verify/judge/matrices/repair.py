"""The nearest true statement on matrices: what a misprint, or a slip, made of it.

Single changes of the printed text are tried at exact instances of the hypotheses, which refute
nearly all of them; of what is left, only what is proved is offered, by the way every claim is.
"""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import groupby, islice
from typing import Any

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.matrices.claim_directions import Case, cases_of
from gainproof.verify.judge.matrices.decision import decide
from gainproof.verify.judge.matrices.exact_instance import Instance, NoValueError, Unsupported
from gainproof.verify.judge.matrices.layered_proof import Proofs
from gainproof.verify.judge.matrices.letters import MatrixClaim, MatrixSetting
from gainproof.verify.judge.matrices.misprints import Slip, slips
from gainproof.verify.judge.matrices.random_instances import holds, instances
from gainproof.verify.judge.matrices.reader import read_statement
from gainproof.verify.judge.matrices.shapes import ShapeFault, Shapes
from gainproof.verify.judge.matrices.tree import REGULAR, Chain, Statement
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.repair.edits import LARGE
from gainproof.verify.judge.task import Models, Solved
from gainproof.verify.judge.trial import Trial, proofs_in

SECONDS = 20.0
"""Processor time for the search; more than it needs where proofs are short."""
OVERTIME = 10.0
FEW_INSTANCES = 3
MOST_PROVED = 12
"""Offers of one weight."""


@dataclass(frozen=True)
class MatrixRepairTask:
    """A claim on matrices that is not proved."""

    claim: Claim
    setting: Setting
    seconds: float = SECONDS
    most: float = SECONDS + OVERTIME

    def run(self, models: Models, solved: Solved) -> Trial:  # noqa: ARG002 - as every task
        """A trial without findings whose `repair` lists the offers, all of the least weight."""
        start = time.perf_counter()
        deadline = time.process_time() + self.seconds
        offers: list[dict[str, Any]] = []
        if self.claim.matrices is not None and self.setting.matrices is not None:
            found = repairs(
                self.claim.latex,
                self.claim.matrices,
                self.setting.matrices,
                proofs_in(solved),
                deadline,
            )
            offers = [
                {"latex": s.latex, "changes": [s.what], "weight": s.weight, "convention": ""}
                for s in found
            ]
        seconds = time.perf_counter() - start
        timed = time.process_time() > deadline
        return Trial(self.claim, {}, (), False, seconds, repair={"offers": offers}, timed=timed)


def repairs(
    latex: str, claim: MatrixClaim, setting: MatrixSetting, proofs: Proofs, deadline: float
) -> list[Slip]:
    """The nearest changes that make a claim true, all of one weight, first those after which most
    is printed as in other places; none after the deadline.
    """
    for _, alike in groupby(slips(latex, setting), key=lambda slip: slip.weight):
        found: list[tuple[Slip, MatrixClaim]] = []
        for slip, other in _true_at_instances(alike, claim, setting, deadline):
            if decide(other, setting, proofs).verdict == "proved":
                found.append((slip, other))
            if len(found) == MOST_PROVED:
                break
        if found:
            found.sort(key=lambda pair: -_agreeing(pair[1].statement, setting))
            return [slip for slip, _ in found]
    return []


def _agreeing(statement: Statement, setting: MatrixSetting) -> int:
    """How many composed parts of a statement stand in a definition too, or twice in it."""
    chains = (*statement.chains, *statement.after)
    parts = [n for chain in chains for side in chain.sides for n in side.walk() if n.parts]
    defined = [letter.definition for letter in setting.letters.values()]
    known = {n for body in defined if body is not None for n in body.walk() if n.parts}
    times = Counter(parts)
    return sum((part in known) + (times[part] > 1) for part in parts)


def _true_at_instances(
    changed: Iterable[Slip], claim: MatrixClaim, setting: MatrixSetting, deadline: float
) -> Iterator[tuple[Slip, MatrixClaim]]:
    shapes = Shapes(setting.letters, setting.sizes)
    # a change may bring any number before any matrix
    setting = shapes.with_added(setting, every=True)
    tried: dict[tuple[Any, ...], list[Instance]] = {}
    for slip in changed:
        if time.process_time() > deadline:
            return
        try:
            statement = read_statement(slip.latex, setting.letters, setting.sizes)
            other = replace(claim, statement=statement)
            cases = cases_of(other, shapes)
        except (ReaderError, ShapeFault, RecursionError):
            continue
        if slip.weight == LARGE and _is_free(other, shapes, setting):
            continue
        if not _says_nothing(statement) and all(_holds(case, setting, tried) for case in cases):
            yield slip, other


def _says_nothing(statement: Statement) -> bool:
    """Whether a relation has the same on both sides, or both directions do."""
    chains = (*statement.chains, *statement.after)
    same = any(
        one == other
        for chain in chains
        for one, other in zip(chain.sides, chain.sides[1:], strict=False)
    )
    return same or (bool(statement.connective) and statement.chains == statement.after)


def _is_free(claim: MatrixClaim, shapes: Shapes, setting: MatrixSetting) -> bool:
    """Whether a statement with a part put in holds for letters of any values: B + B = 2 B."""
    free = {
        name: replace(letter, definition=None, facts=()) for name, letter in setting.letters.items()
    }
    anything = replace(setting, letters=free)
    return all(_holds(case, anything, {}) for case in cases_of(claim, shapes))


def _holds(
    case: Case, setting: MatrixSetting, tried: dict[tuple[Any, ...], list[Instance]]
) -> bool:
    """Whether a case is true at instances of its hypotheses, of which there are some."""
    question = case.question
    key = (question.given, question.invertible, case.bounds)
    if key not in tried:
        # letters that a change may bring in have values too
        made = instances(setting, question.given, question.invertible, case.bounds)
        tried[key] = list(islice(made, FEW_INSTANCES))
    wanted = (*question.chains, *(Chain((node,), (REGULAR,)) for node in question.existing))
    try:
        return bool(tried[key]) and all(
            holds(chain, instance) for instance in tried[key] for chain in wanted
        )
    except (NoValueError, Unsupported, RecursionError):
        return False
