"""A child process that judges, from inside: claim after claim, until nobody asks any more."""

from __future__ import annotations

import gc
from multiprocessing.connection import Connection

from gainproof.verify.judge.answer import answer_bytes
from gainproof.verify.judge.process_limits import GROWN, limit_memory, limit_time, most_memory
from gainproof.verify.judge.task import Models, Solved, Task
from gainproof.verify.judge.trial import Trial

READY = b"ready"
"""What it says first."""
STAYS, ENDS = b"+", b"."
"""Before an answer: whether the child takes another task."""
COLLECTED = 20_000
"""New objects after which cycles are looked for: after every 700, as is usual, looking took a tenth
of the time."""


def serve(pipe: Connection, models: Models, seconds: float) -> None:
    """A task in, a trial out, until the pipe closes or a claim took much memory. What is kept from
    claim to claim are environments, by their whole content.
    """
    gc.set_threshold(COLLECTED)
    limit_memory()
    usual = max(GROWN, most_memory())
    solved: Solved = {}
    pipe.send_bytes(READY)
    while True:
        try:
            task: Task = pipe.recv()
        except (EOFError, OSError):
            return
        limit_time(seconds)
        try:
            answer = answer_bytes(task.run(models, solved))
        except Exception as error:  # noqa: BLE001 - whatever it is costs this claim, no other
            reason = f"the judge stopped: {type(error).__name__}: {str(error)[:200]}"
            answer = answer_bytes(Trial(task.claim, {}, (), False, 0.0, reason))
        # memory that was given back may be in pieces
        ends = most_memory() > usual
        pipe.send_bytes((ENDS if ends else STAYS) + answer)
        if ends:
            return
