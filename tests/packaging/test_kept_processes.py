"""Worker processes kept from test to test answer what new ones do; the unusual are not kept."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from kept_processes import Keeper

from gainproof.jobs import workers
from gainproof.jobs.process import Process
from gainproof.jobs.workers import Job, JobError

NOTHING: dict[str, Any] = {name: {} for name in ("domain", "programs", "towers", "kernels")}
EXPECTED = NOTHING | {"subject": "x", "claims": [], "model": None}
CHECK = Job("check", "recheck", {"certificate": {"format": "other"}, "expected": EXPECTED})
FAILS = Job("fails", "recheck", {"certificate": {}, "expected": {}})


@pytest.fixture
def keeper(monkeypatch: pytest.MonkeyPatch) -> Iterator[Keeper]:
    made = Keeper()
    monkeypatch.setattr(workers, "Process", made.process())
    yield made
    made.close()


def test_what_one_run_after_the_other_asks_is_done_by_one_process(
    keeper: Keeper, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    first = workers.run([CHECK])
    assert not first[0]["accepted"]
    monkeypatch.setenv("GAINPROOF_CACHE", "another")
    assert workers.run([CHECK]) == first
    assert (keeper.started, keeper.asked) == (1, 2)
    monkeypatch.chdir(tmp_path)
    assert workers.run([CHECK]) == first
    assert (keeper.started, keeper.asked) == (1, 3)
    monkeypatch.setenv("A_VARIABLE_MORE", "1")
    assert workers.run([CHECK]) == first
    assert (keeper.started, keeper.asked) == (2, 4)
    monkeypatch.setattr(workers, "Process", Process)
    assert workers.run([CHECK]) == first


def test_a_failing_job_ends_its_process_and_is_told_alike(
    keeper: Keeper, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(JobError) as kept:
        workers.run([FAILS])
    with pytest.raises(JobError):
        workers.run([FAILS])
    assert keeper.started == 2
    monkeypatch.setattr(workers, "Process", Process)
    with pytest.raises(JobError) as new:
        workers.run([FAILS])
    assert str(kept.value) == str(new.value)


def test_one_that_ended_while_idle_is_not_asked(keeper: Keeper) -> None:
    first = workers.run([CHECK])
    ((idle,),) = keeper.idle.values()
    idle.process.kill()
    while idle.process.poll() is None:
        time.sleep(0.01)
    assert workers.run([CHECK]) == first
    assert keeper.started == 2


def test_who_executes_a_file_and_who_has_another_hash_seed_is_not_kept(
    keeper: Keeper, tmp_path: Path
) -> None:
    path = tmp_path / "model.py"
    path.write_text("import os, sys\nsys.stderr.write('last words')\nos._exit(3)\n")
    with pytest.raises(JobError, match=r"(?s)ended with status 3.*last words"):
        workers.run([Job("file", "derive_file", {"path": str(path)})])
    workers.run([CHECK], environment={"PYTHONHASHSEED": "3"})
    assert (keeper.started, keeper.idle) == (0, {})
