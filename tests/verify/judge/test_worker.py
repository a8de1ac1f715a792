"""Child processes: a claim that hangs, dies or cannot be told costs that claim and no other."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
import time
from dataclasses import replace
from pathlib import Path

import pytest
from odd_task import CLAIM, WITNESS, judge_and_hang, odd
from one_of_each import cases

import gainproof.verify.judge.process_limits as process_limits
from gainproof.cli import main
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.verdict import Finding
from gainproof.verify.judge.worker import Workers, tried_apart
from gainproof.verify.judge.worker_answer import BadAnswer, answer_bytes, read_answer

LIMIT = 0.5
"""Processor seconds: what talks too much needs a part of them, what hangs all."""


@pytest.mark.parametrize("processes", cases([1, 2], lambda number: number == 2))
def test_each_loss_costs_one_claim(processes: int) -> None:
    heard: list[str] = []
    tasks = odd("good", "hang", "die", "fail", "talk", "good", *["hang"] * (processes - 1), "good")
    found = tried_apart(
        tasks, [], LIMIT, processes, on_trial=lambda trial: heard.append(trial.claim.id)
    )
    assert set(found) == set(heard) == {task.claim.id for task in tasks}
    for task in tasks:
        reason = found[task.claim.id].failure
        match task.deed:
            case "good":
                assert reason is None
                assert found[task.claim.id].findings["no model"].witness == WITNESS
            case "hang":
                assert reason == f"stopped after {LIMIT:g} processor seconds"
                assert found[task.claim.id].accident is None
            case "die":
                assert reason == "the process that judged it was ended by SIGKILL, twice"
                assert found[task.claim.id].accident == reason
            case "fail":
                assert reason == "the judge stopped: KeyError: 'oh'"
            case "talk":
                assert reason is not None
                assert "bytes" in reason
    assert not multiprocessing.active_children()


def test_children_stay_for_the_next_tasks_and_are_replaced_when_they_end() -> None:
    with Workers([], 30.0) as workers:
        assert workers.run(odd("good"))["0 good"].failure is None
        (first,) = multiprocessing.active_children()
        assert workers.run(odd("good", "good"))["1 good"].failure is None
        assert multiprocessing.active_children() == [first]
        assert first.pid is not None
        os.kill(first.pid, signal.SIGTERM)
        first.join()
        assert workers.run(odd("good"))["0 good"].failure is None
    assert not multiprocessing.active_children()


@pytest.mark.skipif(
    not process_limits.LIMITED, reason="this system cannot limit the memory of a process"
)
def test_memory_is_limited() -> None:
    found = tried_apart(odd("fill", "good"), [], 30.0)
    assert "MemoryError" in str(found["0 fill"].failure)
    assert found["1 good"].failure is None


@pytest.mark.skipif(not process_limits.LIMITED, reason="this system does not count the memory")
def test_a_child_that_took_much_memory_takes_no_other_claim() -> None:
    with Workers([], 30.0) as workers:
        assert workers.run(odd("good"))["0 good"].failure is None
        (first,) = multiprocessing.active_children()
        found = workers.run(odd("swell", "good"))
        assert [trial.failure for trial in found.values()] == [None, None]
        (second,) = multiprocessing.active_children()
        assert second.pid != first.pid


def test_an_answer_to_nobody_is_no_answer_to_the_next_tasks() -> None:
    def interrupted(trial: Trial) -> None:
        raise RuntimeError(trial.claim.id)

    with Workers([], 30.0, 2) as workers:
        with pytest.raises(RuntimeError):
            workers.run(odd("good", "hang"), interrupted)
        assert not multiprocessing.active_children()
        assert set(workers.run(odd("good", "good"))) == {"0 good", "1 good"}


def test_a_task_may_have_less_time_than_a_claim() -> None:
    (hang,) = odd("hang")
    found = tried_apart([replace(hang, most=0.2)], [], 600.0)
    assert found[hang.claim.id].failure == "stopped after 0.2 processor seconds"


@pytest.mark.skipif(os.name != "posix", reason="signals to threads")
def test_no_process_is_left_behind_by_an_interrupt() -> None:
    main = threading.main_thread().ident
    # a job in the background of a shell ignores interrupts, and so does what it starts
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    interrupt = threading.Timer(1.5, signal.pthread_kill, (main, signal.SIGINT))
    interrupt.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            tried_apart(odd("sleep", "sleep"), [], 600.0, 2)
        interrupt.join()
    finally:
        signal.signal(signal.SIGINT, before)
    assert not multiprocessing.active_children()


@pytest.mark.skipif(not process_limits.TIMED, reason="this system cannot limit processor time")
def test_a_child_whose_parent_was_killed_ends() -> None:
    context = multiprocessing.get_context("spawn")
    parent = context.Process(target=judge_and_hang)
    parent.start()
    assert parent.pid is not None
    deadline = time.monotonic() + 60
    while not (children := _children(parent.pid)) and time.monotonic() < deadline:
        time.sleep(0.1)
    time.sleep(1)  # by then it hangs
    parent.kill()
    parent.join()
    assert children
    while any(map(_runs, children)) and time.monotonic() < deadline:
        time.sleep(0.2)
    assert not any(map(_runs, children))


def _children(pid: int) -> list[int]:
    """Processes that judge, started by `pid`; the resource tracker ends by itself."""
    found = []
    for entry in os.scandir("/proc"):
        if entry.name.isdigit():
            folder = Path(entry.path)
            try:
                parent = int((folder / "stat").read_text().rsplit(")", 1)[1].split()[1])
                judges = "spawn_main" in (folder / "cmdline").read_text()
            except OSError:
                continue
            if parent == pid and judges:
                found.append(int(entry.name))
    return found


def _runs(pid: int) -> bool:
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except OSError:
        return False
    return state != "Z"


def test_an_answer_is_read_as_it_was_said() -> None:
    finding = Finding("refuted", "because", witness=WITNESS, certificate={"a": {"b": [1, None]}})
    trial = Trial(CLAIM, {"m": finding}, (), True, 0.5, repair={"offers": [{"latex": "x"}]})
    assert read_answer(answer_bytes(trial), CLAIM) == trial


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"\xff",
        b"[]",
        b"{}",
        b'{"findings": {"mapping": {}}}',
        b'{"findings": {"Claim": {"id": "x"}}, "unusable": [], "is_open": true, "seconds": 0}',
        b'{"findings": {"a": 1, "b": 2}, "unusable": [], "is_open": true, "seconds": 0}',
        b'{"findings": {"Finding": {"no": 1}}, "unusable": [], "is_open": true, "seconds": 0}',
        b"[" * 100_000,
        b"cos\nsystem\n(S'true'\ntR.",
    ],
)
def test_what_is_no_answer(data: bytes) -> None:
    with pytest.raises(BadAnswer):
        read_answer(data, CLAIM)


@pytest.mark.skipif(not process_limits.LIMITED, reason="this system limits nothing")
def test_a_system_that_cannot_limit_memory_is_named(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.setattr(process_limits, "LIMITED", False)
    monkeypatch.setenv("GAINPROOF_CACHE", str(tmp_path))
    assert main(["check", "no-such-file.toml"]) == 2
    assert process_limits.UNLIMITED_NOTE in capsys.readouterr().err
