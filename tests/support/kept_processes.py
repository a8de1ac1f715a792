"""Worker processes that stay for the next test, and are forked: an interpreter with SymPy takes
0.6 s to start.

They are those of the product, asked in the same way; in it too one takes job after job, and what it
keeps of a job is kept by its whole content. One that executed a file is not kept. What only the
test of a process needs (how it starts, breaks off, is ended) is tested with the product's own
`Process`, which is what everybody gets whose worker or hash seed is an unusual one.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from forked_children import CAN_FORK, ForkedWorker

from gainproof.jobs import workers
from gainproof.jobs.cache import FOLDER_VARIABLE
from gainproof.jobs.process import BrokenOffError, Process
from gainproof.jobs.tasks import TASKS, derives

OWN_WORKER, OWN_SEED = workers.WORKER, workers.REPRODUCIBLE["PYTHONHASHSEED"]
NOT_READ = ("PYTEST_CURRENT_TEST", FOLDER_VARIABLE)
"""Variables that differ from test to test and that no worker process looks at. None looks at its
working folder either but for those that execute a file, which are not kept.
"""
MOST_JOBS = 25
"""Of one process, so that what it keeps does not grow for the whole session."""


@dataclass(eq=False)
class _Interpreter:
    """A process that waits for requests."""

    process: subprocess.Popen[bytes] | ForkedWorker
    errors: Any
    key: tuple[object, ...]
    jobs: int = 0

    @classmethod
    def made(cls, key: tuple[object, ...], settings: Mapping[str, str]) -> _Interpreter:
        errors = tempfile.TemporaryFile()  # noqa: SIM115 (it goes with the process)
        if CAN_FORK:
            return cls(ForkedWorker(settings, errors), errors, key)
        process = subprocess.Popen(
            [sys.executable, "-P", "-m", OWN_WORKER],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=errors,
            env=settings,
            start_new_session=os.name == "posix",
        )
        return cls(process, errors, key)

    def exchange(self, line: bytes) -> bytes:
        """The next line of the answer, after having said something."""
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        with contextlib.suppress(BrokenPipeError):
            self.process.stdin.write(line)
            self.process.stdin.flush()
        return self.process.stdout.readline()

    def end(self) -> None:
        """With all that it has started; once more does nothing."""
        if self.errors.closed:
            return
        with contextlib.suppress(ProcessLookupError):
            if sys.platform == "win32":
                self.process.kill()
            else:
                os.killpg(self.process.pid, signal.SIGKILL)
        self.process.kill()  # one that had no group yet
        self.process.communicate()
        self.errors.close()


@dataclass
class Keeper:
    """Idle processes, by what they were started with and by what they do."""

    idle: dict[tuple[object, ...], list[_Interpreter]] = field(default_factory=dict)
    started: int = 0
    asked: int = 0

    def process(self) -> type[Any]:
        """What stands in for `gainproof.jobs.process.Process`."""
        keeper = self

        class Kept(_Kept):
            of = keeper

        return Kept

    def taken(self, settings: Mapping[str, str], *, derives: bool) -> _Interpreter:
        """One that has been used, or else a new one."""
        seen = tuple(sorted((n, v) for n, v in settings.items() if n not in NOT_READ))
        key = (seen, sys.executable, derives)
        while self.idle.get(key):
            one = self.idle[key].pop()
            if one.process.poll() is None:
                return one
            one.end()
        self.started += 1
        return _Interpreter.made(key, settings)

    def put_back(self, one: _Interpreter) -> None:
        """It is idle again; others that were kept beside it are ended."""
        if one.jobs >= MOST_JOBS or one.process.poll() is not None:
            one.end()
            return
        for key in [key for key in self.idle if key[-1] == one.key[-1] and key != one.key]:
            for other in self.idle.pop(key):
                other.end()
        self.idle.setdefault(one.key, []).append(one)

    def close(self) -> None:
        """End all that are idle."""
        for kept in self.idle.values():
            for one in kept:
                one.end()
        self.idle.clear()


class _Kept:
    """Like the product's `Process`; the interpreter is chosen when the first job is known."""

    of: Keeper

    def __init__(self, settings: Mapping[str, str]) -> None:
        self._settings = settings
        self._one: _Interpreter | None = None
        self._executing: _Interpreter | None = None

    @classmethod
    async def started(cls, module: str, settings: Mapping[str, str]) -> Any:
        if module != OWN_WORKER or settings.get("PYTHONHASHSEED") != OWN_SEED:
            return await Process.started(module, settings)
        return cls(settings)

    async def ask(
        self,
        request: Mapping[str, Any],
        tell: Callable[[str], object],
        *,
        last: bool = False,  # noqa: ARG002 (of the product's)
    ) -> dict[str, Any]:
        task = str(request["task"])
        if task in TASKS and TASKS[task].executes:  # after which a process is not what it was
            if self._executing is None:
                self._executing = _Interpreter.made((), self._settings)
            one = self._executing
        else:
            if self._one is None:
                self._one = self.of.taken(self._settings, derives=derives(task))
            one = self._one
            self.of.asked += 1
        one.jobs += 1
        loop, said = asyncio.get_running_loop(), json.dumps(request).encode() + b"\n"
        while True:
            line = await loop.run_in_executor(None, one.exchange, said)
            said = b""
            try:
                answer = json.loads(line)
            except ValueError:
                raise BrokenOffError(_how_it_ended(one)) from None
            if "progress" not in answer:
                return dict(answer)
            tell(str(answer["progress"]))

    async def finish(self) -> None:
        if self._executing is not None:
            self._executing.end()
        if self._one is not None:
            self.of.put_back(self._one)
        self._executing = self._one = None

    async def end(self) -> None:
        for one in (self._executing, self._one):
            if one is not None:
                one.end()
        self._executing = self._one = None


def _how_it_ended(one: _Interpreter) -> str:
    status = one.process.wait()
    one.errors.seek(0)
    text = one.errors.read().decode(errors="replace").strip()
    one.end()
    return f"the process ended with status {status}\n{text}"
