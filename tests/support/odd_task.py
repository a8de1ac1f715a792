"""A task that does what a judge should never do; here, where child processes can import it."""

from __future__ import annotations

import math
import os
import signal
import time
from dataclasses import dataclass, replace

import gainproof.verify.judge.process_limits as process_limits
import gainproof.verify.judge.worker as worker
from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.exact.statement import Enclosure, Witness
from gainproof.verify.judge.task import Models, Solved
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.verdict import Finding

CLAIM = Claim("a", "equation (1)", "identity", "s", "x = x", None)
WITNESS = Witness({"x": "1"}, "=", Enclosure("1", "0"), Enclosure("2", "0"))


@dataclass(frozen=True)
class Odd:
    """One such deed."""

    claim: Claim
    deed: str
    most: float = math.inf

    def run(self, models: Models, solved: Solved) -> Trial:  # noqa: ARG002 (of the protocol)
        """Does it."""
        match self.deed:
            case "hang":
                while True:
                    pass
            case "sleep":
                time.sleep(600)
            case "die":
                os.kill(os.getpid(), signal.SIGKILL)
            case "fail":
                raise KeyError("oh")
            case "fill":
                return Trial(
                    self.claim, {}, (), False, 0.0, str(len("x" * (process_limits.MEMORY + 1)))
                )
            case "swell":
                # bytes that are written, or the system gives no memory for them
                len(b"x" * (process_limits.GROWN + (64 << 20)))
            case "talk":
                long = {"": Finding("proved", "x" * (17 << 20))}
                return Trial(self.claim, long, (), False, 0.0)
        findings = {"no model": Finding("refuted", self.deed, witness=WITNESS)}
        return Trial(self.claim, findings, (), False, 0.0)


def odd(*deeds: str) -> list[Odd]:
    """Tasks on claims of their own."""
    return [Odd(replace(CLAIM, id=f"{n} {deed}"), deed) for n, deed in enumerate(deeds)]


def judge_and_hang() -> None:
    """A parent to be killed while its child hangs."""
    worker.tried_apart(odd("hang"), [], 2.0)
    worker.tried_apart(odd("hang"), [], 2.0)
