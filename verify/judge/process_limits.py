"""Limits that the system keeps for a process that judges: memory, and processor time."""

from __future__ import annotations

import signal
import sys
from pathlib import Path

MEMORY = 4 << 30
"""Bytes of address space that a process may take."""
LIMITED = sys.platform.startswith(("linux", "freebsd"))
"""Whether memory is limited: other systems have no such limit, or accept and do not keep it."""
TIMED = hasattr(signal, "setitimer")
"""Whether processor time is limited: not on Windows."""
LEAST = 1e-6
"""Seconds to which a system can limit processor time."""
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

        most = MEMORY
        _, highest = resource.getrlimit(resource.RLIMIT_AS)
        if highest != resource.RLIM_INFINITY:
            most = min(most, highest)
        resource.setrlimit(resource.RLIMIT_AS, (most, highest))


def limit_time(seconds: float | None) -> None:
    """Processor time from now on, after which the system ends this process, in whatever code it is;
    None lifts the limit. Whether it ended so is told by `out_of_time`.
    """
    if sys.platform != "win32":
        signal.signal(signal.SIGPROF, signal.SIG_DFL)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGPROF])
        signal.setitimer(signal.ITIMER_PROF, 0.0 if seconds is None else max(seconds, LEAST))


def out_of_time(exit_code: int | None) -> bool:
    """Whether a process that ended so had used up its processor time."""
    return sys.platform != "win32" and exit_code == -signal.SIGPROF


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
