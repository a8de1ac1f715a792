"""The worker process that `forked_children` forks, from inside."""

from __future__ import annotations

import os
import sys
from multiprocessing.connection import Connection

from gainproof.jobs import worker


def serve(
    requests: Connection, answers: Connection, errors: Connection, settings: dict[str, str], at: str
) -> None:
    """Be `python -m gainproof.jobs.worker` with these streams and variables, in this folder."""
    os.setsid()
    os.chdir(at)
    os.environ.clear()
    os.environ.update(settings)
    for number, end in enumerate((requests, answers, errors)):
        os.dup2(end.fileno(), number)
        end.close()
    sys.stdin = open(0, encoding="utf-8", closefd=False)  # noqa: SIM115 (until it ends)
    worker.main()
