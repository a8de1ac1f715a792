"""What the system does not give: memory, open files, processes; in words for people."""

from __future__ import annotations

import errno
from collections.abc import Iterator, Mapping

MEMORY = "there is not enough memory for this (a limit as of `ulimit -v`?)"
FILES = "too many files are open for this (a limit as of `ulimit -n`?)"
PROCESSES = "the system starts no more processes or threads (a limit as of `ulimit -u` or `-v`?)"
SIGNS = {
    "MemoryError": MEMORY,
    "failed to map segment": MEMORY,
    "annot allocate memory": MEMORY,
    # as FLINT and GMP say before they end the process
    "nable to allocate memory": MEMORY,
    "annot reallocate memory": MEMORY,
    # compiled modules say no more where their first objects find no room
    "error return without exception set": MEMORY,
    "returned NULL without setting an exception": MEMORY,
    "Too many open files": FILES,
    "the process ended with status -9": "the process was killed, as systems do for lack of memory",
    "Resource temporarily unavailable": PROCESSES,
    "can't start new thread": PROCESSES,
}
"""By the words that a process which ended has left."""
_NUMBERS: Mapping[int | None, str] = {
    errno.ENOMEM: MEMORY,
    errno.EMFILE: FILES,
    errno.ENFILE: FILES,
    errno.EAGAIN: PROCESSES,
}


def lack(error: BaseException) -> str | None:
    """What an error comes from, if from a lack, by its type and number: words of the input may
    stand in any message. The errors behind it count too.
    """
    return next(filter(None, map(_lack_of, _chain(error))), None)


def _lack_of(error: BaseException) -> str | None:
    match error:
        case MemoryError():
            return MEMORY
        case OSError():
            return _NUMBERS.get(error.errno)
        case RuntimeError() if str(error).startswith("can't start new thread"):
            return PROCESSES
        case ImportError() if "failed to map segment" in str(error):
            return MEMORY
        case SystemError() if str(error).endswith(("exception set", "setting an exception")):
            return MEMORY
    return None


def lack_in(text: str) -> str | None:
    """The same of the last words of a process."""
    return next((words for sign, words in SIGNS.items() if sign in text), None)


def _chain(error: BaseException | None) -> Iterator[BaseException]:
    seen: set[int] = set()
    while error is not None and id(error) not in seen:
        seen.add(id(error))
        yield error
        error = error.__cause__ or error.__context__
