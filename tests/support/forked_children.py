"""Children forked from one process that has imported what they need: an interpreter of its own
takes each that judges a quarter of a second to get that far, and with SymPy half a second.

They do what the product's do, which are new interpreters wherever Python runs. Such start in the
tests of worker processes, and wherever a test starts the command line in a process of its own.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from multiprocessing.connection import Connection
from types import SimpleNamespace
from typing import Any

import forked_worker
import pytest

from gainproof.jobs.workers import REPRODUCIBLE
from gainproof.verify.judge import worker

CAN_FORK = sys.platform != "win32"
MADE_READY = [
    *("gainproof.verify.judge.worker_process", "gainproof.verify.judge.repair.task"),
    *("forked_worker", "gainproof.jobs.tasks", "gainproof.subjects.own_file"),
]


def context() -> Any:
    """Whose processes are forked."""
    from multiprocessing import forkserver

    found = multiprocessing.get_context("forkserver")
    found.set_forkserver_preload(MADE_READY)
    with pytest.MonkeyPatch.context() as changed:
        for name, value in REPRODUCIBLE.items():
            changed.setenv(name, value)
        forkserver.ensure_running()
    return found


@contextmanager
def forked() -> Iterator[None]:
    """Children of this process that judge are forked, where the system has that; in the end they
    are gone, and the process that made them with them.
    """
    if not CAN_FORK:
        yield
        return
    from multiprocessing import forkserver

    with pytest.MonkeyPatch.context() as changed:
        changed.setattr(worker, "multiprocessing", SimpleNamespace(get_context=lambda _: context()))
        try:
            yield
        finally:
            for child in multiprocessing.active_children():
                child.kill()
            server: Any = forkserver._forkserver
            if server._forkserver_pid is not None:
                # it would wait for a child that a test has forgotten
                os.kill(server._forkserver_pid, signal.SIGTERM)
            # waits for it, so that the time of its children counts among that of the tests
            server._stop()


class ForkedWorker:
    """A worker process, as `subprocess.Popen` has it; no child in what multiprocessing tells."""

    def __init__(self, settings: Mapping[str, str], errors: Any) -> None:
        asked, answered = os.pipe(), os.pipe()
        theirs = (
            Connection(asked[0], writable=False),
            Connection(answered[1], readable=False),
            Connection(os.dup(errors.fileno()), readable=False),
        )
        self._process = context().Process(
            target=forked_worker.serve, args=(*theirs, dict(settings), os.getcwd())
        )
        self._process.start()
        multiprocessing.process._children.discard(self._process)  # type: ignore[attr-defined]
        for end in theirs:
            end.close()
        self.stdin, self.stdout = os.fdopen(asked[1], "wb"), os.fdopen(answered[0], "rb")
        self.pid = self._process.pid

    def wait(self) -> int | None:
        """Its status, when it has ended."""
        self._process.join()
        return self.poll()

    def poll(self) -> int | None:
        """Its status, if it has ended."""
        status: int | None = self._process.exitcode
        return status

    def kill(self) -> None:
        """End it."""
        self._process.kill()

    def communicate(self) -> None:
        """Nothing more is said."""
        for end in (self.stdin, self.stdout):
            end.close()
        self.wait()
