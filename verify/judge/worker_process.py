"""A child process that judges, from inside: claim after claim, until nobody asks any more."""

from __future__ import annotations

import gc
from multiprocessing.connection import Connection

from gainproof.verify.judge.process_limits import GROWN, limit_memory, limit_time, most_memory
from gainproof.verify.judge.task import Models, Solved, Task
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.worker_answer import answer_bytes

READY = b"ready"
"""What it says first."""
STAYS, ENDS = b"+", b"."
"""Before an answer: whether the child takes another task."""
COLLECTED = 20_000
"""New objects after which cycles are looked for: after every 700, as is usual, looking took a tenth
of the time."""


def serve(pipe: Connection, models: Models, seconds: float) -> None:
    """A task in, a trial out, until the pipe closes or a claim took much memory. What is kept from
    claim to claim are environments, by their whole content. A task that takes more processor time
    than `seconds` or than its own limit ends the process.
    """
    gc.set_threshold(COLLECTED)
    limit_memory()
    usual = max(GROWN, most_memory())
    solved: Solved = {}
    try:
        pipe.send_bytes(READY)
        while True:
            task: Task = pipe.recv()
            limit_time(min(seconds, task.most))
            answer = answer_bytes(trial_of(task, models, solved))
            limit_time(None)
            # memory that was given back may be in pieces
            ends = most_memory() > usual
            pipe.send_bytes((ENDS if ends else STAYS) + answer)
            if ends:
                return
    except (EOFError, OSError):
        return  # nobody asks or listens any more


def trial_of(task: Task, models: Models, solved: Solved) -> Trial:
    """What the task came to in this process; what it raises costs its claim, no other."""
    try:
        return task.run(models, solved)
    except Exception as error:  # noqa: BLE001 - whatever it is costs this claim, no other
        reason = f"the judge stopped: {type(error).__name__}: {str(error)[:200]}"
        accident = "it took more memory than there was" if isinstance(error, MemoryError) else None
        return Trial(task.claim, {}, (), False, 0.0, reason, accident=accident)
