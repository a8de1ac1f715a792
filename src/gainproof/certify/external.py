"""Another program run on a file that is written for it, in a folder that is removed again."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter


@dataclass(frozen=True)
class Answer:
    """Exit status (None: time ran out), what was printed on both streams, and the seconds."""

    status: int | None
    text: str
    seconds: float


def ask(command: Sequence[str], name: str, text: str, limit: float) -> Answer:
    """Run a command on a file of this name and text, at most `limit` seconds."""
    start = perf_counter()
    with TemporaryDirectory(prefix="gainproof-certify-") as folder:
        Path(folder, name).write_text(text, encoding="utf-8")
        try:
            done = subprocess.run(
                [*command, name],
                cwd=folder,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                encoding="utf-8",
                errors="replace",
                timeout=limit,
                check=False,
            )
        except subprocess.TimeoutExpired:
            return Answer(None, "", perf_counter() - start)
    return Answer(done.returncode, done.stdout, perf_counter() - start)


def found(program: str) -> bool:
    """Whether a program is installed."""
    return shutil.which(program) is not None
