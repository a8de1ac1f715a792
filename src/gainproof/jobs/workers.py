"""Jobs in fresh Python processes, a few at a time; an interrupt ends them all.

Each process is a new interpreter, started with its environment already set (SymPy reads
SYMPY_GROUND_TYPES, Python PYTHONHASHSEED, before anything can be changed), and takes job after job.
Works alike wherever Python does, since nothing is forked.
"""

from __future__ import annotations

import asyncio
import json
import os
from collections import deque
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Generic, TypeVar

from gainproof.bad_input import BadInputError
from gainproof.jobs import interrupts
from gainproof.jobs.process import BrokenOffError, Process
from gainproof.jobs.resource_limits import lack_in
from gainproof.jobs.tasks import derives

REPRODUCIBLE = {"SYMPY_GROUND_TYPES": "flint", "PYTHONHASHSEED": "0"}
"""What makes a derivation come out the same everywhere, whatever else is installed."""
WORKER = "gainproof.jobs.worker"
"""The module that is run on the other side."""


@dataclass(frozen=True)
class Job:
    """One task of `gainproof.jobs.tasks` with its arguments, plain data; `label` is for people,
    `also` are arguments on which the result does not depend. The result of a job that `answers`
    others is the list of theirs. One that is not `kept` is done in each run: its parts are kept.
    """

    label: str
    task: str
    arguments: Mapping[str, Any]
    also: Mapping[str, Any] = field(default_factory=dict)
    answers: tuple[Job, ...] = ()
    kept: bool = True

    @cached_property
    def text(self) -> str:
        """All on which the result depends, as one text."""
        return json.dumps([self.task, self.arguments], sort_keys=True)

    def request(self) -> dict[str, Any]:
        """What the process is asked."""
        return {"task": self.task, "arguments": {**self.arguments, **self.also}}


class JobError(Exception):
    """A job failed by a fault of the program; the message ends with where."""


Done = Callable[[Job, float], None]
Progressed = Callable[[Job, str], None]
Further = Callable[[Job, Any], Sequence[Job]]


def run(
    jobs: Sequence[Job],
    *,
    on_done: Done | None = None,
    on_progress: Progressed | None = None,
    on_result: Further | None = None,
    environment: Mapping[str, str] | None = None,
    limit: int | None = None,
) -> list[Any]:
    """The jobs' results in the order of the jobs; `on_done` hears of each as it ends, `on_progress`
    of what a job says while it works. `on_result` gets each result and says which jobs are to
    follow, whose results it gets too. At most `limit` processes run at once, one for each processor
    if it is not given.

    Raises BadInputError or JobError of the first job that fails, the others being ended.
    """
    settings = {**os.environ, **REPRODUCIBLE, **(environment or {})}
    listener = _Listener(on_done, on_progress, on_result)
    return interrupts.run(_run(jobs, listener, settings, limit or processors()))


def processors() -> int:
    """How many processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


@dataclass(frozen=True)
class _Listener:
    on_done: Done | None
    on_progress: Progressed | None
    on_result: Further | None


async def _run(
    jobs: Sequence[Job], listener: _Listener, settings: Mapping[str, str], limit: int
) -> list[Any]:
    waiting = _JobQueue(jobs)
    # without jobs that follow, more processes than jobs would have nothing to do
    count = limit if listener.on_result else min(limit, len(jobs))
    lines = [
        asyncio.ensure_future(_one_after_the_other(waiting, listener, settings))
        for _ in range(count)
    ]
    try:
        await asyncio.gather(*lines)
    except BaseException:
        for line in lines:
            # an interrupt has cancelled them all, and a second time would break off the ending
            if not line.cancelling():
                line.cancel()
        await asyncio.gather(*lines, return_exceptions=True)
        raise
    return [waiting.found[number] for number in range(len(jobs))]


async def _one_after_the_other(
    waiting: _JobQueue[Job], listener: _Listener, settings: Mapping[str, str]
) -> None:
    """Jobs in one process, until none is waiting and none can follow. A job that derives and one
    that does not have different processes: those that the process can do come first.
    """
    clock = asyncio.get_running_loop().time
    process: Process | None = None
    deriving = False

    def suits(job: Job) -> bool:
        return process is None or deriving == derives(job.task)

    try:
        while (following := await waiting.following(suits)) is not None:
            number, job = following
            start = clock()
            if process is not None and not suits(job):
                await process.finish()
                process = None
            if process is None:
                deriving = derives(job.task)
                process = await Process.started(WORKER, settings)
            result = await asked(process, job, listener.on_progress)
            if listener.on_done is not None:
                listener.on_done(job, clock() - start)
            further = listener.on_result(job, result) if listener.on_result else ()
            await waiting.done(number, result, further)
        if process is not None:
            await process.finish()
    except BaseException:
        if process is not None:
            await process.end()
        raise


async def call(job: Job, settings: Mapping[str, str], on_progress: Progressed | None = None) -> Any:
    """The result of one job in a process with these settings; cancelling ends the process."""
    process = await Process.started(WORKER, settings)
    try:
        result = await asked(process, job, on_progress, last=True)
        await process.finish()
    except BaseException:
        await process.end()
        raise
    return result


async def asked(
    process: Process, job: Job, on_progress: Progressed | None = None, *, last: bool = False
) -> Any:
    """The result of a job from a process that takes more afterwards, unless it is the `last`.

    Raises BadInputError, and JobError for a fault of the program, after which it cannot be asked.
    """
    try:
        answer = await process.ask(
            job.request(), lambda text: on_progress and on_progress(job, text), last=last
        )
    except BrokenOffError as error:
        raise _failed(job, str(error)) from None
    if "result" in answer:
        return answer["result"]
    kind, message = answer.get("error"), answer.get("message")
    if kind == BadInputError.__name__:
        raise BadInputError(str(message), answer.get("errors", ()))
    raise _failed(job, f"{kind}: {message}\n{answer.get('trace')}")


def _failed(job: Job, text: str) -> Exception:
    """The error of a job that ended with these words."""
    lines = text.strip().splitlines()
    # a word of the trace between them is no reason
    lacks = lack_in("\n".join([*lines[:1], *lines[-3:]]))
    if lacks is not None:
        return BadInputError(f"{job.label}: {lacks}")
    return JobError(f"{job.label}: {text}")


_Item = TypeVar("_Item")


class _JobQueue(Generic[_Item]):
    """A queue that ends when nothing waits and nothing is being done, from which more could follow.

    Items have numbers in the order in which they came; `found` has what each of them came to.
    """

    def __init__(self, items: Iterable[_Item]) -> None:
        self.found: dict[int, Any] = {}
        self._waiting = deque(enumerate(items))
        self._came = len(self._waiting)
        self._busy = 0
        self._changed = asyncio.Condition()

    async def following(
        self, suits: Callable[[_Item], bool] = lambda _: True
    ) -> tuple[int, _Item] | None:
        """The first that suits, or the first if none does, and its number, which has to be `done`
        some time; None if all are.
        """
        async with self._changed:
            await self._changed.wait_for(lambda: self._waiting or not self._busy)
            if not self._waiting:
                return None
            self._busy += 1
            chosen = next((each for each in self._waiting if suits(each[1])), self._waiting[0])
            self._waiting.remove(chosen)
            return chosen

    async def done(self, number: int, result: Any, further: Sequence[_Item] = ()) -> None:
        """What an item came to, and what follows from it: before all that waits."""
        async with self._changed:
            self.found[number] = result
            self._busy -= 1
            self._waiting.extendleft(reversed(list(enumerate(further, self._came))))
            self._came += len(further)
            self._changed.notify_all()
