"""Commands as the documentation shows them: ours run here, what they are piped into in a shell."""

from __future__ import annotations

import contextlib
import io
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

from gainproof import cli

PYTHON = re.compile(r"python -c '([^']*)'")
OWN = re.compile(r"(gainproof (?:[^|<>&;$*`']|'[^']*')*?)(?: \| (.*))?")


def run(command: str, folder: Path) -> tuple[str, str]:
    """What the command writes to standard output and to standard error, in this folder."""
    program, own = PYTHON.fullmatch(command), OWN.fullmatch(command)
    if program is None and own is None:
        return _in_a_shell(command, folder)
    out, errors = io.StringIO(), io.StringIO()
    streams = contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors)
    with contextlib.chdir(folder), streams[0], streams[1]:
        if program is not None:
            exec(program[1], {})  # noqa: S102 (a line of our own documentation)
        elif own is not None:
            cli.main(shlex.split(own[1])[1:])
    if own is None or own[2] is None:
        return out.getvalue(), errors.getvalue()
    filtered, more = _in_a_shell(own[2], folder, out.getvalue())
    return filtered, errors.getvalue() + more


def _in_a_shell(command: str, folder: Path, given: str = "") -> tuple[str, str]:
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    environment = {**os.environ, "PATH": path}
    done = subprocess.run(
        command, shell=True, capture_output=True, text=True, check=False, cwd=folder,
        env=environment, input=given,
    )  # fmt: skip
    return done.stdout, done.stderr
