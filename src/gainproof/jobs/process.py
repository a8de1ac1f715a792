"""A worker process (`gainproof.jobs.worker`), seen from the side that asks."""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import signal
import sys
from collections.abc import Callable, Mapping
from typing import Any

LONGEST = 1 << 30
"""Bytes of an answer; certificates and files of kernels take a few million."""
PATIENCE = 10.0
"""Seconds that a process has to end by itself after it broke off an answer."""


class BrokenOffError(Exception):
    """The process ended, or said what is no answer; the message says what is known."""


class Process:
    """A new interpreter that answers one request after the other. Ended by `finish`, or by `end`
    with all that it has started; one of them has to be called.
    """

    def __init__(self, process: asyncio.subprocess.Process) -> None:
        assert process.stdin is not None
        assert process.stdout is not None
        assert process.stderr is not None
        self._process = process
        self._requests, self._answers = process.stdin, process.stdout
        self._errors: list[bytes] = []
        self._listening = asyncio.ensure_future(self._listen(process.stderr))

    @classmethod
    async def started(cls, module: str, settings: Mapping[str, str]) -> Process:
        """A process that runs a module, with these environment variables and no others."""
        starting = asyncio.ensure_future(
            asyncio.create_subprocess_exec(
                sys.executable,
                # -P: a file of the working folder called like a module must not take its place
                *("-P", "-m", module),
                stdin=asyncio.subprocess.PIPE,
                stdout=asyncio.subprocess.PIPE,
                stderr=asyncio.subprocess.PIPE,
                env=settings,
                limit=LONGEST,
                # a process group of its own: what the process has started ends with it
                start_new_session=os.name == "posix",
            )
        )
        try:
            return cls(await asyncio.shield(starting))
        except asyncio.CancelledError:
            # broken off while it starts it would be nobody's, and outlive the loop
            await cls(await starting).end()
            raise

    async def ask(
        self, request: Mapping[str, Any], tell: Callable[[str], object], *, last: bool = False
    ) -> dict[str, Any]:
        """The answer to a request; `tell` hears what is said before. Nothing is asked after the
        `last` one. Raises BrokenOffError.
        """
        with contextlib.suppress(BrokenPipeError, ConnectionResetError):
            self._requests.write(json.dumps(request).encode() + b"\n")
            await self._requests.drain()
        if last:
            self._requests.close()
        while True:
            answer = await self._line()
            if "progress" not in answer:
                return answer
            tell(str(answer["progress"]))

    async def _line(self) -> dict[str, Any]:
        try:
            found = json.loads(await self._answers.readline())
            if isinstance(found, dict):
                return found
        except ValueError:
            pass
        status = await self._ended()
        text = b"".join(self._errors).decode(errors="replace").strip()
        raise BrokenOffError(f"the process ended with status {status}\n{text}")

    async def _ended(self) -> int | None:
        """The status of a process from which no answer is to be expected."""
        self._requests.close()
        with contextlib.suppress(TimeoutError):
            await asyncio.wait_for(asyncio.shield(self._listening), PATIENCE)
        self._kill()
        return await self._process.wait()

    async def finish(self) -> None:
        """Let it end, now that nothing is asked any more."""
        self._requests.close()
        await self._listening
        await self._process.wait()

    async def end(self) -> None:
        """End it and, where the system has process groups, everything that it started."""
        self._kill()
        self._listening.cancel()
        await self._process.wait()

    def _kill(self) -> None:
        with contextlib.suppress(ProcessLookupError):
            if sys.platform == "win32":
                self._process.kill()
            else:
                os.killpg(self._process.pid, signal.SIGKILL)

    async def _listen(self, stream: asyncio.StreamReader) -> None:
        while chunk := await stream.read(65536):
            self._errors.append(chunk)
