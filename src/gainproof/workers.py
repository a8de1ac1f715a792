"""Jobs in fresh Python processes, a few at a time; an interrupt ends them all.

Each process is a new interpreter, started with its environment already set (SymPy reads
SYMPY_GROUND_TYPES, Python PYTHONHASHSEED, before anything can be changed), and takes job after job.
Works alike wherever Python does, since nothing is forked.
"""

from __future__ import annotations

import asyncio
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.process import BrokenOffError, Process

REPRODUCIBLE = {"SYMPY_GROUND_TYPES": "python", "PYTHONHASHSEED": "0"}
"""What makes a derivation come out the same everywhere, whatever else is installed."""
WORKER = "gainproof.worker"
"""The module that is run on the other side."""


@dataclass(frozen=True)
class Job:
    """One call of a function of `gainproof.tasks` with plain data; `label` is for people, `also`
    are arguments on which the result does not depend.
    """

    label: str
    task: str
    arguments: Mapping[str, Any]
    also: Mapping[str, Any] = field(default_factory=dict)

    def request(self) -> dict[str, Any]:
        """What the process is asked."""
        return {"task": self.task, "arguments": {**self.arguments, **self.also}}


class JobError(Exception):
    """A job failed by a fault of the program; the message ends with where."""


Done = Callable[[Job, float], None]
Told = Callable[[Job, str], None]


def run(
    jobs: Sequence[Job],
    *,
    on_done: Done | None = None,
    on_told: Told | None = None,
    environment: Mapping[str, str] | None = None,
    limit: int | None = None,
) -> list[Any]:
    """The jobs' results in the order of the jobs; `on_done` hears of each as it ends, `on_told` of
    what a job says while it works. At most `limit` processes run at once, one for each processor
    if it is not given.

    Raises BadInputError or JobError of the first job that fails, the others being ended.
    """
    settings = {**os.environ, **REPRODUCIBLE, **(environment or {})}
    return asyncio.run(_run(jobs, on_done, on_told, settings, limit or processors()))


def processors() -> int:
    """How many processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


async def _run(
    jobs: Sequence[Job],
    on_done: Done | None,
    on_told: Told | None,
    settings: Mapping[str, str],
    limit: int,
) -> list[Any]:
    waiting = iter(enumerate(jobs))
    found: dict[int, Any] = {}

    def done(number: int, result: Any, seconds: float) -> None:
        found[number] = result
        if on_done is not None:
            on_done(jobs[number], seconds)

    lines = [
        asyncio.ensure_future(_one_after_the_other(waiting, done, on_told, settings))
        for _ in range(min(limit, len(jobs)))
    ]
    try:
        await asyncio.gather(*lines)
    except BaseException:
        for line in lines:
            line.cancel()
        await asyncio.gather(*lines, return_exceptions=True)
        raise
    return [found[number] for number in range(len(jobs))]


async def _one_after_the_other(
    waiting: Iterator[tuple[int, Job]],
    done: Callable[[int, Any, float], None],
    on_told: Told | None,
    settings: Mapping[str, str],
) -> None:
    """Jobs in one process, until none is waiting."""
    clock = asyncio.get_running_loop().time
    process: Process | None = None
    try:
        for number, job in waiting:
            start = clock()
            if process is None:
                process = await Process.started(WORKER, settings)
            result = await _asked(process, job, on_told)
            done(number, result, clock() - start)
        if process is not None:
            await process.finish()
    except BaseException:
        if process is not None:
            await process.end()
        raise


async def call(job: Job, settings: Mapping[str, str], on_told: Told | None = None) -> Any:
    """The result of one job in a process with these settings; cancelling ends the process."""
    process = await Process.started(WORKER, settings)
    try:
        result = await _asked(process, job, on_told, last=True)
        await process.finish()
    except BaseException:
        await process.end()
        raise
    return result


async def _asked(process: Process, job: Job, on_told: Told | None, *, last: bool = False) -> Any:
    try:
        answer = await process.ask(
            job.request(), lambda text: on_told and on_told(job, text), last=last
        )
    except BrokenOffError as error:
        raise JobError(f"{job.label}: {error}") from None
    if "result" in answer:
        return answer["result"]
    kind, message = answer.get("error"), answer.get("message")
    if kind == BadInputError.__name__:
        raise BadInputError(str(message))
    raise JobError(f"{job.label}: {kind}: {message}\n{answer.get('trace')}")
