"""The repair of one claim, as a piece of work for a process of its own."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any

from gainproof.verify.judge.claim_record import Claim, Setting
from gainproof.verify.judge.convention import Convention, conventions
from gainproof.verify.judge.dimension import fitting_readings
from gainproof.verify.judge.exact.limits import Malformed, Undecided
from gainproof.verify.judge.repair.search import Offer, Search
from gainproof.verify.judge.repair.words import in_words
from gainproof.verify.judge.scope import UndefinedSymbol
from gainproof.verify.judge.setting.environment import Environment, NotEstablished
from gainproof.verify.judge.task import Models, Solved
from gainproof.verify.judge.trial import Trial

SECONDS = 8.0
"""Time for the search, of which formulas with one misprint take a small part."""


@dataclass(frozen=True)
class RepairTask:
    """A claim that is not proved, the source's other claims on the same setting, the conventions
    under which a repair may hold.
    """

    claim: Claim
    setting: Setting
    others: tuple[Claim, ...]
    environments: tuple[str, ...]
    seconds: float = SECONDS

    def run(self, models: Models, solved: Solved) -> Trial:
        """A trial without findings whose `repair` lists the offers, the best first, each a proved
        formula with its changes in words.
        """
        start = time.perf_counter()
        found: list[Offer] = []
        for convention in conventions(self.setting, models, solved):
            if not isinstance(convention, Convention):
                continue
            if convention.environment.name in self.environments:
                found += _offers(self, convention.environment, start + self.seconds)
        least = min((offer.change.weight for offer in found), default=0)
        best = [_plain(offer) for offer in found if offer.change.weight == least]
        seconds = time.perf_counter() - start
        return Trial(self.claim, {}, (), False, seconds, repair={"offers": best})


def _offers(task: RepairTask, environment: Environment, deadline: float) -> list[Offer]:
    claim, setting = task.claim, task.setting
    if claim.formula is None:
        return []
    fitting, _ = fitting_readings(claim.formula, setting)
    found: list[Offer] = []
    for reading in fitting or claim.formula.readings[:1]:
        try:
            search = Search(claim, reading, setting, environment, task.others, deadline)
            found += search.offers()
        except (Undecided, Malformed, NotEstablished, UndefinedSymbol, ArithmeticError):
            continue  # no claim is worse off for a repair that was not found
    return found


def _plain(offer: Offer) -> dict[str, Any]:
    return {
        "latex": offer.formula.latex,
        "changes": in_words(offer.change),
        "weight": offer.change.weight,
        "convention": offer.environment,
    }
