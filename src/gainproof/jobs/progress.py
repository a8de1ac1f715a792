"""Progress on standard error: one line for each thing done, so that logs read like terminals."""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass, field

EVERY = 2.0
"""Seconds between lines about work that goes on."""


@dataclass
class Progress:
    """Lines `[seconds since start] what`; nothing when `quiet`."""

    quiet: bool = False
    start: float = field(default_factory=time.monotonic)
    _last: float = 0.0

    def say(self, text: str) -> None:
        """What is done."""
        if not self.quiet:
            print(f"[{self.elapsed():5.1f} s] {text}", file=sys.stderr, flush=True)
        self._last = self.elapsed()

    def say_sometimes(self, text: str) -> None:
        """How far something is, if nothing was said for a while."""
        if self.elapsed() - self._last >= EVERY:
            self.say(text)

    def elapsed(self) -> float:
        """Seconds since the start."""
        return time.monotonic() - self.start
