"""What a campaign says while it runs: each line at once, also where the output is a file."""

from __future__ import annotations

import sys


def say(line: str) -> None:
    """A line of the result, on standard output."""
    sys.stdout.write(line + "\n")
    sys.stdout.flush()


def tell(line: str, last: bool = True) -> None:
    """Progress, on standard error: written over in a terminal unless `last`, in a file a line."""
    terminal = sys.stderr.isatty()
    sys.stderr.write(f"\r\x1b[K{line}" if terminal else line)
    sys.stderr.write("\n" if last or not terminal else "")
    sys.stderr.flush()
