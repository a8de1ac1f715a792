"""An interrupt lets every process be ended to the last, however long each takes."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from typing import Any

import pytest

from gainproof.jobs import workers
from gainproof.jobs.workers import Job, JobError

JOBS = [Job(name, "wait", {"seconds": 60}) for name in ("first", "second", "third")]


class SlowToEnd:
    """Stands for a process: works until it is ended, each taking longer to end than the last."""

    number = 0
    ended: list[int]

    @classmethod
    async def started(cls, *_: object) -> SlowToEnd:
        return cls()

    def __init__(self) -> None:
        SlowToEnd.number += 1
        self.mine = SlowToEnd.number

    async def ask(self, request: Mapping[str, Any], *_: object, **__: object) -> dict[str, Any]:
        await asyncio.sleep(0.01)
        if self.mine == 1 and request["arguments"].get("fails"):
            return {"error": "KeyError", "message": "oh", "trace": ""}
        await asyncio.sleep(60)
        return {"result": None}

    async def end(self) -> None:
        for _ in range(self.mine):
            await asyncio.sleep(0.02)
        SlowToEnd.ended.append(self.mine)


@pytest.fixture(autouse=True)
def _slow_to_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(SlowToEnd, "number", 0)
    monkeypatch.setattr(SlowToEnd, "ended", [], raising=False)
    monkeypatch.setattr(workers, "Process", SlowToEnd)


async def run_and_interrupt() -> None:
    running = asyncio.ensure_future(
        workers._run(JOBS, workers._Listener(None, None, None), {}, len(JOBS))
    )
    await asyncio.sleep(0.05)
    running.cancel()
    with pytest.raises(asyncio.CancelledError):
        await running


def test_each_process_is_ended_before_the_loop_is() -> None:
    asyncio.run(run_and_interrupt())
    assert SlowToEnd.ended == [1, 2, 3]


def test_a_failure_ends_the_others_too() -> None:
    failing = Job("failing", "wait", {"fails": True})
    with pytest.raises(JobError, match="failing: KeyError: oh"):
        workers.run([failing, *JOBS[:2]], limit=3)
    assert SlowToEnd.ended == [1, 2, 3]
