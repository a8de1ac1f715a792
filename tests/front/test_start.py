"""An interrupt at any moment, and a lack of memory or open files: one line, and its status."""

from __future__ import annotations

import errno
import os
import resource
import signal
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor
from itertools import pairwise
from pathlib import Path

import pytest
from one_of_each import cases

from gainproof import cli
from gainproof.bad_input import BadInputError
from gainproof.campaign import executors
from gainproof.jobs import interrupts, resource_limits, workers

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals and limits of POSIX systems")
LONGEST_WAIT = 100.0  # seconds: only for a process that hangs
INTERRUPTED = (130, "gainproof: interrupted\n")
INTERRUPTING = """
import atexit, os, signal, sys, time
from gainproof import start
signal.signal(signal.SIGINT, signal.default_int_handler)  # pytest may be a job in the background
def interrupt():
    os.kill(os.getpid(), signal.SIGINT)
class At:
    def find_spec(self, name, path, target=None):
        if name == MOMENT:
            interrupt()
class Dying:
    def __del__(self):
        interrupt()
def lost(_):
    Dying()
    time.sleep(90)
def list_lost():
    from gainproof.commands import listing
    listing.run = lost
sys.meta_path.insert(0, At())
"""


def ran(script: str, *arguments: str) -> tuple[int, str]:
    """Status and standard error of the command line in a process of its own."""
    done = subprocess.run(
        [sys.executable, "-c", script + "\nsys.exit(start.main())", *arguments],
        capture_output=True,
        text=True,
        check=False,
        timeout=LONGEST_WAIT,
    )
    return done.returncode, done.stderr


@pytest.mark.alike
@pytest.mark.parametrize(
    "module",
    [
        *(
            "threading",
            "gainproof.cli",
            "argparse",
            "gainproof.commands.track",
            "gainproof.location.answer",
        ),
        # NumPy makes another error of an interrupt in its own imports
        *("numpy", "numpy._core._multiarray_umath", "datetime"),
    ],
)
def test_an_interrupt_while_something_is_imported(module: str) -> None:
    script = f"MOMENT = {module!r}\n{INTERRUPTING}"
    assert ran(script, "locate", "a.csv", "b.csv") == INTERRUPTED


EARLY = """
import _signal, os, sys
_signal.signal(2, _signal.default_int_handler)
class At:
    def find_spec(self, name, path, target=None):
        if name == "signal":
            os.kill(os.getpid(), 2)
sys.meta_path.insert(0, At())
from gainproof import start
"""


def test_an_interrupt_in_the_first_import() -> None:
    assert ran(EARLY, "list") == INTERRUPTED


LATE = """
class Late:
    def find_spec(self, name, path, target=None):
        if name == "gainproof.cli":
            atexit.register(interrupt)
sys.meta_path.insert(0, Late())
"""


def test_an_interrupt_when_all_is_done() -> None:
    assert ran(f"MOMENT = ''\n{INTERRUPTING}\n{LATE}", "campaign") == INTERRUPTED


@pytest.mark.parametrize("turn", cases(range(3), lambda turn: turn == 0))
def test_an_interrupt_while_python_ends(turn: int) -> None:
    """What was registered before the program runs at the very last."""
    script = f"MOMENT = ''\n{INTERRUPTING}\natexit.register(interrupt)"
    assert ran(script, "campaign") == (0, "")


def test_an_interrupt_that_python_cannot_raise_comes_again() -> None:
    assert ran(f"MOMENT = ''\n{INTERRUPTING}\nlist_lost()", "list") == INTERRUPTED


def test_what_is_ignored_stays_so() -> None:
    """As in a background job of a shell."""
    script = f"{INTERRUPTING}\nsignal.signal(signal.SIGINT, signal.SIG_IGN)"
    assert ran(f"MOMENT = 'gainproof.cli'\n{script}", "campaign") == (0, "")


def test_a_process_of_a_campaign_is_not_broken_off_while_it_starts() -> None:
    with executors.opened("processes", 1) as pool:
        assert isinstance(pool, ProcessPoolExecutor)
        with interrupts.held():
            found = pool.submit(abs, -7)
        for number in pool._processes:
            for each in interrupts.numbers():
                os.kill(number, each)
        assert found.result(LONGEST_WAIT) == 7
        blocked = pool.submit(signal.pthread_sigmask, signal.SIG_BLOCK, ()).result(LONGEST_WAIT)
        assert not blocked & set(interrupts.numbers())


def test_what_is_held_comes_at_the_end() -> None:
    seen: list[str] = []
    before = signal.signal(signal.SIGINT, lambda *_: seen.append("came"))
    try:
        with interrupts.held():
            signal.raise_signal(signal.SIGINT)
            seen.append("held")
        assert seen == ["held", "came"]
    finally:
        signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize(
    ("kind", "limit", "words"),
    [
        pytest.param(
            *(resource.RLIMIT_NOFILE, 6, "too many files are open"), marks=pytest.mark.thorough
        ),
        (resource.RLIMIT_NOFILE, 16, "too many files are open"),
        (resource.RLIMIT_AS, 40 << 20, ""),
        pytest.param(resource.RLIMIT_AS, 60 << 20, "", marks=pytest.mark.thorough),
        # memory ends elsewhere in each run, in compiled code of others too
        pytest.param(resource.RLIMIT_AS, 90 << 20, "", marks=pytest.mark.thorough),
    ],
)
def test_a_lack_is_one_line(kind: int, limit: int, words: str, tmp_path: Path) -> None:
    def limited() -> None:
        resource.setrlimit(kind, (limit, limit))

    done = subprocess.run(
        [sys.executable, "-m", "gainproof", "derive", "random-velocity", "--fresh"],
        capture_output=True,
        text=True,
        check=False,
        timeout=LONGEST_WAIT,
        env={**os.environ, "GAINPROOF_CACHE": str(tmp_path)},
        preexec_fn=limited,
    )
    if done.returncode != 0:  # where there is less to load, it may be enough
        last = done.stderr.splitlines()[-1]
        assert done.returncode == 2
        assert last.startswith("gainproof: ")
        assert words in last
        assert "(a limit as of `ulimit -" in last
        assert "Traceback" not in done.stderr


def made(*errors: Exception) -> Exception:
    """The last, behind which the others stand."""
    for behind, error in pairwise(errors):
        error.__cause__ = behind
    return errors[-1]


@pytest.mark.alike
@pytest.mark.parametrize(
    ("error", "words"),
    [
        (MemoryError(), resource_limits.MEMORY),
        (OSError(24, os.strerror(24)), resource_limits.FILES),
        (BlockingIOError(11, os.strerror(11)), resource_limits.PROCESSES),
        (RuntimeError("can't start new thread"), resource_limits.PROCESSES),
        (made(MemoryError(), ImportError("numpy")), resource_limits.MEMORY),
        (made(OSError(24, os.strerror(24)), ValueError("x"), KeyError("y")), resource_limits.FILES),
        (ImportError("libx.so: failed to map segment from shared object"), resource_limits.MEMORY),
        (OSError(errno.ENFILE, ""), resource_limits.FILES),
        (OSError(errno.ENOMEM, ""), resource_limits.MEMORY),
        *((ValueError(f"{sign!r} came"), None) for sign in resource_limits.SIGNS),
        *((made(KeyError(sign), OSError(2, sign)), None) for sign in resource_limits.SIGNS),
        (ValueError("x"), None),
        (made(ValueError("x"), OSError(2, os.strerror(2))), None),
    ],
)
def test_what_an_error_comes_from(
    error: Exception,
    words: str | None,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert resource_limits.lack(error) == words

    def run(_: object) -> int:
        raise error

    monkeypatch.setattr(cli.COMMANDS["list"], "run", run)
    assert cli.main(["list"]) == (2 if words else 3)
    told = capsys.readouterr().err
    assert (told == f"gainproof: {words}\n") == bool(words)


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("MemoryError: \nTraceback", BadInputError),
        ("the process ended with status 1\nTraceback\n  line\nMemoryError", BadInputError),
        ("the process ended with status -9\n", BadInputError),
        ("KeyError: x\n  except MemoryError:\n  a\n  b\nKeyError: x", workers.JobError),
    ],
)
def test_what_a_worker_lacks_is_told_with_its_job(text: str, kind: type[Exception]) -> None:
    found = workers._failed(workers.Job("suzuki", "judge", {}), text)
    assert type(found) is kind
    assert str(found).startswith("suzuki: ")
