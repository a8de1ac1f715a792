"""Claims judged in child processes that can be killed: a claim that hangs costs one claim.

Signals do not interrupt the arithmetic library, so a time limit needs a process of its own. A child
keeps the environments it solved and takes claim after claim; after a kill a new one is started.
Its memory and its processor time are limited where the system can do that (`process_limits`), so
that a child whose parent was killed ends too. What comes back is JSON text of limited size.
Works with every start method, `spawn` included.
"""

from __future__ import annotations

import multiprocessing
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from typing import Any

from gainproof.verify.judge.answer import MOST_BYTES, BadAnswer, answer_bytes, read_answer
from gainproof.verify.judge.process_limits import limit_memory, limit_time
from gainproof.verify.judge.setting.environment import Environment
from gainproof.verify.judge.task import Models, Task
from gainproof.verify.judge.trial import Trial

START = 60.0
"""Seconds in which a child must be ready; those of a claim are counted from then on."""
_READY = b"ready"
_ENDED = "the process that judged it ended without an answer"

OnTrial = Callable[[Trial], None]


@dataclass
class _Child:
    """A process with the task it is for; `given` is when it got it, None while it is starting."""

    process: SpawnProcess
    pipe: Connection
    task: Task | None
    deadline: float
    given: float | None = None


class Workers:
    """Up to `processes` child processes, which stay for the next tasks: what a child has solved and
    the time of its start are not spent twice. To be used in a `with`, at whose end they end.
    """

    def __init__(
        self,
        models: Models,
        seconds: float,
        processes: int = 1,
        on_trial: OnTrial | None = None,
    ) -> None:
        self._models, self._seconds = models, seconds
        self._most, self._on_trial = max(1, processes), on_trial
        self._children: list[_Child] = []

    def __enter__(self) -> Workers:
        return self

    def __exit__(self, *_: object) -> None:
        for child in self._children:
            _stop(child)
        self._children = []

    def run(self, tasks: Sequence[Task]) -> dict[str, Trial]:
        """What the tasks came to, by id of the claim; one that takes longer than `seconds` or than
        its own limit, or whose child dies, has no findings but a reason. `on_trial` hears of each
        as it ends.
        """
        waiting = list(reversed(tasks))
        found: dict[str, Trial] = {}
        seconds = self._seconds

        def end(trial: Trial) -> None:
            found[trial.claim.id] = trial
            if self._on_trial is not None:
                self._on_trial(trial)

        while waiting or any(child.task for child in self._children):
            for child in self._children:
                if child.task is None and not child.process.is_alive():
                    _stop(child)  # it ended while it had nothing to do
                elif child.task is None and waiting:
                    _give(child, waiting.pop(), seconds)
            self._children = [c for c in self._children if not c.pipe.closed]
            while waiting and len(self._children) < self._most:
                self._children.append(_started(waiting.pop(), self._models, seconds))
            for child in _ready(self._children):
                _hear(child, seconds, end)
            for child in [c for c in self._children if c.task and time.monotonic() > c.deadline]:
                _lose(child, _late(child, seconds), end)
            self._children = [c for c in self._children if not c.pipe.closed]
        return found


def tried_apart(
    tasks: Sequence[Task],
    models: Models,
    seconds: float,
    processes: int = 1,
    on_trial: OnTrial | None = None,
) -> dict[str, Trial]:
    """`Workers.run` in children that end with it."""
    with Workers(models, seconds, processes, on_trial) as workers:
        return workers.run(tasks)


def _started(task: Task, models: Models, seconds: float) -> _Child:
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    arguments = (theirs, [dict(m) for m in models], seconds)
    process = context.Process(target=_serve, args=arguments, daemon=True)
    process.start()
    theirs.close()
    return _Child(process, ours, task, time.monotonic() + START)


def _give(child: _Child, task: Task, seconds: float) -> None:
    child.task = task
    child.given = time.monotonic()
    child.deadline = child.given + min(seconds, task.most)
    try:
        child.pipe.send(task)
    except OSError:
        child.deadline = child.given  # it has ended, which reading from it will tell


def _ready(children: Sequence[_Child]) -> list[_Child]:
    """The children that have something to say before the next deadline."""
    busy = [child for child in children if child.task]
    left = min((child.deadline for child in busy), default=0.0) - time.monotonic()
    heard = wait([child.pipe for child in busy], timeout=max(0.0, left))
    return [child for child in busy if child.pipe in heard]


def _hear(child: _Child, seconds: float, end: OnTrial) -> None:
    assert child.task is not None
    try:
        data = child.pipe.recv_bytes(MOST_BYTES)
        if child.given is None and data == _READY:
            _give(child, child.task, seconds)
            return
        trial = read_answer(data, child.task.claim)
    except (EOFError, OSError):
        _lose(child, _ENDED, end)
    except BadAnswer as error:
        _lose(child, str(error), end)
    else:
        child.task = None
        end(trial)


def _late(child: _Child, seconds: float) -> str:
    if child.task is None or child.given is None:
        return f"its process did not start within {START:g} seconds"
    return f"stopped after {min(seconds, child.task.most):g} seconds"


def _lose(child: _Child, reason: str, end: OnTrial) -> None:
    assert child.task is not None
    spent = 0.0 if child.given is None else time.monotonic() - child.given
    lost = Trial(child.task.claim, {}, (), False, spent, reason)
    child.task = None
    _stop(child)
    end(lost)


def _stop(child: _Child) -> None:
    child.pipe.close()
    child.process.kill()
    child.process.join()


def _serve(pipe: Connection, models: Models, seconds: float) -> None:
    """The child: a task in, a trial out, until the pipe closes."""
    limit_memory()
    solved: dict[Any, Environment] = {}
    pipe.send_bytes(_READY)
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
        pipe.send_bytes(answer)
