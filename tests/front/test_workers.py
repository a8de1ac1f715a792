"""Jobs in processes of their own."""

from __future__ import annotations

import asyncio
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from gainproof.bad_input import BadInputError
from gainproof.claims.template import template
from gainproof.jobs import workers
from gainproof.jobs.code_digest import modules_below
from gainproof.jobs.process import Process
from gainproof.jobs.tasks import TASKS
from gainproof.jobs.workers import Job, JobError

SUPPORT = Path(__file__).resolve().parents[1] / "support"
UNKNOWN = Job("x", "derive", {"name": "random-velocty"})
REFUSED = Job("x", "refuse", {})
DERIVES = "filter-step"
"""What takes the least time to be derived."""


@pytest.fixture(autouse=True)
def _odd_worker(monkeypatch: pytest.MonkeyPatch) -> None:
    """Processes know the tasks of `odd_worker` too."""
    monkeypatch.setattr(workers, "WORKER", "odd_worker")
    monkeypatch.setenv("PYTHONPATH", str(SUPPORT))


def test_results_come_in_the_order_of_the_jobs() -> None:
    jobs = [Job("a", "environment", {"names": [name]}) for name in ("PYTHONHASHSEED", "NO_SUCH")]
    assert workers.run(jobs) == [{"PYTHONHASHSEED": "0"}, {"NO_SUCH": None}]


def test_a_derivation_uses_the_same_arithmetic_everywhere() -> None:
    """SymPy would take what it finds, and some versions only; asked in the process itself."""
    (found,) = workers.run([Job("a", "environment", {"names": ["SYMPY_GROUND_TYPES"]})])
    assert found == {"SYMPY_GROUND_TYPES": "flint"}


def test_settings_can_be_given() -> None:
    job = Job("a", "environment", {"names": ["PYTHONHASHSEED"]})
    assert workers.run([job], environment={"PYTHONHASHSEED": "7"}) == [{"PYTHONHASHSEED": "7"}]


def test_bad_input_comes_back_as_bad_input() -> None:
    with pytest.raises(BadInputError, match="nearest: random-velocity"):
        workers.run([UNKNOWN])


def test_a_fault_names_the_job_and_the_place() -> None:
    with pytest.raises(JobError, match=r"(?s)the job: TypeError.*Traceback"):
        workers.run([Job("the job", "derive", {"wrong": 1})])


def test_a_process_that_dies_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "executable", "/bin/false")
    with pytest.raises(JobError, match="ended with status"):
        workers.run([UNKNOWN])


def test_the_first_failure_ends_the_others() -> None:
    done: list[str] = []
    with pytest.raises(BadInputError):
        workers.run(
            [Job("slow", "wait", {"seconds": 60}), REFUSED],
            on_done=lambda job, _: done.append(job.label),
            limit=2,
        )
    assert not done


def test_what_a_job_says_while_it_works_is_told() -> None:
    text = template("t")
    arguments = {"path": "t", "text": text, "models": [], "seconds": 60.0}
    job = Job("t", "judge", arguments, {"processes": 1})
    told: list[str] = []
    (found,) = workers.run([job], on_progress=lambda job, text: told.append(f"{job.label}: {text}"))
    assert len(found["claims"]) == 2
    assert told == ["t: 1 of 2 claims", "t: 2 of 2 claims"]


def test_long_lines_of_a_job_are_no_danger() -> None:
    script = "import sys; sys.stderr.write('x' * 200000); sys.stdin.read(); print('{')"
    job = Job("loud", "environment", {"names": []})

    async def call() -> object:
        return await workers.call(job, dict(os.environ))

    original = sys.executable
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(asyncio, "create_subprocess_exec", _replaced(original, script))
        with pytest.raises(JobError, match="ended with status 0"):
            asyncio.run(call())


def _replaced(python: str, script: str) -> Any:
    """`create_subprocess_exec` that runs the script in place of the worker."""
    create = asyncio.create_subprocess_exec

    async def made(*_: str, **options: Any) -> Any:
        return await create(python, "-c", script, **options)

    return made


def test_what_follows_from_a_result_is_done_as_well() -> None:
    found: list[Any] = []

    def further(job: Job, result: Any) -> list[Job]:
        found.append(result)
        return [Job("x", "wait", {"seconds": 0}) for _ in range(3)] if job.task == "note" else []

    first = [Job("a", "note", {"key": "a", "value": 5})]
    assert workers.run(first, on_result=further, limit=2) == [5]
    assert found == [5, 0, 0, 0]


def test_a_failure_among_what_follows_is_that_of_the_run() -> None:
    waited = Job("x", "wait", {"seconds": 0})
    with pytest.raises(BadInputError):
        workers.run([waited], on_result=lambda job, _: [REFUSED] if job is waited else [])


def test_what_derives_and_what_judges_have_different_processes() -> None:
    """So that SymPy is not there where certificates are checked and claims are judged."""
    derives = Job("second", "outline", {"name": DERIVES})
    then = {"first": [derives], "second": [Job("third", "process", {})]}
    found: dict[str, Any] = {}

    def further(job: Job, result: Any) -> list[Job]:
        found[job.label] = result
        return then.get(job.label, [])

    workers.run([Job("first", "process", {})], on_result=further, limit=1)
    assert found["first"] != found["third"]
    imported = Job("", "imported", {"name": "sympy"})
    assert workers.run([derives, imported], limit=1)[1] is False
    for name, task in TASKS.items():
        assert ("gainproof.subjects.deriving" in modules_below(task.module)) == task.derives, name


def test_a_process_takes_job_after_job_and_keeps_by_key() -> None:
    jobs = [Job(str(i), "process", {}) for i in range(3)]
    assert len(set(workers.run(jobs, limit=1))) == 1
    assert workers.run(jobs, limit=1) != workers.run(jobs, limit=1)
    notes = [Job(key, "note", {"key": key, "value": n}) for n, key in enumerate("aab")]
    assert workers.run(notes, limit=1) == [0, 0, 2]


def test_a_file_does_not_change_what_the_next_one_comes_to() -> None:
    """In one process, with the same children: a file that is refused, one whose claim takes all its
    time, and one with other meanings of the same symbols come before it.
    """
    hostile = Path(__file__).resolve().parents[1] / "verify" / "judge" / "hostile"
    texts = [
        "nothing at all",
        (hostile / "number-of-a-tower-of-powers.toml").read_text("utf-8"),
        template("t").replace("filter_gain.2", "filter_gain.1"),
    ]
    seconds = 0.5

    def job(text: str) -> Job:
        arguments = {"path": "t", "text": text, "models": [], "seconds": seconds}
        return Job("t", "judge", arguments, {"processes": 1})

    def verdicts(found: Any) -> list[dict[str, Any]]:
        return [{k: v for k, v in claim.items() if k != "seconds"} for claim in found["claims"]]

    good = job(template("t"))
    (alone,) = workers.run([good])

    async def all_in_one() -> list[Any]:
        process = await Process.started(workers.WORKER, dict(os.environ))
        asked = [job(text) for text in texts]
        answers = [await process.ask(one.request(), lambda _: None) for one in [*asked, good]]
        await process.finish()
        return answers

    refused, hung, _, after = asyncio.run(all_in_one())
    assert refused["error"] == "BadInputError"
    assert "stopped after 0.5 processor seconds" in hung["result"]["claims"][0]["reason"]
    assert verdicts(after["result"]) == verdicts(alone)


def test_done_is_told_of_every_job() -> None:
    told: list[str] = []
    jobs = [Job(str(i), "wait", {"seconds": 0}) for i in range(3)]
    workers.run(jobs, on_done=lambda job, _: told.append(job.label))
    assert sorted(told) == ["0", "1", "2"]


def test_works_from_a_program_without_a_main_guard() -> None:
    """Unlike multiprocessing with spawn: the script of the user is not imported again."""
    script = (
        "from gainproof.jobs import workers\n"
        "workers.WORKER = 'odd_worker'\n"
        "print(workers.run([workers.Job('a', 'wait', {'seconds': 0})]))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[0]"


@pytest.mark.skipif(not Path("/proc").is_dir(), reason="needs a list of processes")
def test_what_a_job_has_started_ends_with_it() -> None:
    def still_running() -> bool:
        return any(
            b"started-by-a-job" in path.read_bytes()
            for path in Path("/proc").glob("[0-9]*/cmdline")
            if path.exists()
        )

    async def interrupted() -> None:
        job = Job("slow", "start_another", {"seconds": 60})
        with pytest.raises(TimeoutError):
            await asyncio.wait_for(workers.call(job, dict(os.environ)), 2)

    asyncio.run(interrupted())
    assert not still_running()


def test_a_process_first_does_what_it_can_and_what_follows_comes_before_what_waits() -> None:
    done: list[str] = []

    def further(job: Job, _: Any) -> list[Job]:
        return [Job("follows", "wait", {"seconds": 0})] if job.label == "first" else []

    jobs = [
        Job("first", "wait", {"seconds": 0}),
        Job("derives", "outline", {"name": DERIVES}),
        Job("last", "wait", {"seconds": 0}),
    ]
    workers.run(jobs, on_result=further, on_done=lambda job, _: done.append(job.label), limit=1)
    assert done == ["first", "follows", "last", "derives"]
