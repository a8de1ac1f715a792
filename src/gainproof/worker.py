"""The process on the other side of `gainproof.workers`: one call, plain data in and out.

Reads {"task": name, "arguments": {...}} from standard input and answers {"result": ...} or
{"error", "message", "trace"} on standard output. What a task prints goes to standard error.
"""

from __future__ import annotations

import json
import os
import sys
import traceback
from typing import Any


def main() -> int:
    request = json.load(sys.stdin)
    # the answer has standard output to itself
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "w", encoding="utf-8")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    json.dump(_answer(request), answers)
    answers.close()
    return 0


def _answer(request: dict[str, Any]) -> dict[str, Any]:
    from gainproof import tasks

    try:
        return {"result": tasks.TASKS[request["task"]](**request["arguments"])}
    except Exception as error:  # noqa: BLE001 (reported to the other side, whatever it is)
        return {
            "error": type(error).__name__,
            "message": str(error),
            "trace": traceback.format_exc(),
        }


if __name__ == "__main__":
    sys.exit(main())
