"""The command line: quick help, nearest names for unknown ones, statuses as documented."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

from gainproof import cli
from gainproof.bad_input import BadInputError
from gainproof.commands import listing
from gainproof.jobs import workers
from gainproof.version import VERSION

COMMANDS = (
    "run",
    "derive",
    "generate",
    "check",
    "explain",
    "cite",
    "figure",
    "list",
    "bench",
    "campaign",
    "certify",
)
LONGEST_WAIT = 600.0  # seconds: only for a process that hangs
Capture = pytest.CaptureFixture[str]


def python(*arguments: str, **settings: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *arguments],
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, **settings},
    )


@pytest.mark.alike
@pytest.mark.parametrize("command", [[], *([name] for name in COMMANDS)])
def test_help_imports_nothing_heavy(command: list[str]) -> None:
    script = (
        "import sys\n"
        "from gainproof.cli import main\n"
        "try:\n"
        f"    main({[*command, '--help']!r})\n"
        "except SystemExit as end:\n"
        "    assert end.code == 0\n"
        "heavy = {'sympy', 'numpy', 'mpmath', 'flint', 'lark', 'asyncio', 'scipy', 'matplotlib'}\n"
        "print(sorted(heavy & set(sys.modules)), file=sys.stderr)\n"
    )
    done = python("-c", script)
    assert done.stderr.strip() == "[]"
    assert done.stdout.startswith("usage: gainproof")


def test_importing_gainproof_imports_nothing_heavy() -> None:
    done = python("-X", "importtime", "-c", "import gainproof")
    imported = {line.rsplit("|")[-1].strip() for line in done.stderr.splitlines()}
    assert "gainproof.version" in imported
    assert not imported & {"sympy", "numpy", "gainproof.cli", "gainproof.derive"}


def test_every_command_is_in_the_help(capsys: Capture) -> None:
    with pytest.raises(SystemExit) as end:
        cli.main(["--help"])
    assert end.value.code == 0
    text = capsys.readouterr().out
    assert all(f"\n    {name} " in text for name in COMMANDS)


@pytest.mark.parametrize("command", COMMANDS)
def test_help_fits_a_terminal(
    command: str, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    with pytest.raises(SystemExit):
        cli.main([command, "--help"])
    assert max(map(len, capsys.readouterr().out.splitlines())) <= 80


def test_version(capsys: Capture) -> None:
    with pytest.raises(SystemExit):
        cli.main(["--version"])
    assert capsys.readouterr().out == f"gainproof {VERSION}\n"


def test_python_m_gainproof_is_the_command_line() -> None:
    assert python("-m", "gainproof", "--version").stdout == f"gainproof {VERSION}\n"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["chekc"], "nearest: check"),
        (["derive", "random-velocty"], "nearest: random-velocity"),
        (["derive", "no-such-file.py"], "cannot be read"),
        (["generate", "random_acceleration"], "nearest: random-acceleration"),
        (["generate", "model.py"], "--out DIR"),
        (["cite", "gians"], "nearest: gains"),
        (["check", "kosuge-slide"], "nearest: kosuge-slides"),
        (["check", "no-such-file.toml"], "cannot be read"),
        (["explain", "no-such-file.toml", "x"], "cannot be read"),
    ],
)
def test_bad_input_is_answered_with_status_2(
    arguments: list[str], message: str, capsys: Capture
) -> None:
    assert cli.main(arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("gainproof: ")
    assert message in captured.err
    assert "Traceback" not in captured.err


def test_no_command_shows_what_there_is(capsys: Capture) -> None:
    assert cli.main([]) == 2
    shown = capsys.readouterr().out
    assert all(re.search(rf"^ +{name} ", shown, re.MULTILINE) for name in cli.COMMANDS)


@pytest.mark.parametrize("arguments", [["derive"], ["check", "--no-such-option"]])
def test_wrong_usage_has_status_2(arguments: list[str], capsys: Capture) -> None:
    with pytest.raises(SystemExit) as end:
        cli.main(arguments)
    assert end.value.code == 2
    assert "usage:" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("error", "status", "message"),
    [
        (BadInputError("wanted x, got y"), 2, "gainproof: wanted x, got y"),
        (KeyboardInterrupt(), 130, "interrupted"),
        (workers.JobError("derive x: ValueError"), 3, "a fault of the program"),
        (ValueError("a bug"), 3, "Traceback"),
    ],
)
def test_each_way_to_end_has_its_status(
    error: BaseException,
    status: int,
    message: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: Capture,
) -> None:
    def run(_: object) -> int:
        raise error

    monkeypatch.setattr(listing, "run", run)
    assert cli.main(["list"]) == status
    assert message in capsys.readouterr().err


def test_commands_without_a_tty_write_no_colour_codes(capsys: Capture) -> None:
    assert cli.main(["list"]) == 0
    assert "\x1b" not in capsys.readouterr().out


def test_a_terminal_without_the_signs_is_no_error() -> None:
    done = python("-m", "gainproof", "derive", "Λ-filter", PYTHONIOENCODING="ascii")
    assert done.returncode == 2
    assert "'?-filter'" in done.stderr


def test_a_module_in_the_working_folder_does_no_harm(tmp_path: Path) -> None:
    (tmp_path / "json.py").write_text("raise RuntimeError('the wrong file')\n")
    (tmp_path / "sympy.py").write_text("raise RuntimeError('the wrong file')\n")
    program = Path(sys.executable).with_name("gainproof")
    done = subprocess.run(
        [program, "derive", "least-squares-mean"],
        capture_output=True,
        text=True,
        check=False,
        cwd=tmp_path,
        env={**os.environ, "GAINPROOF_CACHE": str(tmp_path / "cache")},
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no device that is full")
def test_an_output_that_takes_no_more_is_named() -> None:
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "gainproof", "campaign"],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
    assert done.returncode == 2
    assert done.stderr.startswith("gainproof: the output cannot be written: ")
    assert done.stderr.count("\n") == 1


def test_messages_do_not_steer_the_terminal(capsys: Capture) -> None:
    """Names are quoted as they came, but for signs that are commands to a terminal."""
    assert cli.main(["check", "no\x1b[31m\u79d2.toml"]) == 2
    assert capsys.readouterr().err.startswith("gainproof: no\\x1b[31m\u79d2.toml: cannot be read")
    with pytest.raises(SystemExit):
        cli.main(["check", "--xx\x1b[31m"])
    assert "--xx\\x1b[31m" in capsys.readouterr().err


def test_a_reader_that_stops_early_is_no_error() -> None:
    command = f"{sys.executable} -m gainproof derive random-velocity --steps | head -1"
    done = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
    assert done.stdout.startswith("Random velocity")
    assert done.stderr == ""


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX systems")
@pytest.mark.parametrize(
    "number", [signal.SIGINT, pytest.param(signal.SIGTERM, marks=pytest.mark.thorough)]
)
def test_an_interrupted_run_leaves_no_half_written_file(
    number: signal.Signals, tmp_path: Path
) -> None:
    """The real program, interrupted while its workers derive: status 130, nothing written."""
    # a job in the background of a shell ignores interrupts, and so does what it starts
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    process = subprocess.Popen(
        [sys.executable, "-m", "gainproof", "run", "--fresh", "--report", str(tmp_path / "report")],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        bufsize=0,  # the lines after the first are left to be read below
        env={**os.environ, "GAINPROOF_CACHE": str(tmp_path / "cache")},
    )
    signal.signal(signal.SIGINT, before)
    assert process.stderr is not None
    # the first word of what is done: however slow the start was, others are at work by then
    first = process.stderr.readline()
    process.send_signal(number)
    _, errors = process.communicate(timeout=LONGEST_WAIT)
    assert first.startswith(b"["), first + errors
    assert process.returncode == 130, errors
    assert errors.decode().splitlines()[-1] == "gainproof: interrupted", errors.decode()
    assert not (tmp_path / "report").exists()
    for path in (tmp_path / "cache").glob("*"):
        json.loads(path.read_bytes().partition(b"\n")[2])


def test_every_command_module_documents_itself() -> None:
    for name, module in cli.COMMANDS.items():
        assert isinstance(module, ModuleType)
        assert module.HELP, name
        assert module.DESCRIPTION, name
