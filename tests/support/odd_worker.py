"""The process of a worker with tasks that only tests ask for: what it sees, keeps and is, to
wait, to start another.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time

from gainproof.bad_input import BadInputError
from gainproof.jobs import tasks, worker
from gainproof.jobs.tasks import Task
from gainproof.jobs.worker_state import WorkerState

NAMES = ("environment", "wait", "process", "imported", "several", "refuse", "start_another")


def environment(names: list[str]) -> dict[str, str | None]:
    """Settings as this process sees them."""
    return {name: os.environ.get(name) for name in names}


def wait(seconds: float) -> float:
    """Do nothing for a while: a job whose length is known."""
    time.sleep(seconds)
    return seconds


def process() -> int:
    """The number of this process."""
    return os.getpid()


def imported(name: str) -> bool:
    """Whether this process has imported a module."""
    return name in sys.modules


def note(state: WorkerState, key: str, value: int) -> int:
    """What is kept under a key, if nothing was before the value."""
    return state.kept(key, lambda: value)


def several() -> list[object]:
    """What `wait` would answer, and something that it would not."""
    return [0, "known"]


def refuse() -> None:
    """Have been asked for what there is not."""
    raise BadInputError("there is no such thing")


def start_another(seconds: float) -> float:
    """Wait in a process that this one starts."""
    script = f"import time; time.sleep({seconds!r})"
    subprocess.run([sys.executable, "-c", script, "started-by-a-job"], check=True)
    return seconds


if __name__ == "__main__":
    tasks.TASKS = {
        **tasks.TASKS,
        **{name: Task(__name__, name) for name in NAMES},
        "note": Task(__name__, "note", with_state=True),
    }
    worker.main()
