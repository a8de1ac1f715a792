"""Jobs in fresh Python processes, a few at a time; an interrupt ends them all.

Each job is a new interpreter, started with its environment already set (SymPy reads
SYMPY_GROUND_TYPES, Python PYTHONHASHSEED, before anything can be changed). Works alike wherever
Python does, since nothing is forked.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import signal
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from gainproof.bad_input import BadInputError

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


class JobError(Exception):
    """A job failed by a fault of the program; the message ends with where."""


Done = Callable[[Job, float], None]
Told = Callable[[Job, str], None]

PROGRESS = "progress: "
"""How a line on a job's standard error begins that is for people, while it works."""


def run(
    jobs: Sequence[Job],
    *,
    on_done: Done | None = None,
    on_told: Told | None = None,
    environment: Mapping[str, str] | None = None,
    limit: int | None = None,
) -> list[Any]:
    """The jobs' results in the order of the jobs; `on_done` hears of each as it ends, `on_told` of
    what a job says while it works.

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
    room = asyncio.Semaphore(limit)

    async def one(job: Job) -> Any:
        async with room:
            start = asyncio.get_running_loop().time()
            result = await call(job, settings, on_told)
            if on_done is not None:
                on_done(job, asyncio.get_running_loop().time() - start)
            return result

    started = [asyncio.ensure_future(one(job)) for job in jobs]
    try:
        return list(await asyncio.gather(*started))
    except BaseException:
        for task in started:
            task.cancel()
        await asyncio.gather(*started, return_exceptions=True)
        raise


async def call(job: Job, settings: Mapping[str, str], on_told: Told | None = None) -> Any:
    """The result of one job in a process with these settings; cancelling ends the process."""
    process = await asyncio.create_subprocess_exec(
        sys.executable,
        # -P: a file of the working folder called like a module must not take its place
        *("-P", "-m", WORKER),
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
        env=settings,
        # a session of its own: what the job has started ends with it
        start_new_session=os.name == "posix",
    )
    arguments = {**job.arguments, **job.also}
    request = json.dumps({"task": job.task, "arguments": arguments}).encode()
    try:
        output, errors = await _talk(process, request, lambda text: on_told and on_told(job, text))
    except BaseException:
        _end(process)
        await process.wait()
        raise
    return _result(job, process.returncode, output, errors)


async def _talk(
    process: asyncio.subprocess.Process, request: bytes, tell: Callable[[str], object]
) -> tuple[bytes, bytes]:
    """Both outputs of a process that is given the request; its progress is told, line by line."""
    assert process.stdin is not None
    assert process.stdout is not None
    assert process.stderr is not None
    kept: list[bytes] = []

    async def listen(stream: asyncio.StreamReader) -> None:
        line = b""
        while chunk := await stream.read(65536):
            *lines, line = (line + chunk).split(b"\n")
            for one in lines:
                text = one.decode(errors="replace")
                if text.startswith(PROGRESS):
                    tell(text.removeprefix(PROGRESS))
                else:
                    kept.append(one + b"\n")
        kept.append(line)

    async def ask(stream: asyncio.StreamWriter) -> None:
        with contextlib.suppress(BrokenPipeError, ConnectionResetError):
            stream.write(request)
            await stream.drain()
            stream.close()

    output, _, _ = await asyncio.gather(
        process.stdout.read(), listen(process.stderr), ask(process.stdin)
    )
    await process.wait()
    return output, b"".join(kept)


def _end(process: asyncio.subprocess.Process) -> None:
    """End a job and, where the system has process groups, everything that it started."""
    with contextlib.suppress(ProcessLookupError):
        if sys.platform == "win32":
            process.kill()
        else:
            os.killpg(process.pid, signal.SIGKILL)


def _result(job: Job, status: int | None, output: bytes, errors: bytes) -> Any:
    try:
        answer = json.loads(output)
        if "result" in answer:
            return answer["result"]
        kind, message, trace = answer["error"], answer["message"], answer["trace"]
    except (ValueError, KeyError, TypeError):
        text = errors.decode(errors="replace").strip()
        raise JobError(f"{job.label}: the process ended with status {status}\n{text}") from None
    if kind == BadInputError.__name__:
        raise BadInputError(message)
    raise JobError(f"{job.label}: {kind}: {message}\n{trace}")
