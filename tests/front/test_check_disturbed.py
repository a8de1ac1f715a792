"""`check` whose processes are killed and paused, or which is broken off: each verdict is right or
is told as an accident, and the next run is right and judges only the rest.
"""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from one_of_each import further
from samples import samples

from gainproof import cli
from gainproof.claims import judgements
from gainproof.jobs.cache import Cache, default_folder
from gainproof.jobs.progress import Progress
from gainproof.jobs.session import Session

pytestmark = pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="finds processes in /proc"
)
Capture = pytest.CaptureFixture[str]
HEAD = """
format = "gainproof claims 1"
[source]
key = "many"
title = "Many claims"
authors = ["A. Reader"]
publication = "unpublished"
[symbols]
'x' = { unit = "1", meaning = "x" }
'y' = { unit = "1", meaning = "y" }
[settings.s]
title = "numbers"
kind = "algebra"
"""
COUNT = 20


@pytest.fixture
def many(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Twenty cheap claims, each fifth of them false, and a cache without any claim."""
    monkeypatch.setenv("GAINPROOF_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(judgements, "shipped_models", list)
    path = tmp_path / "many.toml"
    text = HEAD
    for n in range(1, COUNT + 1):
        text += f"[[claims]]\nid = '{n}'\nplace = 'p'\nkind = 'identity'\nsetting = 's'\n"
        text += f"latex = '(x + {n}y)^2 = x^2 + {2 * n + (n % 5 == 0)} xy + {n * n} y^2'\n"
    path.write_text(text)
    return path


CHECK = """
import sys
from gainproof import cli
from gainproof.claims import judgements

judgements.shipped_models = lambda: []  # the claims are about numbers
sys.exit(cli.main(["check", *sys.argv[1:]]))
"""


def start(path: Path) -> subprocess.Popen[bytes]:
    """`gainproof check` with processes of its own."""
    command = [sys.executable, "-c", CHECK, str(path), "--json"]
    # nobody reads while children are looked for
    with path.with_suffix(".out").open("wb") as out, path.with_suffix(".err").open("wb") as err:
        return subprocess.Popen(command, stdout=out, stderr=err, start_new_session=True)


def judging(group: int) -> list[int]:
    """The children of `start` that judge."""
    found = []
    for entry in os.scandir("/proc"):
        if entry.name.isdigit():
            try:
                words = Path(entry.path, "cmdline").read_text()
                mine = os.getsid(int(entry.name)) == group or "spawn_main" in words
                state = Path(entry.path, "stat").read_text().rsplit(")", 1)[1].split()
            except (OSError, ProcessLookupError):
                continue
            if mine and "spawn_main" in words and _is_below(int(state[1]), group):
                found.append(int(entry.name))
    return found


def _is_below(pid: int, group: int) -> bool:
    while pid > 1:
        if pid == group:
            return True
        try:
            pid = int(Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[1])
        except OSError:
            return False
    return False


def kept() -> int:
    return len(list(default_folder().glob("trial-*.json")))


def told(data: Any) -> dict[str, Any]:
    return {claim["id"]: {**claim, "seconds": 0} for claim in data["claims"]}


def paused_for_a_moment(pid: int) -> None:
    os.kill(pid, signal.SIGSTOP)
    time.sleep(0.3)
    os.kill(pid, signal.SIGCONT)


@pytest.mark.sampled
@pytest.mark.parametrize(
    "harm",
    [
        lambda pid: os.kill(pid, signal.SIGKILL),
        further(paused_for_a_moment),  # by default those of the judge are: `test_accidents.py`
    ],
)
def test_children_are_killed_and_paused(
    harm: Callable[[int], None], many: Path, capsys: Capture
) -> None:
    draw = random.Random(1)
    for _ in range(samples(1)):
        for path in default_folder().glob("trial-*.json"):
            path.unlink()
        process, harmed = start(many), 0
        while process.poll() is None and harmed < samples(2):
            children = judging(process.pid)
            time.sleep(draw.uniform(0, 0.3))
            for pid in children[:1]:
                try:
                    harm(pid)
                    harmed += 1
                except ProcessLookupError:
                    pass
        process.wait()
        err = many.with_suffix(".err").read_text()
        first = told(json.loads(many.with_suffix(".out").read_text()))
        accidents = [name for name, claim in first.items() if claim["accident"]]
        assert process.returncode == (1 if accidents else 0)
        assert bool(accidents) == ("many: not judged, by accident: " in err)
        assert cli.main(["check", str(many), "--json"]) == 0
        second = told(json.loads(capsys.readouterr().out))
        assert not any(claim["accident"] for claim in second.values())
        assert {n: c for n, c in first.items() if n not in accidents} == {
            n: c for n, c in second.items() if n not in accidents
        }
        wrong = [name for name, claim in second.items() if claim["verdict"] != "proved"]
        assert wrong == [str(n) for n in range(5, COUNT + 1, 5)]
        assert all(second[name]["repairs"] for name in wrong)


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGINT])
def test_a_run_that_is_broken_off_goes_on_where_it_was(
    number: signal.Signals, many: Path, capsys: Capture
) -> None:
    process = start(many)
    while kept() < COUNT // 3 and process.poll() is None:
        time.sleep(0.01)
    os.killpg(process.pid, number)
    if number == signal.SIGKILL:
        for pid in judging(process.pid):
            os.kill(pid, number)
    process.wait()
    time.sleep(0.5)
    known = kept()
    assert known >= COUNT // 3
    (judged,) = judgements.judge([many], Session(Cache(default_folder()), Progress()))
    rest = COUNT + COUNT // 5 - known
    assert f"repairs: {known} known, {rest} done now" in capsys.readouterr().err
    assert [claim["verdict"] for claim in judged["claims"]].count("proved") == COUNT - COUNT // 5
    judgements.judge([many], Session(Cache(default_folder()), Progress()))
    assert f"repairs: {COUNT + COUNT // 5} known, 0 done now" in capsys.readouterr().err
