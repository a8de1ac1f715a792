"""The repair of one claim, as a piece of work for a process of its own."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.convention import Convention, conventions
from gainproof.verify.judge.dimensions.claim import fitting_readings
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.repair.change_words import in_words
from gainproof.verify.judge.repair.edits import PLAIN
from gainproof.verify.judge.repair.equal_offers import same_equation
from gainproof.verify.judge.repair.matrix_entries import PrintedMatrix, printed_matrix
from gainproof.verify.judge.repair.proof import Offer
from gainproof.verify.judge.repair.search import STAGES, Search
from gainproof.verify.judge.repair.true_value import true_value
from gainproof.verify.judge.scope import UndefinedSymbol
from gainproof.verify.judge.setting.environment import NotEstablished
from gainproof.verify.judge.task import Models, Solved
from gainproof.verify.judge.trial import Trial

SECONDS = 30.0
"""Processor time for the search, which has tried enough long before on any machine."""
OVERTIME = 10.0
"""Seconds more before it is stopped: it looks at the clock between two formulas only."""
MOST_NAMED = 3
"""Conventions under which one formula is true."""


@dataclass(frozen=True)
class RepairTask:
    """A claim that is not proved, the source's other claims on the same setting, the conventions
    under which a repair may hold, and whether it is true on a part of its domain.
    """

    claim: Claim
    setting: Setting
    others: tuple[Claim, ...]
    conventions: tuple[str, ...]
    partly: bool = False
    seconds: float = SECONDS
    most: float = SECONDS + OVERTIME

    def run(self, models: Models, solved: Solved) -> Trial:
        """A trial without findings whose `repair` lists the offers, the best first, each a proved
        formula with its changes in words.
        """
        start = time.perf_counter()
        deadline = time.process_time() + self.seconds
        chosen = [
            convention
            for convention in conventions(self.setting, models, solved)
            if isinstance(convention, Convention) and convention.name in self.conventions
        ]
        is_open = any(convention.open for convention in chosen)
        searches = [
            search for convention in chosen for search in _searches(self, convention, deadline)
        ]
        found: list[Offer] = []
        for stage in STAGES:
            if not found or (stage == 1 and min(o.change.weight for o in found) > PLAIN):
                for search in searches:
                    found += search.offers(stage)
        least = min((offer.change.weight for offer in found), default=0)
        best = _told([o for o in found if o.change.weight == least], searches, is_open)
        seconds = time.perf_counter() - start
        told: dict[str, Any] = {"offers": best}
        if not best and searches:
            first = searches[0]
            told["truth"] = true_value(first) if isinstance(first, Search) else first.truth()
        timed = time.process_time() > deadline
        return Trial(self.claim, {}, (), False, seconds, repair=told, timed=timed)


def _searches(
    task: RepairTask, convention: Convention, deadline: float
) -> list[Search | PrintedMatrix]:
    """One for each reading of the claim that can be searched."""
    claim, setting, environment = task.claim, convention.setting, convention.environment
    if claim.formula is None:
        return []
    fitting, _ = fitting_readings(claim.formula, setting)
    found: list[Search | PrintedMatrix] = []
    # where no reading has dimensions that agree, any may be the one with the slip
    for reading in fitting or claim.formula.readings:
        try:
            parts = (claim, reading, setting, environment, task.others, deadline)
            matrix = printed_matrix(*parts)
            found.append(Search(*parts, task.partly) if matrix is None else matrix)
        except (Undecided, Malformed, NotEstablished, UndefinedSymbol, ArithmeticError):
            continue  # no claim is worse off for a repair that was not found
    return found


def _told(
    offers: Sequence[Offer], searches: Sequence[Search | PrintedMatrix], is_open: bool
) -> list[dict[str, Any]]:
    """Each formula once, with the conventions under which it is true where one is open."""
    off = next((search.off for search in searches if isinstance(search, Search)), None)
    chosen: list[Offer] = []
    under: dict[str, list[str]] = {}
    for offer in offers:
        names = under.setdefault(offer.formula.latex, [])
        same = off is not None and any(
            same_equation(o.change.printed, offer.change.printed, off) for o in chosen
        )
        if not same and all(o.formula.latex != offer.formula.latex for o in chosen):
            chosen.append(offer)
        names += [offer.environment] if is_open and offer.environment not in names else []
    return [
        {
            "latex": offer.formula.latex,
            "changes": in_words(offer.change),
            "weight": offer.change.weight,
            "convention": " or ".join(under[offer.formula.latex][:MOST_NAMED]),
        }
        for offer in chosen
    ]
