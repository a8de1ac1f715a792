"""Child processes killed and paused at any moment, runs broken off: each verdict is right or names
the accident, and what was kept is right.
"""

from __future__ import annotations

import multiprocessing
import os
import random
import signal
import threading
import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from claim_texts import MODELS, algebra, claim_file, steady
from odd_task import odd
from one_of_each import cases
from samples import samples

import gainproof.verify.judge.worker as worker
from gainproof.verify.judge.claim.record import ClaimFile
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.known_answers import Known, KnownTrials
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.verdict import ClaimVerdict
from gainproof.verify.judge.worker import Workers, tried_apart

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals to processes")
NUMBERS = "'x' = { unit = '1', meaning = 'x' }\n'y' = { unit = '1', meaning = 'y' }\n"


class Texts(Known):
    """What was kept, in memory."""

    def __init__(self) -> None:
        self.of: dict[tuple[str, str], str] = {}

    def load(self, module: str, key: str) -> str | None:
        return self.of.get((module, key))

    def store(self, module: str, key: str, text: str) -> None:
        self.of[module, key] = text


def cheap() -> ClaimFile:
    """Twelve claims, every third of them false, so that repairs are looked for."""
    claims = [
        ("identity", rf"(x + {n}y)^2 = x^2 + {2 * n + (n % 3 == 0)} xy + {n * n} y^2")
        for n in range(1, 13)
    ]
    return claim_file(algebra(NUMBERS), claims)


def told(verdicts: tuple[ClaimVerdict, ...]) -> dict[str, dict[str, Any]]:
    """All but the times, by id."""
    return {v.id: {**v.to_json(), "seconds": 0} for v in verdicts}


@pytest.fixture(scope="module")
def right() -> dict[str, dict[str, Any]]:
    return told(judge_file(cheap(), []))


class Harm(threading.Thread):
    """Does something to a child process every now and then, until it is stopped."""

    def __init__(self, harm: Callable[[int], None], seed: int) -> None:
        super().__init__(daemon=True)
        self._harm, self._draw, self._over = harm, random.Random(seed), threading.Event()
        self.done = 0

    def run(self) -> None:
        while not self._over.wait(self._draw.uniform(0.01, 0.4)):
            children = [c.pid for c in multiprocessing.active_children() if c.pid is not None]
            if children:
                self._harm(self._draw.choice(children))
                self.done += 1

    def stop(self) -> None:
        self._over.set()
        self.join()


def killed(pid: int) -> None:
    os.kill(pid, signal.SIGKILL)


def paused_for_a_moment(pid: int) -> None:
    os.kill(pid, signal.SIGSTOP)
    time.sleep(0.2)
    os.kill(pid, signal.SIGCONT)


def paused(pid: int) -> None:
    os.kill(pid, signal.SIGSTOP)


HARMS = [
    (processes, harm) for processes in (1, 3) for harm in (killed, paused_for_a_moment, paused)
]
ONE_OF_EACH = ((3, killed), (3, paused_for_a_moment), (1, paused))


@pytest.mark.sampled
@pytest.mark.parametrize(("processes", "harm"), cases(HARMS, lambda case: case in ONE_OF_EACH))
def test_what_is_done_to_children_makes_no_verdict_wrong(
    processes: int,
    harm: Callable[[int], None],
    right: dict[str, dict[str, Any]],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for seed in range(samples(1)):
        known = Texts()
        with monkeypatch.context() as changed:
            if harm is paused:
                # as long as others may have to wait for the start of a process on a busy machine
                changed.setattr(worker, "WAITS", 0.0)
                changed.setattr(worker, "SPARE", 2.0)
                changed.setattr(worker, "START", 4.0)
            with Workers([], 600.0, processes, known) as workers:
                harming = Harm(_sometimes(harm), seed)
                harming.start()
                try:
                    found = told(judge_file(cheap(), [], workers=workers))
                finally:
                    harming.stop()
        for name, verdict in found.items():
            assert verdict == right[name] or verdict["accident"], name
        with Workers([], 600.0, 1, known) as workers:
            assert told(judge_file(cheap(), [], workers=workers)) == right
            assert workers.taken + workers.judged > len(right)


def _sometimes(harm: Callable[[int], None]) -> Callable[[int], None]:
    """At most five times, so that the test ends."""
    left = iter(range(5))

    def once(pid: int) -> None:
        if next(left, None) is not None:
            harm(pid)

    return once


def test_a_child_that_is_killed_once_costs_nothing() -> None:
    """Each of four claims loses its process the first time that it is judged."""
    with Workers([], 60.0, 1) as workers:

        def kill(_: Trial) -> None:
            # the process that is to judge the next one
            for child in multiprocessing.active_children():
                child.kill()

        found = workers.run(odd(*["good"] * 4), kill)
    assert [trial.failure for trial in found.values()] == [None] * 4


def test_accidents_and_limits_are_not_kept() -> None:
    known = Texts()
    tasks = odd("good", "die", "hang", "fill", "fail")
    for expected in ([4, 1], [3, 2]):
        with Workers([], 1.0, 1, known) as workers:
            found = workers.run([replace(task, most=0.3) for task in tasks][: sum(expected)])
            by_deed = {name.split()[1]: trial for name, trial in found.items()}
        assert by_deed["good"].accident is None
        assert "SIGKILL, twice" in str(by_deed["die"].accident)
        assert (by_deed["hang"].accident, by_deed["hang"].timed) == (None, True)
        assert by_deed["hang"].failure == "stopped after 0.3 processor seconds"
        assert "memory" in str(by_deed["fill"].accident)
        assert by_deed["fail"].accident is None
    # what fails, fails every time
    assert len(known.of) == 2
    assert (workers.taken, workers.judged) == (2, 3)


def test_a_run_that_is_broken_off_loses_no_claim_that_was_judged(
    right: dict[str, dict[str, Any]],
) -> None:
    known, wanted = Texts(), cheap()
    for ended in (4, 7):

        def break_off(done: int, _: int, most: int = ended) -> None:
            if done == most:
                raise KeyboardInterrupt

        with Workers([], 60.0, 1, known) as workers, pytest.raises(KeyboardInterrupt):
            judge_file(wanted, [], workers=workers, progress=break_off)
        assert len(known.of) == ended
    with Workers([], 60.0, 1, known) as workers:
        assert told(judge_file(wanted, [], workers=workers)) == right
        repairs = sum(verdict["verdict"] == "refuted" for verdict in right.values())
        assert workers.taken == 7
        assert workers.judged == 5 + repairs


def test_an_edit_of_one_claim_judges_that_claim_and_what_looks_at_it() -> None:
    known, wanted = Texts(), cheap()
    claims = list(wanted.claims)
    claims[0] = replace(claim_file(algebra(NUMBERS), [("identity", "x = x")]).claims[0])
    for file, number in ((wanted, None), (replace(wanted, claims=tuple(claims)), 1)):
        with Workers([], 60.0, 1, known) as workers:
            trials: list[str] = []
            workers.run = _noting(workers, trials)  # type: ignore[method-assign]
            judge_file(file, [], workers=workers)
        if number is not None:
            # and the repairs, which look at the other claims of the setting
            assert trials[:12].count("new") == number


def _noting(workers: Workers, trials: list[str]) -> Callable[..., dict[str, Trial]]:
    run = workers.run

    def noted(tasks: Any, on_trial: Any = None) -> dict[str, Trial]:
        before = workers.judged
        found = run(tasks, on_trial)
        new = workers.judged - before
        trials.extend(["new"] * new + ["old"] * (len(found) - new))
        return found

    return noted


def test_a_pause_of_this_process_is_none_of_a_claim(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whoever goes on after a pause of everything finds that much time has passed."""
    jump = [0.0]

    class Clock:
        @staticmethod
        def monotonic() -> float:
            return time.monotonic() + jump[0]

    give = Workers._give

    def given(self: Workers, *task: Any) -> None:
        give(self, *task)
        if not jump[0]:
            threading.Timer(0.3, lambda: jump.__setitem__(0, 5_000.0)).start()

    monkeypatch.setattr(worker, "LOOKS", 0.2)
    monkeypatch.setattr(worker, "time", Clock)
    monkeypatch.setattr(Workers, "_give", given)
    found = tried_apart(odd("hang", "good"), [], 0.5)
    assert found["0 hang"].failure == "stopped after 0.5 processor seconds"
    assert found["1 good"].failure is None
    assert jump[0]


@pytest.mark.parametrize(
    ("timed", "why"),
    [(True, "was paused, or had to wait"), (False, "does not limit")],
)
def test_time_that_the_processor_did_not_spend_is_no_finding(
    timed: bool, why: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nor on a system that does not tell the one from the other, as Windows."""
    monkeypatch.setattr(worker, "TIMED", timed)
    monkeypatch.setattr(worker, "WAITS", 1.0)
    monkeypatch.setattr(worker, "SPARE", 0.0)
    found = tried_apart(odd("sleep"), [], 2.0)["0 sleep"]
    assert why in str(found.accident)
    assert found.failure == found.accident


class Losing(Workers):
    """Judges here what `said` does not hold; of one task, given by its kind and claim, nothing is
    known by accident.
    """

    def __init__(self, lost: tuple[str, str] | None, said: KnownTrials) -> None:
        super().__init__(MODELS, 1.0)
        self._lost, self._said = lost, said
        self.seen: list[tuple[str, str]] = []

    def run(self, tasks: Any, on_trial: Any = None) -> dict[str, Trial]:  # noqa: ARG002
        found = {}
        for task in tasks:
            kind = (type(task).__name__, task.claim.id)
            self.seen.append(kind)
            if kind == self._lost:
                trial = Trial(task.claim, {}, (), False, 0.0, "killed", accident="killed")
            elif (known := self._said.of(task)) is not None:
                trial = known
            else:
                trial = task.run(MODELS, {})
                self._said.keep(task, trial)
            found[task.claim.id] = trial
        return found


DEFINED = "'d' = { definition = 'x - y', meaning = 'd' }\n"
UNDEFINED = "'u' = { undefined = true, meaning = 'u', unit = '1' }\n"
FILES = {
    "definitions": (
        algebra(NUMBERS + DEFINED),
        [
            ("definition", "d = x - y"),
            ("identity", "d^2 = (x + y)^2"),
            ("identity", "d x = x^2 + x y"),
            ("identity", "x + y = y + x"),
            ("identity", "x y = x + y"),
        ],
    ),
    "an undefined symbol": (
        algebra(NUMBERS + UNDEFINED),
        [
            ("identity", "u x = x^2 + x y"),
            ("identity", "u^2 = x^2 + 2 x y + y^2"),
            ("identity", "u y = x y + y^2"),
            ("identity", "x y = y x"),
            ("identity", "u + x = x + y"),
        ],
    ),
    "conventions": (
        steady(gain="search").replace("filter_gain", "gain"),
        [
            ("identity", r"\beta = 2(2 - \alpha) - 4\sqrt{1 - \alpha}"),
            ("identity", r"\Lambda^2 = \frac{\beta^2}{1 - \alpha}"),
            ("identity", r"\alpha = \beta"),
        ],
    ),
    "a stated convention": (
        steady("random-acceleration", "predictor").replace("filter_gain", "gain"),
        [
            ("identity", r"\beta = 2(2 - \alpha) - 4\sqrt{1 - \alpha}"),
            ("identity", r"\Lambda^2 = \frac{\beta^2}{1 - \alpha}"),
            ("identity", r"\alpha + \beta = \beta + \alpha"),
        ],
    ),
}


def test_a_verdict_that_rests_on_an_accident_says_so() -> None:
    """Whatever task is lost, alone: what comes out otherwise than without the loss is told."""
    said = KnownTrials(Texts(), MODELS)
    kinds = set()
    hit = spared = 0
    for name, given in FILES.items():
        file, noting = claim_file(*given), Losing(None, said)
        before = told(judge_file(file, MODELS, workers=noting))
        for lost in dict.fromkeys(noting.seen):
            kinds.add(lost[0])
            after = told(judge_file(file, MODELS, workers=Losing(lost, said)))
            for claim, verdict in after.items():
                assert verdict["accident"] or verdict == before[claim], (name, lost, claim)
                hit += bool(verdict["accident"])
                spared += not verdict["accident"]
            assert after[lost[1]]["accident"] == "killed"
    wanted = {"TrialTask", "SolveTask", "RepairTask", "DefinitionTask", "OtherConventionsTask"}
    assert kinds == wanted
    assert hit
    assert spared
