"""Limits that the system keeps for a process that judges: memory, and processor time."""

from __future__ import annotations

import math
import sys
import time
from pathlib import Path

MEMORY = 4 << 30
"""Bytes of address space that a process may take."""
LIMITED = sys.platform.startswith(("linux", "freebsd"))
"""Whether there are limits: other systems have none, or accept them and do not keep them."""
GROWN = 512 << 20
"""Bytes of memory that a claim may take of its process without leaving others short of it."""
UNLIMITED_NOTE = (
    "this system does not limit the memory of a process: "
    "a claim may take all there is until its time is over"
)


def limit_memory() -> None:
    """For the rest of this process, where the system can."""
    if LIMITED:
        import resource

        _limit(resource.RLIMIT_AS, MEMORY)


def limit_time(seconds: float) -> None:
    """Processor time from now on, with a little to spare: whoever waits for this process looks at
    the clock and ends it before, unless it was ended itself.
    """
    if LIMITED:
        import resource

        _limit(resource.RLIMIT_CPU, math.ceil(time.process_time() + max(0.0, seconds)) + 2)


def most_memory() -> int:
    """Bytes of memory that this process had at most so far; 0 where nothing is limited.

    What `getrusage` tells may count in what the process had that started this one, beside which
    the growth of a small process does not show: Linux says what it is since the program began.
    """
    if not LIMITED:
        return 0
    try:
        status = Path("/proc/self/status").read_text(encoding="ascii", errors="replace")
    except OSError:
        status = ""
    for line in status.splitlines():
        if line.startswith("VmHWM:"):
            return int(line.split()[1]) << 10
    import resource

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def _limit(what: int, most: int) -> None:
    """The limit, or the lower one that the process was started with."""
    import resource

    _, highest = resource.getrlimit(what)
    if highest != resource.RLIM_INFINITY:
        most = min(most, highest)
    resource.setrlimit(what, (most, highest))
