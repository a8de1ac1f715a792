"""Claims judged in child processes that can be killed: a claim that hangs costs one claim.

Signals do not interrupt the arithmetic library, so a time limit needs a process of its own. A child
keeps the environments it solved, each by its whole content, and takes claim after claim, of one
file or of many; after a kill a new one is started, and after a claim that took much memory too.
Its memory and its processor time are limited where the system can do that (`process_limits`), so
that a child whose parent was killed ends too. What comes back is JSON text of limited size. The
child's own side is `child`.

The limit of a claim is one of processor time, which a loaded machine does not change. A child that
has not used it up after a time several times as long, that somebody killed or that did not start
says nothing of its claim: its trial names the accident, after a second try where that may help.
Works with every start method, `spawn` included.
"""

from __future__ import annotations

import multiprocessing
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from multiprocessing.context import SpawnProcess
from queue import Empty, SimpleQueue
from types import ModuleType
from typing import Protocol

from gainproof.verify.judge.known_answers import Known, KnownTrials
from gainproof.verify.judge.process_limits import TIMED, out_of_time
from gainproof.verify.judge.task import Models, Task
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.worker_answer import MOST_BYTES, BadAnswer, read_answer
from gainproof.verify.judge.worker_process import READY, STAYS, serve

START = 60.0
"""Seconds in which a child must be ready; those of a claim are counted from then on."""
WAITS, SPARE = (10.0, 30.0) if TIMED else (1.0, 0.0)
"""So many times its limit, and seconds more, a child may take that waits for the processor."""
LOOKS = 2.0
"""Seconds after which this process looks whether it was paused itself, and its children with it."""

_HIDING = threading.Lock()

OnTrial = Callable[[Trial], None]
_End = Callable[[Task, Trial], None]


class Judges(Protocol):
    """Whoever runs tasks: `Workers`, or a process that can start no others."""

    taken: int
    judged: int

    def run(self, tasks: Sequence[Task], on_trial: OnTrial | None = None) -> Mapping[str, Trial]:
        """What the tasks came to, by id of the claim; `on_trial` hears of each as it ends."""
        ...


class _Lose(Protocol):
    def __call__(self, child: _Child, reason: str, *, retry: bool) -> None: ...


@dataclass(eq=False)
class _Child:
    """A process with the task it is for; `given` is when it got it, None while it is starting. A
    thread talks with it, since what is written to or read from a process that was paused may take
    for ever: what it is to say goes to `asked`, what it says comes with it, None as the last.
    """

    process: SpawnProcess
    pipe: Connection
    task: Task | None
    deadline: float
    given: float | None = None
    asked: SimpleQueue[Task | None] = field(default_factory=SimpleQueue)

    def talk(self, heard: SimpleQueue[tuple[_Child, bytes | None]]) -> None:
        """Until it has nothing more to say, or nobody asks."""
        try:
            heard.put((self, self.pipe.recv_bytes(len(READY))))
            while (task := self.asked.get()) is not None:
                self.pipe.send(task)
                heard.put((self, self.pipe.recv_bytes(MOST_BYTES + 1)))
        except (EOFError, OSError):
            heard.put((self, None))
        finally:
            self.pipe.close()


class Workers:
    """Up to `processes` child processes, which stay for the next tasks: what a child has solved and
    the time of its start are not spent twice. What is `known` of tasks is not asked again, and what
    they come to is kept there, each as it ends. To be used in a `with`, at whose end they end.

    `taken` and `judged` count the tasks whose answers were known, and the others.
    """

    def __init__(
        self, models: Models, seconds: float, processes: int = 1, known: Known | None = None
    ) -> None:
        self._models, self._seconds, self._most = models, seconds, max(1, processes)
        self._known = known
        self._children: list[_Child] = []
        self._heard: SimpleQueue[tuple[_Child, bytes | None]] = SimpleQueue()
        self._looked = 0.0
        self.taken = self.judged = 0

    def __enter__(self) -> Workers:
        return self

    def __exit__(self, *_: object) -> None:
        for child in list(self._children):
            self._stop(child)

    def run(self, tasks: Sequence[Task], on_trial: OnTrial | None = None) -> dict[str, Trial]:
        """What the tasks came to, by id of the claim; one that takes longer than `seconds` or than
        its own limit, or whose child dies, has no findings but a reason. `on_trial` hears of each
        as it ends.
        """
        known = None if self._known is None else KnownTrials(self._known, self._models)
        found: dict[str, Trial] = {}

        def end(task: Task, trial: Trial) -> None:
            found[trial.claim.id] = trial
            self.judged += 1
            if known is not None:
                known.keep(task, trial)
            if on_trial is not None:
                on_trial(trial)

        waiting: list[Task] = []
        for task in tasks:
            trial = None if known is None else known.of(task)
            if trial is None:
                waiting.append(task)
                continue
            found[task.claim.id] = trial
            self.taken += 1
            if on_trial is not None:
                on_trial(trial)
        try:
            self._run(waiting[::-1], end)
        except BaseException:
            self.__exit__()  # what a child would answer later is no answer to other tasks
            raise
        return found

    def _run(self, waiting: list[Task], end: _End) -> None:
        again: set[str] = set()
        self._looked = time.monotonic()

        def lose(child: _Child, reason: str, *, retry: bool) -> None:
            """The accident is that of the task, unless another try may do without it."""
            assert child.task is not None
            task, spent = child.task, 0.0
            if child.given is not None:
                spent = time.monotonic() - child.given
            self._stop(child)
            if retry and task.claim.id not in again:
                again.add(task.claim.id)
                waiting.append(task)
                return
            reason = f"{reason}, twice" if retry else reason
            end(task, Trial(task.claim, {}, (), False, spent, reason, accident=reason))

        while waiting or any(child.task for child in self._children):
            for child in [c for c in self._children if c.task is None]:
                if not child.process.is_alive():
                    self._stop(child)  # it ended while it had nothing to do
                elif waiting:
                    self._give(child, waiting.pop())
            while waiting and len(self._children) < self._most:
                self._start(waiting.pop())
            self._hear(end, lose)
            for child in [c for c in self._children if c.task and time.monotonic() > c.deadline]:
                if child.given is None:
                    lose(child, f"its process did not start within {START:g} seconds", retry=True)
                else:
                    lose(child, self._late(child), retry=False)

    def _hear(self, end: _End, lose: _Lose) -> None:
        """What a child says before the next deadline."""
        left = min(c.deadline for c in self._children if c.task) - time.monotonic()
        try:
            child, data = self._heard.get(timeout=min(max(0.0, left), LOOKS))
        except Empty:
            return
        finally:
            passed, self._looked = time.monotonic() - self._looked, time.monotonic()
            if passed > 2 * LOOKS:  # this process was paused, most likely with what it started
                for each in self._children:
                    each.deadline += passed
        task = child.task
        if child not in self._children or task is None:
            return  # of a child that was stopped, or ended without having anything to do
        if data is None:
            self._ended(child, task, end, lose)
        elif child.given is None:
            self._give(child, task)
        else:
            try:
                trial = read_answer(data[1:], task.claim)
            except BadAnswer as error:
                lose(child, str(error), retry=True)
                return
            child.task = None
            if data[:1] != STAYS:
                self._stop(child)
            end(task, trial)

    def _ended(
        self,
        child: _Child,
        task: Task,
        end: Callable[[Task, Trial], None],
        lose: Callable[..., None],
    ) -> None:
        child.process.join(LOOKS)
        code = child.process.exitcode
        if not out_of_time(code):
            lose(child, _death(code), retry=True)
            return
        self._stop(child)
        limit = self._limit(task)
        reason = f"stopped after {limit:g} processor seconds"
        end(task, Trial(task.claim, {}, (), False, limit, reason, timed=True))

    def _limit(self, task: Task) -> float:
        return min(self._seconds, task.most)

    def _patience(self, task: Task) -> float:
        return WAITS * self._limit(task) + SPARE

    def _late(self, child: _Child) -> str:
        assert child.task is not None
        limit = self._limit(child.task)
        if not TIMED:
            return f"stopped after {limit:g} seconds: this system does not limit processor time"
        return (
            f"its process was paused, or had to wait: it has not used up {limit:g} processor "
            f"seconds in {self._patience(child.task):g} seconds"
        )

    def _start(self, task: Task) -> None:
        context = multiprocessing.get_context("spawn")
        ours, theirs = context.Pipe()
        arguments = (theirs, [dict(m) for m in self._models], self._seconds)
        process = context.Process(target=serve, args=arguments, daemon=True)
        with _without_main():
            process.start()
        theirs.close()
        child = _Child(process, ours, task, time.monotonic() + START)
        self._children.append(child)
        threading.Thread(target=child.talk, args=(self._heard,), daemon=True).start()

    def _give(self, child: _Child, task: Task) -> None:
        child.task, child.given = task, time.monotonic()
        child.deadline = child.given + self._patience(task)
        child.asked.put(task)

    def _stop(self, child: _Child) -> None:
        child.process.kill()
        child.process.join()
        child.asked.put(None)
        self._children.remove(child)


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


@contextmanager
def _without_main() -> Iterator[None]:
    """The main module out of sight: a child would import it anew, and a user's script that asks the
    judge without a guard would ask again in each. What a child needs has modules of its own.
    """
    with _HIDING:
        main = sys.modules["__main__"]
        sys.modules["__main__"] = ModuleType("__main__")
        try:
            yield
        finally:
            sys.modules["__main__"] = main


def _death(code: int | None) -> str:
    """How a process ended that had not answered."""
    try:
        name = signal.Signals(-(code or 0)).name
    except ValueError:
        return "the process that judged it ended without an answer"
    return f"the process that judged it was ended by {name}"
