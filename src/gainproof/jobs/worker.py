"""The process at the other end of `gainproof.jobs.workers`: call after call of plain data.

Reads lines {"task": name, "arguments": {...}} from standard input until it ends. Answers each by a
line {"result": ...} or {"error", "message", "errors", "trace"} on standard output, before which
there may be lines {"progress": text} about the work. What a task prints goes to standard error.
"""

from __future__ import annotations

import gc
import json
import os
import sys
import traceback
from typing import Any, NoReturn

from gainproof.jobs.worker_state import WorkerState

COLLECTED = 20_000
"""New objects after which cycles are looked for. What is derived is kept, and there is much of it:
after every 700, as is usual, looking took a twelfth of the time. Beyond this it costs memory."""


def main() -> NoReturn:
    gc.set_threshold(COLLECTED)
    # the answers have standard output to themselves
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "w", encoding="utf-8")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())

    def say(what: dict[str, Any]) -> None:
        # dumps and not dump: the C encoder is many times faster, and a line is whole or not there
        answers.write(json.dumps(what) + "\n")
        answers.flush()

    with WorkerState(lambda text: say({"progress": text})) as state:
        for line in sys.stdin:
            say(_answer(json.loads(line), state))
    answers.close()
    sys.stdout.flush()
    sys.stderr.flush()
    # to take down all that was kept, object by object, takes up to a third of a second
    os._exit(0)


def _answer(request: dict[str, Any], state: WorkerState) -> dict[str, Any]:
    from gainproof.jobs import tasks

    try:
        return {"result": tasks.TASKS[request["task"]].call(state, request["arguments"])}
    except Exception as error:  # noqa: BLE001 (reported to the other side, whatever it is)
        return {
            "error": type(error).__name__,
            "message": str(error),
            "errors": getattr(error, "errors", ()),
            "trace": traceback.format_exc(),
        }


if __name__ == "__main__":
    main()
