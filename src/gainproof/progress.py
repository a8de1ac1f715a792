"""Progress on standard error: one line for each thing done, so that logs read like terminals."""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Progress:
    """Lines `[seconds since start] what`; nothing when `quiet`."""

    quiet: bool = False
    start: float = field(default_factory=time.monotonic)

    def say(self, text: str) -> None:
        if not self.quiet:
            print(f"[{self.elapsed():5.1f} s] {text}", file=sys.stderr, flush=True)

    def elapsed(self) -> float:
        """Seconds since the start."""
        return time.monotonic() - self.start
