"""Pieces of work on one claim, each of which may run in a process of its own."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.trial import Trial, try_claim

Models = Sequence[Mapping[str, Any]]
Solved = dict[Any, Any]
"""Environments by what they were made of, and proofs of claims on matrices."""


class Task(Protocol):
    """Work on one claim; `run` raises nothing that has to do with the claim."""

    @property
    def claim(self) -> Claim:
        """The claim."""
        ...

    @property
    def most(self) -> float:
        """Seconds after which it is stopped, even if more are allowed for a claim."""
        ...

    def run(self, models: Models, solved: Solved) -> Trial:
        """What it came to; `solved` keeps what it finds for other tasks."""
        ...


@dataclass(frozen=True)
class TrialTask:
    """A claim under every convention that its setting admits."""

    claim: Claim
    setting: Setting
    most: float = math.inf

    def run(self, models: Models, solved: Solved) -> Trial:
        """The trial."""
        return try_claim(self.claim, self.setting, models, solved)
