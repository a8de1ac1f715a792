"""Claims judged in child processes that can be killed: a claim that hangs costs one claim.

Signals do not interrupt the arithmetic library, so a time limit needs a process of its own. A child
keeps the environments it solved, each by its whole content, and takes claim after claim, of one
file or of many; after a kill a new one is started, and after a claim that took much memory too.
Its memory and its processor time are limited where the system can do that (`process_limits`), so
that a child whose parent was killed ends too. What comes back is JSON text of limited size. The
child's own side is `child`.
Works with every start method, `spawn` included.
"""

from __future__ import annotations

import multiprocessing
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess

from gainproof.verify.judge.answer import MOST_BYTES, BadAnswer, read_answer
from gainproof.verify.judge.child import READY, STAYS, serve
from gainproof.verify.judge.task import Models, Task
from gainproof.verify.judge.trial import Trial

START = 60.0
"""Seconds in which a child must be ready; those of a claim are counted from then on."""
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

    def __init__(self, models: Models, seconds: float, processes: int = 1) -> None:
        self._models, self._seconds, self._most = models, seconds, max(1, processes)
        self._children: list[_Child] = []

    def __enter__(self) -> Workers:
        return self

    def __exit__(self, *_: object) -> None:
        for child in self._children:
            _stop(child)
        self._children = []

    def run(self, tasks: Sequence[Task], on_trial: OnTrial | None = None) -> dict[str, Trial]:
        """What the tasks came to, by id of the claim; one that takes longer than `seconds` or than
        its own limit, or whose child dies, has no findings but a reason. `on_trial` hears of each
        as it ends.
        """
        try:
            return self._run(tasks, on_trial)
        except BaseException:
            self.__exit__()  # what a child would answer later is no answer to other tasks
            raise

    def _run(self, tasks: Sequence[Task], on_trial: OnTrial | None) -> dict[str, Trial]:
        waiting = list(reversed(tasks))
        found: dict[str, Trial] = {}
        seconds = self._seconds

        def end(trial: Trial) -> None:
            found[trial.claim.id] = trial
            if on_trial is not None:
                on_trial(trial)

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
    with Workers(models, seconds, processes) as workers:
        return workers.run(tasks, on_trial)


def _started(task: Task, models: Models, seconds: float) -> _Child:
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    arguments = (theirs, [dict(m) for m in models], seconds)
    process = context.Process(target=serve, args=arguments, daemon=True)
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
        data = child.pipe.recv_bytes(MOST_BYTES + 1)
        if child.given is None and data == READY:
            _give(child, child.task, seconds)
            return
        trial = read_answer(data[1:], child.task.claim)
    except (EOFError, OSError):
        _lose(child, _ENDED, end)
    except BadAnswer as error:
        _lose(child, str(error), end)
    else:
        child.task = None
        if data[:1] != STAYS:
            _stop(child)
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
